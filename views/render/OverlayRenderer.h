// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"
#include "views/render/GlResources.h"
#include "views/render/Overlay.h"

#include <memory>

namespace espalier {

/// Draws an overlay over a picture, using the picture's depth. The frame's uniforms of that picture must
/// still be bound.
class OverlayRenderer {
public:
    explicit OverlayRenderer(Gl& gl);
    ~OverlayRenderer();

    /// Draws into the part @p part of the bound framebuffer, pixels counted from its lower left corner, that
    /// shows the picture; @p pixelRatio pixels are a device-independent one.
    void render(const Overlay& overlay, const Camera& camera, GLuint sceneDepth, const QRect& part,
                double pixelRatio);

private:
    /// One straight piece of a line.
    struct Segment {
        std::array<float, 3> from;
        std::array<float, 3> to;
        float path; ///< Length of the line before it, px
    };

    void drawGrids(const Overlay& overlay);
    void drawSpheres(const Overlay& overlay, const Camera& camera, float pixelRatio);
    void drawSurfaces(const Overlay& overlay);
    void drawLines(const Overlay& overlay, const Camera& camera, float pixelRatio);
    void drawDots(const Overlay& overlay, float pixelRatio);

    Gl& m_gl;
    std::unique_ptr<QOpenGLShaderProgram> m_gridProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_sphereProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_surfaceProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_lineProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_dotProgram;
    GlVertexArray m_noVertices;
    GlVertexArray m_surfaceVertices;
    GlVertexArray m_lineVertices;
    GlVertexArray m_dotVertices;
    GlBuffer m_surfaceBuffer;
    GlBuffer m_lineBuffer;
    GlBuffer m_dotBuffer;
    std::vector<Segment> m_segments;
    std::shared_ptr<const EnvelopeMesh> m_surface; ///< The surface that the buffer holds
};

} // namespace espalier
