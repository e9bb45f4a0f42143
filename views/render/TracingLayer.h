// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/render/GlResources.h"

namespace espalier {

/// Draws the picture behind the tree that somebody draws after.
class TracingLayer {
public:
    explicit TracingLayer(Gl& gl);
    ~TracingLayer();

    /// At the end of all depths, so that whatever is there hides it. The frame's uniforms must be bound.
    /// Draws nothing if there is no such picture.
    void draw(const TracingImage& tracing, const Camera& camera);

private:
    void load(const QString& file);

    Gl& m_gl;
    GlTexture m_texture;
    GlVertexArray m_noVertices;
    std::unique_ptr<QOpenGLShaderProgram> m_program;
    QString m_file;        ///< That was loaded last
    float m_aspect = 0.0F; ///< Width / height; 0 if there is no picture
};

} // namespace espalier
