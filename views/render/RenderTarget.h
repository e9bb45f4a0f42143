// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/GlResources.h"

#include <QSize>

#include <optional>

namespace espalier {

/// Where a picture is drawn: colour and depth, readable as textures afterwards. Several passes may be drawn,
/// each a little beside the others; the picture is their mean, so that it gets smoother from pass to pass.
class RenderTarget {
public:
    explicit RenderTarget(Gl& gl);
    ~RenderTarget();

    /// Makes it ready for a pass to be drawn into.
    void begin(const QSize& size);
    /// Pass number @p pass has been drawn: the picture is now the mean of all from 0 to that.
    void finish(int pass);

    const QSize& size() const { return m_size; }
    /// Of the last pass.
    GLuint depthTexture() const { return m_buffers->depth.get(); }
    /// Holds the picture.
    GLuint framebuffer() const { return m_buffers->framebuffer.get(); }
    QImage readImage() const;

private:
    struct Buffers {
        explicit Buffers(Gl& gl) : framebuffer(gl), colour(gl), depth(gl), meanFramebuffer(gl), mean(gl) {}
        GlFramebuffer framebuffer;
        GlTexture colour;
        GlTexture depth;
        GlFramebuffer meanFramebuffer;
        GlTexture mean;
    };

    void make(const QSize& size);
    void copy(GLuint from, GLuint to);

    Gl& m_gl;
    std::optional<Buffers> m_buffers;
    GlVertexArray m_noVertices;
    std::unique_ptr<QOpenGLShaderProgram> m_copyProgram;
    QSize m_size;
};

} // namespace espalier
