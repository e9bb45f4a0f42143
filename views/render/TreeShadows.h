// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/GlResources.h"

#include <functional>

namespace espalier {

/// The matrix, from world to clip space, of a camera infinitely far away in the direction @p toward (unit),
/// whose picture just contains @p box.
Matrix4 parallelProjection(const Box3& box, const Vec3& toward);
/// Matrix from clip space (−1...1) to texture coordinates and depth (0...1).
Matrix4 textureFromClip();

/// The shadow map of the sun (hard shadows within the tree), and the blurred shadows of the tree and its
/// crown on the ground.
class TreeShadows {
public:
    static constexpr int kMapEdge = 2048;
    static constexpr int kGroundEdge = 512; ///< Edge of the sharpest ground texture, px

    explicit TreeShadows(Gl& gl);
    ~TreeShadows();

    /// Draws what casts shadows with a matrix from the world to clip space.
    using Draw = std::function<void(const Matrix4& clipFromWorld)>;
    /// @p bounds: of the tree, m; @p sun: direction toward it; @p groundRadius: half the edge of the square
    /// that the ground's texture covers, m; @p drawRoughly: draws an approximation, for blurred shadows.
    void render(const Box3& bounds, const Vec3& sun, float groundRadius, const Draw& draw,
                const Draw& drawRoughly);

    const Matrix4& shadowFromWorld() const { return m_shadowFromWorld; }
    /// Edge of a texel, m.
    float texelEdge() const { return m_texelEdge; }
    GLuint map() const { return m_map.get(); }
    /// Red: 1 in the shadow of parts near the ground.
    GLuint sharpGround() const { return m_sharp.first.texture.get(); }
    /// Green: 1 in the shadow of parts farther up.
    GLuint softGround() const { return m_soft.first.texture.get(); }
    /// Blue: 1 under a closed crown.
    GLuint skyGround() const { return m_sky.first.texture.get(); }

private:
    struct Surface {
        Surface(Gl& gl, int pixels) : framebuffer(gl), texture(gl), edge(pixels) {}
        GlFramebuffer framebuffer;
        GlTexture texture;
        int edge; ///< px
    };
    /// The two surfaces that a blur alternates between; the first has the result.
    struct Pair {
        Pair(Gl& gl, int edge) : first(gl, edge), second(gl, edge) {}
        Surface first;
        Surface second;
    };

    void makeSurface(const Surface& surface);
    void shadeGround(const Matrix4& coverageFromWorld, float groundRadius, float height);
    void blur(const Surface& from, const Pair& to, float sigma);

    Gl& m_gl;
    GlTexture m_map;
    GlFramebuffer m_mapFramebuffer;
    Surface m_coverage;
    Surface m_ground; ///< The ground's shadow before it is blurred
    Pair m_sharp;
    Pair m_soft;
    Pair m_sky;
    GlVertexArray m_noVertices;
    std::unique_ptr<QOpenGLShaderProgram> m_groundProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_blurProgram;
    Matrix4 m_shadowFromWorld = Matrix4::Identity();
    float m_depthPerMetre = 1.0F;
    float m_texelEdge = 0.01F;
};

} // namespace espalier
