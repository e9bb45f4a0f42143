// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/RenderTarget.h"

#include <QOpenGLShaderProgram>

namespace espalier {

RenderTarget::RenderTarget(Gl& gl)
    : m_gl(gl), m_noVertices(gl), m_copyProgram(loadProgram("screen.vert", "copy.frag"))
{
    m_copyProgram->bind();
    m_copyProgram->setUniformValue("image", 0);
}

RenderTarget::~RenderTarget() = default;

void RenderTarget::begin(const QSize& size)
{
    if (size != m_size || !m_buffers)
        make(size);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
    m_gl.glViewport(0, 0, size.width(), size.height());
}

void RenderTarget::make(const QSize& size)
{
    m_size = size;
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
    const auto attach = [&](GLenum where, const GlTexture& name) {
        m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, where, GL_TEXTURE_2D, name.get(), 0);
    };
    texture(m_buffers->colour, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    texture(m_buffers->depth, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT);
    texture(m_buffers->mean, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_buffers->meanFramebuffer.get());
    attach(GL_COLOR_ATTACHMENT0, m_buffers->mean);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer());
    attach(GL_COLOR_ATTACHMENT0, m_buffers->colour);
    attach(GL_DEPTH_ATTACHMENT, m_buffers->depth);
}

void RenderTarget::copy(GLuint from, GLuint to)
{
    m_gl.glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    m_gl.glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    m_gl.glBlitFramebuffer(0, 0, m_size.width(), m_size.height(), 0, 0, m_size.width(), m_size.height(),
                           GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void RenderTarget::finish(int pass)
{
    if (pass == 0) {
        copy(framebuffer(), m_buffers->meanFramebuffer.get());
        return;
    }
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_buffers->meanFramebuffer.get());
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendColor(0.0F, 0.0F, 0.0F, 1.0F / static_cast<float>(pass + 1));
    m_gl.glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_buffers->colour.get());
    m_copyProgram->bind();
    m_gl.glBindVertexArray(m_noVertices.get());
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.glDisable(GL_BLEND);
    copy(m_buffers->meanFramebuffer.get(), framebuffer());
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
