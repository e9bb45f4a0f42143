// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/camera/Camera.h"
#include "views/render/FrameUniforms.h"
#include "views/render/RenderOptions.h"
#include "views/render/RenderTarget.h"
#include "views/render/TracingLayer.h"
#include "views/render/TreeBuffers.h"
#include "views/render/TreeShadows.h"

#include <memory>

namespace espalier {

class TreeScene;

/// Draws a tree with its ground and its light into a RenderTarget (TreeSketch §3.5). It belongs to one OpenGL
/// context, which must be current during each call, and follows one scene.
class Renderer {
public:
    explicit Renderer(Gl& gl);
    ~Renderer();

    /// Draws @p scene as seen by @p camera, whose view size is the picture's in pixels. Takes the scene's
    /// changes and sends only those to the card.
    void render(TreeScene& scene, const Camera& camera, const RenderOptions& options, RenderTarget& target);
    /// Draws one of the passes, 0...options.samples − 1 in that order; after each pass the target has a
    /// picture.
    void renderPass(TreeScene& scene, const Camera& camera, const RenderOptions& options,
                    RenderTarget& target, int pass);

    /// The frame's uniforms, which stay bound after render() for overlays.
    const FrameUniforms& frame() const { return m_frame; }
    /// Binds the uniforms of an earlier frame, for overlays over its picture.
    void bindFrame(const FrameUniforms& frame);
    Gl& gl() const { return m_gl; }

private:
    void updateShadows(const TreeScene& scene, const Camera& camera, const RenderOptions& options);
    void fillFrame(const TreeScene& scene, const Camera& camera, const RenderOptions& options,
                   const QSize& size, int pass);
    void drawBackground();
    /// @p hides: whether the ground hides what is below it.
    void drawGround(bool hides);
    void drawTracing(const Camera& camera, const RenderOptions& options);
    /// @p saturation of the leaves, 0...1.
    void drawTree(const RenderOptions& options, float saturation);
    void setFeet(const TreeScene& scene);
    void sendFrame();
    void bindTexture(int unit, GLenum kind, GLuint texture);

    Gl& m_gl;
    TreeBuffers m_tree;
    TreeShadows m_shadows;
    TracingLayer m_tracing;
    GlVertexArray m_noVertices;
    GlBuffer m_uniformBuffer;
    FrameUniforms m_frame;
    std::unique_ptr<QOpenGLShaderProgram> m_barkProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_leafProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_plainBarkProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_plainLeafProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_fibreProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_shadowProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_leafShadowProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_backgroundProgram;
    std::unique_ptr<QOpenGLShaderProgram> m_groundProgram;

    struct ShadowState {
        Vec3 sun = Vec3::Zero();
        bool leaves = true;
        float groundRadius = 0.0F;
        bool operator==(const ShadowState&) const = default;
    };
    ShadowState m_shadowState;
    bool m_shadowsAreOld = true;
    bool m_hasShadows = false;       ///< Shadows of the scene were made, be they old
    std::uint64_t m_sceneNumber = 0; ///< Of the last scene drawn
};

} // namespace espalier
