// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/Renderer.h"

#include "views/render/Lighting.h"
#include "views/render/Sun.h"
#include "views/render/TreeScene.h"

#include <QOpenGLShaderProgram>

#include <algorithm>
#include <cmath>
#include <functional>

namespace espalier {

namespace {

// Texture units of the shaders.
constexpr int kLightUnit = 0;
constexpr int kShadowUnit = 1;
constexpr int kColourUnit = 2;
constexpr int kSurfaceUnit = 3;
constexpr int kSharpUnit = 2;
constexpr int kSoftUnit = 3;
constexpr int kSkyUnit = 4;

/// The least radius of a trunk's foot, m.
constexpr float kLeastFoot = 0.005F;

using Vector = FrameUniforms::Vector;

/// The place within a pixel through which a pass looks, relative to the pixel's middle, −0.5...0.5; the
/// places of any number of passes are evenly spread (the additive recurrence of Roberts 2018).
Vec2 placeInPixel(int pass)
{
    const auto place = [pass](double step) {
        const double at = 0.5 + step * pass;
        return static_cast<float>(at - std::floor(at) - 0.5);
    };
    return {place(0.7548776662466927), place(0.5698402909980532)};
}

/// The number that a pass adds to the random numbers of leaves, 0...1: evenly spread, too.
float lotOf(int pass)
{
    const double at = 0.6180339887498949 * pass;
    return static_cast<float>(at - std::floor(at));
}

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

/// Radius of the ground: it reaches well beyond the tree and its shadow, and beyond a seedling's view.
float groundRadius(const Box3& bounds)
{
    constexpr float kLeast = 5.5F;
    const Vec3 reach = bounds.max().cwiseMax(-bounds.min());
    return std::max(kLeast, 1.5F * std::max({reach.x(), reach.y(), reach.z()}));
}

/// Radius of the ground that is shown: from far away it still fills the lower part of the picture.
float shownGroundRadius(const Box3& bounds, const Camera& camera)
{
    constexpr float kOfDistance = 0.63F;
    return std::max(groundRadius(bounds), kOfDistance * camera.distance());
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
      m_tracing(gl),
      m_noVertices(gl),
      m_uniformBuffer(gl),
      m_barkProgram(loadProgram("bark.vert", "bark.frag")),
      m_leafProgram(loadProgram("leaf.vert", "leaf.frag")),
      m_plainBarkProgram(loadProgram("bark.vert", "bark.frag", "PLAIN")),
      m_plainLeafProgram(loadProgram("leaf.vert", "leaf.frag", "PLAIN")),
      m_fibreProgram(loadProgram("fibre.vert", "fibre.frag")),
      m_shadowProgram(loadProgram("shadow.vert", "shadow.frag")),
      m_leafShadowProgram(loadProgram("leafshadow.vert", "leafshadow.frag")),
      m_backgroundProgram(loadProgram("screen.vert", "background.frag")),
      m_groundProgram(loadProgram("ground.vert", "ground.frag"))
{
    m_uniformBuffer.reserve(sizeof(FrameUniforms));
    for (QOpenGLShaderProgram* program : {m_barkProgram.get(), m_leafProgram.get(), m_plainBarkProgram.get(),
                                          m_plainLeafProgram.get(), m_groundProgram.get()}) {
        program->bind();
        program->setUniformValue("lightVolume", kLightUnit);
        program->setUniformValue("shadowMap", kShadowUnit);
        program->setUniformValue("sharpShadow", kSharpUnit);
        program->setUniformValue("softShadow", kSoftUnit);
        program->setUniformValue("skyShadow", kSkyUnit);
        program->setUniformValue("barkColour", kColourUnit);
        program->setUniformValue("barkSurface", kSurfaceUnit);
        program->setUniformValue("leafColour", kColourUnit);
        program->setUniformValue("leafSurface", kSurfaceUnit);
    }
    m_leafShadowProgram->bind();
    m_leafShadowProgram->setUniformValue("leafColour", kColourUnit);
}

Renderer::~Renderer() = default;

void Renderer::render(TreeScene& scene, const Camera& camera, const RenderOptions& options,
                      RenderTarget& target)
{
    for (int pass = 0; pass < options.samples; ++pass)
        renderPass(scene, camera, options, target, pass);
}

void Renderer::renderPass(TreeScene& scene, const Camera& camera, const RenderOptions& options,
                          RenderTarget& target, int pass)
{
    const QSize size(static_cast<int>(camera.viewSize().width()),
                     static_cast<int>(camera.viewSize().height()));
    if (!options.isSecond) {
        scene.setPixelSize(1.0 / static_cast<double>(camera.pixelsPerMetre(camera.distance())));
        if (options.mayLag)
            scene.prepareSome();
        else
            scene.prepare();
    }
    m_hasShadows = m_hasShadows && m_sceneNumber == scene.number();
    m_sceneNumber = scene.number();
    m_shadowsAreOld = m_tree.follow(scene) || m_shadowsAreOld;
    if (options.view.shadowsShown && !(options.keepsShadows && m_hasShadows))
        updateShadows(scene, camera, options);
    fillFrame(scene, camera, options, size, pass);

    target.begin(size);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glDepthFunc(GL_LESS);
    m_gl.glDepthMask(GL_TRUE);
    const bool isTransparentNow = isTransparent(options);
    const QColor colour = isTransparentNow ? QColor(Qt::transparent) : options.background.value_or(Qt::black);
    m_gl.glClearColor(colour.redF(), colour.greenF(), colour.blueF(), isTransparentNow ? 0.0F : 1.0F);
    m_gl.glClearDepth(1.0);
    m_gl.glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    bindTexture(kLightUnit, GL_TEXTURE_3D, m_tree.lightVolume());
    bindTexture(kShadowUnit, GL_TEXTURE_2D, m_shadows.map());
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_BLEND);
    drawTree(options, static_cast<float>(std::min(scene.parameters().leaves.saturation, 1.0)));
    // Pixels that the tree covers need not be drawn.
    const bool isTracing = !options.background && !options.view.tracing.image.isNull();
    if (!options.background)
        drawBackground();
    if (m_frame.foot[1] > 0.0F || m_frame.foot[2] > 0.0F)
        drawGround(!isTracing);
    if (isTracing)
        drawTracing(camera, options);
    target.finish(pass);
    // Overlays use the same matrix in all passes, so that they do not tremble.
    m_frame.viewProjection = m_frame.centredViewProjection;
    sendFrame();
}

void Renderer::bindFrame(const FrameUniforms& frame)
{
    m_frame = frame;
    sendFrame();
}

void Renderer::updateShadows(const TreeScene& scene, const Camera& camera, const RenderOptions& options)
{
    const ShadowState state{towardSun(options.view, camera), options.view.leavesShown,
                            groundRadius(scene.bounds())};
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
    // Draws points on the bark, which are larger if there are leaves, instead of the leaves.
    const auto drawRoughly = [&](const Matrix4& clipFromWorld) {
        bindForWood(clipFromWorld);
        m_gl.glPointSize(state.leaves ? 3.0F : 1.0F);
        m_tree.drawBarkPoints();
    };
    m_shadows.render(scene.bounds(), state.sun, state.groundRadius, draw, drawRoughly);
    m_shadowState = state;
    m_shadowsAreOld = false;
    m_hasShadows = true;
}

void Renderer::fillFrame(const TreeScene& scene, const Camera& camera, const RenderOptions& options,
                         const QSize& size, int pass)
{
    const Lighting& lighting = lightingOf(options.view);
    const Box3& bounds = scene.bounds();
    const float radius = shownGroundRadius(bounds, camera);
    const Vec3 eye = camera.position();

    // The near plane is as near as the tree requires, which helps the depth buffer; the far plane is at the
    // end of the ground.
    const float nearest =
        std::max(0.02F * camera.distance(), 0.4F * std::sqrt(bounds.squaredExteriorDistance(eye)));
    const float farthest = nearest + eye.norm() + 1.5F * radius + bounds.diagonal().norm();
    const Matrix4 viewProjection = camera.projectionMatrix(nearest, farthest) * camera.viewMatrix();

    FrameUniforms& frame = m_frame;
    frame.centredViewProjection = toMatrix(viewProjection);
    const Vec2 offset = placeInPixel(pass);
    Matrix4 moved = viewProjection;
    moved.row(0) += 2.0F * offset.x() / static_cast<float>(size.width()) * viewProjection.row(3);
    moved.row(1) += 2.0F * offset.y() / static_cast<float>(size.height()) * viewProjection.row(3);
    frame.viewProjection = toMatrix(moved);
    frame.inverseViewProjection = toMatrix(viewProjection.inverse());
    frame.shadowFromWorld = toMatrix(m_shadows.shadowFromWorld());
    frame.eye = toVector(eye, 1.0F / camera.pixelsPerMetre(1.0F));
    frame.sunDirection = toVector(towardSun(options.view, camera), options.view.shadowsShown ? 1.0F : 0.0F);
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
    const BackdropColours colours = backdropColours(options.view);
    frame.backgroundInner = colours.inner;
    frame.backgroundOuter = colours.outer;
    if (options.background)
        frame.backgroundInner[3] = isTransparent(options) ? 3.0F : 2.0F;
    frame.ground = lighting.groundAlbedo;
    frame.ground[3] = radius;
    frame.groundShadow = {groundRadius(bounds), 0.0F, 0.0F, 0.0F};
    const bool isGridShown = options.view.gridShown && !options.background;
    frame.foot = {0.0F, options.view.groundShown ? 1.0F : 0.0F, isGridShown ? 1.0F : 0.0F, 0.0F};
    setFeet(scene);
    // With several samples a pixel, the textures can be sharper.
    const bool isOnly = options.samples == 1;
    frame.pass = {offset.x(), offset.y(), isOnly ? 0.0F : -0.7F, isOnly ? -1.0F : lotOf(pass)};
    sendFrame();
}

/// Keeps the thickest trunks, as many as the shaders know.
void Renderer::setFeet(const TreeScene& scene)
{
    std::vector<TreeScene::Foot> feet = scene.feet();
    std::ranges::stable_sort(feet, std::greater(), &TreeScene::Foot::radius);
    const std::size_t count = std::min(feet.size(), FrameUniforms::kMostFeet);
    for (std::size_t i = 0; i < count; ++i) {
        const float radius = std::max(feet[i].radius, kLeastFoot);
        m_frame.feet[i] = {feet[i].base.x(), feet[i].base.z(), radius, 0.0F};
    }
    m_frame.foot[0] = std::max(feet.front().radius, kLeastFoot);
    m_frame.foot[3] = static_cast<float>(count);
}

void Renderer::sendFrame()
{
    m_uniformBuffer.write(0, &m_frame, sizeof(m_frame));
    m_gl.glBindBufferBase(GL_UNIFORM_BUFFER, 0, m_uniformBuffer.name());
}

void Renderer::drawBackground()
{
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_FALSE);
    m_gl.glBindVertexArray(m_noVertices.get());
    m_backgroundProgram->bind();
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDepthFunc(GL_LESS);
}

/// Draws over the ground too, which would hide most of the image in a level view.
void Renderer::drawTracing(const Camera& camera, const RenderOptions& options)
{
    m_gl.glDepthFunc(GL_LEQUAL);
    m_gl.glDepthMask(GL_FALSE);
    m_tracing.draw(options.view.tracing, camera);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDepthFunc(GL_LESS);
}

void Renderer::drawGround(bool hides)
{
    bindTexture(kSharpUnit, GL_TEXTURE_2D, m_shadows.sharpGround());
    bindTexture(kSoftUnit, GL_TEXTURE_2D, m_shadows.softGround());
    bindTexture(kSkyUnit, GL_TEXTURE_2D, m_shadows.skyGround());
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    // Seen from below, the ground is invisible and hides nothing.
    m_gl.glDepthMask(hides && m_frame.eye[1] > 0.0F ? GL_TRUE : GL_FALSE);
    m_gl.glBindVertexArray(m_noVertices.get());
    m_groundProgram->bind();
    m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glDisable(GL_BLEND);
}

void Renderer::drawTree(const RenderOptions& options, float saturation)
{
    // Leaves come first: wood that they cover need not be lit.
    if (options.view.leavesShown) {
        bindTexture(kColourUnit, GL_TEXTURE_2D, m_tree.leafColour());
        bindTexture(kSurfaceUnit, GL_TEXTURE_2D, m_tree.leafSurface());
        QOpenGLShaderProgram& leaf = options.isPlain ? *m_plainLeafProgram : *m_leafProgram;
        leaf.bind();
        leaf.setUniformValue("saturation", saturation);
        // With a warm sun and a filmic curve, drawn leaves would look like paint in their own colours; these
        // factors make them look more like a photograph. The user's photographs only need the brightness.
        leaf.setUniformValue("filmCast", m_tree.hasOwnLeaves() ? QVector3D(0.75F, 0.75F, 0.75F)
                                                               : QVector3D(0.84F, 0.63F, 0.80F));
        m_tree.drawLeaves();
    }
    if (options.view.fibresShown && m_tree.hasFibres()) {
        m_fibreProgram->bind();
        m_tree.drawFibres();
        return;
    }
    QOpenGLShaderProgram& bark = options.isPlain ? *m_plainBarkProgram : *m_barkProgram;
    bindTexture(kColourUnit, GL_TEXTURE_2D, m_tree.barkColour());
    bindTexture(kSurfaceUnit, GL_TEXTURE_2D, m_tree.barkSurface());
    bark.bind();
    bark.setUniformValue("widening", options.boldness + (options.samples > 1 ? 0.04F : 0.15F));
    m_tree.drawBark();
}

void Renderer::bindTexture(int unit, GLenum kind, GLuint texture)
{
    m_gl.glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    m_gl.glBindTexture(kind, texture);
}

} // namespace espalier
