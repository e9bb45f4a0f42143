// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/RenderTarget.h"

#include <algorithm>

namespace espalier {

void RenderTarget::begin(const QSize& size, int samples)
{
    if (size != m_size || !m_buffers)
        make(size);
    GLint most = 1;
    m_gl.glGetIntegerv(GL_MAX_SAMPLES, &most);
    m_samples = std::clamp(samples, 1, std::max(most, 1));
    if (m_samples > 1 && (!m_sampleBuffers || m_madeSamples != m_samples))
        makeSamples(m_samples);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER,
                           m_samples > 1 ? m_sampleBuffers->framebuffer.get() : framebuffer());
    m_gl.glViewport(0, 0, size.width(), size.height());
}

void RenderTarget::make(const QSize& size)
{
    m_size = size;
    m_sampleBuffers.reset();
    m_buffers.emplace(m_gl);
    const auto texture = [&](const GlTexture& name, GLint internalFormat, GLenum format, GLenum type) {
        m_gl.glBindTexture(GL_TEXTURE_2D, name.get());
        m_gl.glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, size.width(), size.height(), 0, format, type,
                          nullptr);
        for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
            m_gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
        for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
            m_gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    };
    texture(m_buffers->colour, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    texture(m_buffers->depth, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_buffers->colour.get(),
                                0);
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_buffers->depth.get(),
                                0);
}

void RenderTarget::makeSamples(int samples)
{
    m_madeSamples = samples;
    m_sampleBuffers.emplace(m_gl);
    const auto store = [&](const GlRenderbuffer& name, GLenum format) {
        m_gl.glBindRenderbuffer(GL_RENDERBUFFER, name.get());
        m_gl.glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, m_size.width(),
                                              m_size.height());
    };
    store(m_sampleBuffers->colour, GL_RGBA8);
    store(m_sampleBuffers->depth, GL_DEPTH_COMPONENT24);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_sampleBuffers->framebuffer.get());
    m_gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                                   m_sampleBuffers->colour.get());
    m_gl.glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                                   m_sampleBuffers->depth.get());
}

void RenderTarget::resolve()
{
    if (m_samples == 1)
        return;
    m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, m_sampleBuffers->framebuffer.get());
    m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer());
    m_gl.glBlitFramebuffer(0, 0, m_size.width(), m_size.height(), 0, 0, m_size.width(), m_size.height(),
                           GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

QImage RenderTarget::readImage() const
{
    QImage image(m_size, QImage::Format_RGBA8888_Premultiplied);
    m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer());
    m_gl.glPixelStorei(GL_PACK_ALIGNMENT, 4);
    m_gl.glReadPixels(0, 0, m_size.width(), m_size.height(), GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
    return image.mirrored();
}

} // namespace espalier
