// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/Renderer.h"

#include "views/render/TreeScene.h"

#include <QOpenGLShaderProgram>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

// Units of the shaders' textures.
constexpr int kLightUnit = 0;
constexpr int kShadowUnit = 1;
constexpr int kColourUnit = 2;
constexpr int kNormalUnit = 3;

using Vector = FrameUniforms::Vector;

/// The light of one backdrop; colours are linear, but those of the background, which are shown as they are.
struct Lighting {
    Vector sun;
    Vector sky;
    Vector ground; ///< Light from below
    Vector rim;
    Vector backgroundInner;
    Vector backgroundOuter;
    Vector groundAlbedo;
    float leastAmbient;  ///< a_min
    float lightExponent; ///< γ
    float exposure;
};

constexpr Vector displayed(int red, int green, int blue, float last)
{
    return {static_cast<float>(red) / 255.0F, static_cast<float>(green) / 255.0F,
            static_cast<float>(blue) / 255.0F, last};
}

constexpr Lighting kStudio{
    .sun = {2.65F, 2.35F, 1.88F, 0.0F},
    .sky = {0.58F, 0.66F, 0.78F, 0.0F},
    .ground = {0.24F, 0.22F, 0.20F, 0.0F},
    .rim = {0.16F, 0.20F, 0.26F, 0.0F},
    .backgroundInner = displayed(58, 66, 77, 0.0F),
    .backgroundOuter = displayed(32, 36, 43, 0.0F),
    .groundAlbedo = {0.026F, 0.032F, 0.042F, 0.0F},
    .leastAmbient = 0.22F,
    .lightExponent = 1.4F,
    .exposure = 0.85F,
};

constexpr Lighting kHorizon{
    .sun = {3.0F, 2.75F, 2.35F, 0.0F},
    .sky = {0.78F, 0.88F, 1.02F, 0.0F},
    .ground = {0.42F, 0.40F, 0.36F, 0.0F},
    .rim = {0.0F, 0.0F, 0.0F, 0.0F},
    .backgroundInner = displayed(226, 230, 232, 1.0F),
    .backgroundOuter = displayed(150, 178, 206, 1.0F),
    .groundAlbedo = {0.30F, 0.29F, 0.27F, 0.0F},
    .leastAmbient = 0.3F,
    .lightExponent = 1.0F,
    .exposure = 0.9F,
};

Vector toVector(const Vec3& vector, float last)
{
    return {vector.x(), vector.y(), vector.z(), last};
}

FrameUniforms::Matrix toMatrix(const Matrix4& matrix)
{
    FrameUniforms::Matrix numbers;
    std::copy_n(matrix.data(), numbers.size(), numbers.begin());
    return numbers;
}

Vec3 towardSun(const ViewValues& view)
{
    const double level = std::cos(view.sunElevation);
    return Vec3(static_cast<float>(level * std::sin(view.sunAzimuth)),
                static_cast<float>(std::sin(view.sunElevation)),
                static_cast<float>(level * std::cos(view.sunAzimuth)))
        .normalized();
}

/// The ground reaches well beyond the tree, its shadow included, and beyond a seedling's view.
float groundRadius(const Box3& bounds)
{
    constexpr float kLeast = 5.5F;
    const Vec3 reach = bounds.max().cwiseMax(-bounds.min());
    return std::max(kLeast, 1.5F * std::max({reach.x(), reach.y(), reach.z()}));
}

bool isTransparent(const RenderOptions& options)
{
    return options.background && options.background->alpha() == 0;
}

} // namespace

Renderer::Renderer(Gl& gl)
    : m_gl(gl),
      m_tree(gl),
      m_shadows(gl),
      m_noVertices(gl),
      m_uniformBuffer(gl),
      m_barkProgram(loadProgram("bark.vert", "bark.frag")),
      m_leafProgram(loadProgram("leaf.vert", "leaf.frag")),
      m_shadowProgram(loadProgram("shadow.vert", "shadow.frag")),
      m_leafShadowProgram(loadProgram("leafshadow.vert", "leafshadow.frag")),
      m_backgroundProgram(loadProgram("screen.vert", "background.frag")),
      m_groundProgram(loadProgram("ground.vert", "ground.frag"))
{
    m_uniformBuffer.reserve(sizeof(FrameUniforms));
    for (QOpenGLShaderProgram* program : {m_barkProgram.get(), m_leafProgram.get(), m_groundProgram.get()}) {
        program->bind();
        program->setUniformValue("lightVolume", kLightUnit);
        program->setUniformValue("shadowMap", kShadowUnit);
        program->setUniformValue("groundShadow", kColourUnit);
        program->setUniformValue("barkColour", kColourUnit);
        program->setUniformValue("barkNormal", kNormalUnit);
        program->setUniformValue("leafColour", kColourUnit);
        program->setUniformValue("leafNormals", kNormalUnit);
    }
    m_leafShadowProgram->bind();
    m_leafShadowProgram->setUniformValue("leafColour", kColourUnit);
}

Renderer::~Renderer() = default;

void Renderer::render(TreeScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderTarget& target)
{
    const QSize size(static_cast<int>(camera.viewSize().width()),
                     static_cast<int>(camera.viewSize().height()));
    scene.prepare();
    m_shadowsAreOld = m_tree.follow(scene) || m_shadowsAreOld;
    if (options.view.shadowsShown && options.shadowStrength > 0.0)
        updateShadows(scene, options);
    fillFrame(scene, camera, options, size);

    target.begin(size, options.samples);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDepthMask(GL_TRUE);
    drawBackground(options);
    bindTexture(kLightUnit, GL_TEXTURE_3D, m_tree.lightVolume());
    bindTexture(kShadowUnit, GL_TEXTURE_2D, m_shadows.map());
    m_gl.glEnable(GL_DEPTH_TEST);
    if (options.view.groundShown)
        drawGround();
    drawTree(options, target.samples() > 1);
    target.resolve();
}

void Renderer::updateShadows(const TreeScene& scene, const RenderOptions& options)
{
    const ShadowState state{towardSun(options.view), options.view.leavesShown, groundRadius(scene.bounds())};
    if (!m_shadowsAreOld && state == m_shadowState)
        return;
    const auto bindForWood = [this](const Matrix4& clipFromWorld) {
        m_shadowProgram->bind();
        setMatrix(*m_shadowProgram, "clipFromWorld", clipFromWorld);
    };
    const auto draw = [&](const Matrix4& clipFromWorld) {
        bindForWood(clipFromWorld);
        m_tree.drawBark();
        if (!state.leaves)
            return;
        bindTexture(kColourUnit, GL_TEXTURE_2D, m_tree.leafColour());
        m_leafShadowProgram->bind();
        setMatrix(*m_leafShadowProgram, "clipFromWorld", clipFromWorld);
        m_tree.drawLeaves();
    };
    // Where there are leaves, there are twigs.
    const auto drawRoughly = [&](const Matrix4& clipFromWorld) {
        bindForWood(clipFromWorld);
        m_gl.glPointSize(state.leaves ? 3.0F : 1.0F);
        m_tree.drawBarkPoints();
    };
    m_shadows.render(scene.bounds(), state.sun, state.groundRadius, draw, drawRoughly);
    m_shadowState = state;
    m_shadowsAreOld = false;
}

void Renderer::fillFrame(const TreeScene& scene, const Camera& camera, const RenderOptions& options,
                         const QSize& size)
{
    const Lighting& lighting = options.view.backdrop == Backdrop::Horizon ? kHorizon : kStudio;
    const Box3& bounds = scene.bounds();
    const float radius = groundRadius(bounds);
    const Vec3 eye = camera.position();

    // As near as the tree lets it be, for the sake of the depth buffer; as far as the ground goes.
    const float nearest =
        std::max(0.02F * camera.distance(), 0.4F * std::sqrt(bounds.squaredExteriorDistance(eye)));
    const float farthest = nearest + eye.norm() + 1.5F * radius + bounds.diagonal().norm();
    const Matrix4 viewProjection = camera.projectionMatrix(nearest, farthest) * camera.viewMatrix();

    const bool shadows = options.view.shadowsShown && !m_shadowsAreOld;
    FrameUniforms& frame = m_frame;
    frame.viewProjection = toMatrix(viewProjection);
    frame.inverseViewProjection = toMatrix(viewProjection.inverse());
    frame.shadowFromWorld = toMatrix(m_shadows.shadowFromWorld());
    frame.eye = toVector(eye, 1.0F / camera.pixelsPerMetre(1.0F));
    frame.sunDirection =
        toVector(towardSun(options.view), shadows ? static_cast<float>(options.shadowStrength) : 0.0F);
    frame.sunColour = lighting.sun;
    frame.skyColour = lighting.sky;
    frame.groundColour = lighting.ground;
    frame.rimColour = lighting.rim;
    const LightGrid& light = scene.light();
    frame.lightOrigin = toVector(light.origin(), m_shadows.texelEdge());
    const Vec3 cells(static_cast<float>(light.size()[0]), static_cast<float>(light.size()[1]),
                     static_cast<float>(light.size()[2]));
    frame.lightScale = toVector((light.cellEdge() * cells).cwiseInverse(), lighting.leastAmbient);
    frame.crown = toVector(bounds.center(), lighting.lightExponent);
    frame.crownRadii = toVector((0.5F * bounds.sizes()).cwiseMax(Vec3::Constant(0.05F)), lighting.exposure);
    const auto width = static_cast<float>(size.width());
    const auto height = static_cast<float>(size.height());
    frame.viewSize = {width, height, 1.0F / width, 1.0F / height};
    frame.backgroundInner = lighting.backgroundInner;
    frame.backgroundOuter = lighting.backgroundOuter;
    if (options.background)
        frame.backgroundInner[3] = isTransparent(options) ? 3.0F : 2.0F;
    frame.ground = lighting.groundAlbedo;
    frame.ground[3] = radius;
    m_uniformBuffer.write(0, &frame, sizeof(frame));
    m_gl.glBindBufferBase(GL_UNIFORM_BUFFER, 0, m_uniformBuffer.name());
}

void Renderer::drawBackground(const RenderOptions& options)
{
    const QColor colour = options.background.value_or(Qt::black);
    m_gl.glClearColor(isTransparent(options) ? 0.0F : colour.redF(),
                      isTransparent(options) ? 0.0F : colour.greenF(),
                      isTransparent(options) ? 0.0F : colour.blueF(), isTransparent(options) ? 0.0F : 1.0F);
    m_gl.glClearDepth(1.0);
    m_gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    if (options.background)
        return;
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);
    m_gl.glBindVertexArray(m_noVertices.get());
    m_backgroundProgram->bind();
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
}

void Renderer::drawGround()
{
    bindTexture(kColourUnit, GL_TEXTURE_2D, m_shadows.groundTexture());
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // From below the ground is not seen and hides nothing.
    m_gl.glDepthMask(m_frame.eye[1] > 0.0F ? GL_TRUE : GL_FALSE);
    m_gl.glBindVertexArray(m_noVertices.get());
    m_groundProgram->bind();
    m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

void Renderer::drawTree(const RenderOptions& options, bool smooth)
{
    bindTexture(kColourUnit, GL_TEXTURE_2D, m_tree.barkColour());
    bindTexture(kNormalUnit, GL_TEXTURE_2D, m_tree.barkNormal());
    m_barkProgram->bind();
    m_barkProgram->setUniformValue("widening", smooth ? 0.2F : 0.4F);
    m_tree.drawBark();
    if (!options.view.leavesShown)
        return;
    bindTexture(kColourUnit, GL_TEXTURE_2D, m_tree.leafColour());
    bindTexture(kNormalUnit, GL_TEXTURE_2D, m_tree.leafNormal());
    m_leafProgram->bind();
    m_leafProgram->setUniformValue("alphaToCoverage", smooth);
    if (smooth) {
        m_gl.glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);
        m_gl.glEnable(GL_SAMPLE_ALPHA_TO_ONE);
    }
    m_tree.drawLeaves();
    m_gl.glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
    m_gl.glDisable(GL_SAMPLE_ALPHA_TO_ONE);
}

void Renderer::bindTexture(int unit, GLenum kind, GLuint texture)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    m_gl.glBindTexture(kind, texture);
}

} // namespace espalier
