// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/render/GlResources.h"

namespace espalier {

/// Draws the tracing image behind the tree.
class TracingLayer {
public:
    explicit TracingLayer(Gl& gl);
    ~TracingLayer();

    /// Draws at the greatest depth, so that everything else hides it. The frame's uniforms must be bound.
    /// Draws nothing if there is no tracing image.
    void draw(const TracingImage& tracing, const Camera& camera);

private:
    void load(const ImageAsset& asset);

    Gl& m_gl;
    GlTexture m_texture;
    GlVertexArray m_noVertices;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    ImageAsset m_image;    ///< The image that was loaded last
    float m_aspect = 0.0F; ///< Width / height; 0 if there is no picture
};

} // namespace espalier
