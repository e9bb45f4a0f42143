// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/TreeShadows.h"

#include <QOpenGLShaderProgram>
#include <QVector2D>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kCoverageEdge = 256;
constexpr int kSoftEdge = 256;
constexpr int kSkyEdge = 64;
/// A part of the tree throws a sharp shadow on the ground up to this distance, as a share of the tree's
/// height.
constexpr float kNearShare = 0.25F;

} // namespace

Matrix4 parallelProjection(const Box3& box, const Vec3& toward)
{
    const Vec3 right = anyPerpendicular(toward);
    Eigen::Matrix3f axes;
    axes.row(0) = right;
    axes.row(1) = toward.cross(right);
    axes.row(2) = -toward; // Depth grows away from the camera.
    Box3 seen;
    for (int corner = 0; corner < 8; ++corner)
        seen.extend(axes * box.corner(static_cast<Box3::CornerType>(corner)));
    const Vec3 half = (0.5F * seen.sizes()).cwiseMax(Vec3::Constant(1e-3F));
    Matrix4 projection = Matrix4::Identity();
    projection.topLeftCorner<3, 3>() = half.cwiseInverse().asDiagonal() * axes;
    projection.topRightCorner<3, 1>() = -seen.center().cwiseQuotient(half);
    return projection;
}

Matrix4 textureFromClip()
{
    Matrix4 matrix = Matrix4::Identity();
    matrix.topLeftCorner<3, 3>() *= 0.5F;
    matrix.topRightCorner<3, 1>().setConstant(0.5F);
    return matrix;
}

TreeShadows::TreeShadows(Gl& gl)
    : m_gl(gl),
      m_map(gl),
      m_mapFramebuffer(gl),
      m_coverage(gl, kCoverageEdge),
      m_ground(gl, kGroundEdge),
      m_sharp(gl, kGroundEdge),
      m_soft(gl, kSoftEdge),
      m_sky(gl, kSkyEdge),
      m_noVertices(gl),
      m_groundProgram(loadProgram("screen.vert", "groundshadow.frag")),
      m_blurProgram(loadProgram("screen.vert", "blur.frag"))
{
    gl.glBindTexture(GL_TEXTURE_2D, m_map.get());
    gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, kMapEdge, kMapEdge, 0, GL_DEPTH_COMPONENT,
                    GL_UNSIGNED_INT, nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    // There is light outside the map.
    constexpr std::array<float, 4> farthest{1.0F, 1.0F, 1.0F, 1.0F};
    gl.glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, farthest.data());
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_BORDER);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
    gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_FUNC, GL_LEQUAL);
    gl.glBindFramebuffer(GL_FRAMEBUFFER, m_mapFramebuffer.get());
    gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_map.get(), 0);
    gl.glDrawBuffer(GL_NONE);
    gl.glReadBuffer(GL_NONE);
    gl.glClear(GL_DEPTH_BUFFER_BIT);

    for (const Surface* surface : {&m_coverage, &m_ground, &m_sharp.first, &m_sharp.second, &m_soft.first,
                                   &m_soft.second, &m_sky.first, &m_sky.second})
        makeSurface(*surface);
}

TreeShadows::~TreeShadows() = default;

void TreeShadows::makeSurface(const Surface& surface)
{
    m_gl.glBindTexture(GL_TEXTURE_2D, surface.texture.get());
    m_gl.glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, surface.edge, surface.edge, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                      nullptr);
    for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        m_gl.glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    constexpr std::array<float, 4> outside{};
    m_gl.glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, outside.data());
    for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
        m_gl.glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_BORDER);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, surface.framebuffer.get());
    m_gl.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, surface.texture.get(),
                                0);
    m_gl.glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    m_gl.glClear(GL_COLOR_BUFFER_BIT);
}

void TreeShadows::render(const Box3& bounds, const Vec3& sun, float groundRadius, const Draw& draw,
                         const Draw& drawRoughly)
{
    m_gl.glDisable(GL_BLEND);
    m_gl.glDisable(GL_CULL_FACE);

    const Matrix4 fromSun = parallelProjection(bounds, sun);
    m_shadowFromWorld = textureFromClip() * fromSun;
    m_texelEdge = 2.0F / (static_cast<float>(kMapEdge) *
                          std::min(fromSun.row(0).head<3>().norm(), fromSun.row(1).head<3>().norm()));
    m_depthPerMetre = 0.5F * fromSun.row(2).head<3>().norm();
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_mapFramebuffer.get());
    m_gl.glViewport(0, 0, kMapEdge, kMapEdge);
    m_gl.glEnable(GL_DEPTH_TEST);
    m_gl.glDepthMask(GL_TRUE);
    m_gl.glEnable(GL_POLYGON_OFFSET_FILL);
    m_gl.glPolygonOffset(1.5F, 2.0F);
    m_gl.glClear(GL_DEPTH_BUFFER_BIT);
    draw(fromSun);
    m_gl.glDisable(GL_POLYGON_OFFSET_FILL);

    // The tree above the ground hides the sky, the more the lower it is; a view from straight above shows
    // where.
    const Matrix4 fromAbove = parallelProjection(bounds, up());
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_coverage.framebuffer.get());
    m_gl.glViewport(0, 0, kCoverageEdge, kCoverageEdge);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
    m_gl.glClear(GL_COLOR_BUFFER_BIT);
    drawRoughly(fromAbove);
    shadeGround(textureFromClip() * fromAbove, groundRadius, bounds.max().y());
}

void TreeShadows::shadeGround(const Matrix4& coverageFromWorld, float groundRadius, float height)
{
    m_gl.glBindVertexArray(m_noVertices.get());
    m_gl.glViewport(0, 0, kGroundEdge, kGroundEdge);
    m_gl.glBindFramebuffer(GL_FRAMEBUFFER, m_ground.framebuffer.get());
    m_gl.glActiveTexture(GL_TEXTURE1);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_coverage.texture.get());
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, m_map.get());
    // The depth itself is read here: it shows how far up a part of the tree is.
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    m_groundProgram->bind();
    m_groundProgram->setUniformValue("shadowMap", 0);
    m_groundProgram->setUniformValue("coverage", 1);
    setMatrix(*m_groundProgram, "shadowFromWorld", m_shadowFromWorld);
    setMatrix(*m_groundProgram, "coverageFromWorld", coverageFromWorld);
    m_groundProgram->setUniformValue("radius", groundRadius);
    m_groundProgram->setUniformValue("near", kNearShare * height * m_depthPerMetre);
    m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    m_gl.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);

    // The sun's disc blurs a shadow by about a hundredth of its distance, and thin clouds by more; a crown
    // hides the sky as far around it as it is high.
    const float share = height / (2.0F * groundRadius);
    m_blurProgram->bind();
    m_blurProgram->setUniformValue("image", 0);
    blur(m_ground, m_sharp, 0.005F * share);
    blur(m_ground, m_soft, 0.02F * share);
    blur(m_ground, m_sky, 0.16F * share);
    m_blurProgram->release();
}

/// Blurs by a Gaussian of @p sigma, as a share of the edge.
void TreeShadows::blur(const Surface& from, const Pair& to, float sigma)
{
    constexpr float kMostSamples = 12.0F; // to each side
    const auto edge = static_cast<float>(to.first.edge);
    const float texels = std::max(sigma * edge, 0.7F);
    // The samples of a wide blur lie between texels, where the hardware averages.
    const float stride = std::max(3.0F * texels / kMostSamples, 1.0F);
    m_blurProgram->setUniformValue("sigma", texels / stride);
    m_blurProgram->setUniformValue("reach", static_cast<int>(std::ceil(3.0F * texels / stride)));
    m_gl.glViewport(0, 0, to.first.edge, to.first.edge);
    const std::pair<const Surface*, const Surface*> ways[] = {{&from, &to.second}, {&to.second, &to.first}};
    for (const auto& [source, target] : ways) {
        m_gl.glBindFramebuffer(GL_FRAMEBUFFER, target->framebuffer.get());
        m_gl.glBindTexture(GL_TEXTURE_2D, source->texture.get());
        const float step = stride / edge;
        m_blurProgram->setUniformValue("direction",
                                       source == &from ? QVector2D(step, 0.0F) : QVector2D(0.0F, step));
        m_gl.glDrawArrays(GL_TRIANGLES, 0, 3);
    }
}

} // namespace espalier
