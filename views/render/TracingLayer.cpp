// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TracingLayer.h"

#include <QOpenGLShaderProgram>

namespace espalier {

TracingLayer::TracingLayer(Gl& gl)
    : m_gl(gl), m_texture(gl), m_noVertices(gl), m_program(loadProgram("tracing.vert", "tracing.frag"))
{
    m_program->bind();
    m_program->setUniformValue("picture", 0);
}

TracingLayer::~TracingLayer() = default;

void TracingLayer::load(const ImageAsset& asset)
{
    m_image = asset;
    m_aspect = 0.0F;
    const QImage image = asset.pixels();
    if (image.isNull())
        return;
    m_aspect = static_cast<float>(image.width()) / static_cast<float>(image.height());
    // It is shown as it is, so its colours stay as they are.
    m_gl.glActiveTexture(GL_TEXTURE0);
    fillTexture(m_gl, m_texture, image, TextureContent::Data, false);
}

void TracingLayer::draw(const TracingImage& tracing, const Camera& camera)
{
    if (!(tracing.image == m_image))
        load(tracing.image);
    if (m_aspect <= 0.0F || tracing.opacity <= 0.0)
        return;
    const Vec3 centre =
        static_cast<float>(tracing.right) * camera.right() + static_cast<float>(tracing.up) * camera.up();
    const float half = 0.5F * static_cast<float>(tracing.height);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_texture.get());
    m_gl.glBindVertexArray(m_noVertices.get());
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_program->bind();
    setVector(*m_program, "centre", centre);
    setVector(*m_program, "halfRight", half * m_aspect * camera.right());
    setVector(*m_program, "halfUp", half * camera.up());
    m_program->setUniformValue("opacity", static_cast<float>(tracing.opacity));
    m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl.glDisable(GL_BLEND);
}

} // namespace espalier
