// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/GlResources.h"

#include <QSize>

#include <optional>

namespace espalier {

/// The colour and depth that a picture is drawn into, readable as textures afterwards. Several passes can be
/// drawn, each at a small offset from the others; the picture is their mean, so each pass makes it smoother.
class RenderTarget {
public:
    explicit RenderTarget(Gl& gl);
    ~RenderTarget();

    /// Prepares the target for a pass.
    void begin(const QSize& size);
    /// Ends pass number @p pass: the picture is now the mean of all passes from 0 to that one.
    void finish(int pass);

    const QSize& size() const { return m_size; }
    /// Depth of the last pass.
    GLuint depthTexture() const { return m_buffers->depth.get(); }
    /// The framebuffer with the picture.
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
