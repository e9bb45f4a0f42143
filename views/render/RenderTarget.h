// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/GlResources.h"

#include <QSize>

#include <optional>

namespace espalier {

/// Where a picture is drawn: colour and depth, with several samples a pixel or one, and afterwards readable
/// as textures with one.
class RenderTarget {
public:
    explicit RenderTarget(Gl& gl) : m_gl(gl) {}

    /// Makes it ready to be drawn into. @p samples: 1, or as many of them as the card offers.
    void begin(const QSize& size, int samples);
    /// What was drawn is in the textures now.
    void resolve();

    const QSize& size() const { return m_size; }
    /// Samples a pixel that the card gave.
    int samples() const { return m_samples; }
    GLuint depthTexture() const { return m_buffers->depth.get(); }
    /// Holds the resolved picture.
    GLuint framebuffer() const { return m_buffers->framebuffer.get(); }
    QImage readImage() const;

private:
    struct Buffers {
        explicit Buffers(Gl& gl) : framebuffer(gl), colour(gl), depth(gl) {}
        GlFramebuffer framebuffer;
        GlTexture colour;
        GlTexture depth;
    };
    struct SampleBuffers {
        explicit SampleBuffers(Gl& gl) : framebuffer(gl), colour(gl), depth(gl) {}
        GlFramebuffer framebuffer;
        GlRenderbuffer colour;
        GlRenderbuffer depth;
    };

    void make(const QSize& size);
    void makeSamples(int samples);

    Gl& m_gl;
    std::optional<Buffers> m_buffers;
    std::optional<SampleBuffers> m_sampleBuffers;
    QSize m_size;
    int m_samples = 1;
    int m_madeSamples = 1;
};

} // namespace espalier
