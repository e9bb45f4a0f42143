// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/OverlayRenderer.h"

#include <QOpenGLShaderProgram>
#include <QVector2D>
#include <QVector4D>

#include <cstddef>

namespace espalier {

namespace {

constexpr float kOutline = 1.8F; ///< Width of a sphere's outline, px
constexpr float kHalo = 3.2F;    ///< Diameter of a dot's halo in diameters of its middle

QVector4D tint(const QColor& colour)
{
    return {colour.redF(), colour.greenF(), colour.blueF(), colour.alphaF()};
}

} // namespace

OverlayRenderer::OverlayRenderer(Gl& gl)
    : m_gl(gl),
      m_gridProgram(loadProgram("grid.vert", "grid.frag")),
      m_sphereProgram(loadProgram("sphere.vert", "sphere.frag")),
      m_surfaceProgram(loadProgram("surface.vert", "surface.frag")),
      m_lineProgram(loadProgram("line.vert", "line.frag")),
      m_dotProgram(loadProgram("dot.vert", "dot.frag")),
      m_noVertices(gl),
      m_surfaceVertices(gl),
      m_lineVertices(gl),
      m_dotVertices(gl),
      m_surfaceBuffer(gl),
      m_lineBuffer(gl),
      m_dotBuffer(gl)
{
    gl.glBindVertexArray(m_lineVertices.get());
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_lineBuffer.name());
    const auto attribute = [&](GLuint location, GLint size, std::size_t stride, std::size_t offset) {
        gl.glEnableVertexAttribArray(location);
        gl.glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                                 reinterpret_cast<const void*>(offset));
    };
    attribute(0, 3, sizeof(Segment), offsetof(Segment, from));
    attribute(1, 3, sizeof(Segment), offsetof(Segment, to));
    attribute(2, 1, sizeof(Segment), offsetof(Segment, path));
    for (const GLuint location : {0U, 1U, 2U})
        gl.glVertexAttribDivisor(location, 1);
    gl.glBindVertexArray(m_dotVertices.get());
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_dotBuffer.name());
    attribute(0, 3, sizeof(Vec3), 0);
    gl.glBindVertexArray(m_surfaceVertices.get());
    gl.glBindBuffer(GL_ARRAY_BUFFER, m_surfaceBuffer.name());
    attribute(0, 3, 2 * sizeof(Vec3), 0);
    attribute(1, 3, 2 * sizeof(Vec3), sizeof(Vec3));
    gl.glBindVertexArray(0);
}

OverlayRenderer::~OverlayRenderer() = default;

void OverlayRenderer::render(const Overlay& overlay, const Camera& camera, GLuint sceneDepth,
                             const QRect& part, double pixelRatio)
{
    m_gl.glViewport(part.left(), part.top(), part.width(), part.height());
    m_gl.glScissor(part.left(), part.top(), part.width(), part.height());
    m_gl.glEnable(GL_SCISSOR_TEST);
    m_gl.glDisable(GL_DEPTH_TEST);
    m_gl.glDisable(GL_CULL_FACE);
    m_gl.glEnable(GL_BLEND);
    m_gl.glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    m_gl.glActiveTexture(GL_TEXTURE0);
    m_gl.glBindTexture(GL_TEXTURE_2D, sceneDepth);
    const QVector2D overlaySize(static_cast<float>(part.width()), static_cast<float>(part.height()));
    const QVector2D overlayOrigin(static_cast<float>(part.left()), static_cast<float>(part.top()));
    for (QOpenGLShaderProgram* program : {m_gridProgram.get(), m_sphereProgram.get(), m_surfaceProgram.get(),
                                          m_lineProgram.get(), m_dotProgram.get()}) {
        program->bind();
        program->setUniformValue("sceneDepth", 0);
        program->setUniformValue("overlaySize", overlaySize);
        program->setUniformValue("overlayOrigin", overlayOrigin);
    }
    const auto ratio = static_cast<float>(pixelRatio);
    drawGrids(overlay);
    drawSpheres(overlay, camera, ratio);
    drawSurfaces(overlay);
    drawLines(overlay, camera, ratio);
    drawDots(overlay, ratio);
    m_gl.glDisable(GL_SCISSOR_TEST);
    m_gl.glDisable(GL_BLEND);
}

void OverlayRenderer::drawGrids(const Overlay& overlay)
{
    m_gl.glBindVertexArray(m_noVertices.get());
    m_gridProgram->bind();
    for (const Overlay::Grid& grid : overlay.grids()) {
        setVector(*m_gridProgram, "centre", grid.centre);
        setVector(*m_gridProgram, "right", grid.right);
        setVector(*m_gridProgram, "up", grid.up);
        m_gridProgram->setUniformValue("extent", grid.extent);
        m_gridProgram->setUniformValue("spacing", grid.spacing);
        const Vec3 origin = grid.origin - grid.centre;
        m_gridProgram->setUniformValue("phase", QVector2D(origin.dot(grid.right), origin.dot(grid.up)));
        m_gridProgram->setUniformValue("tint", tint(grid.colour));
        m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

void OverlayRenderer::drawSpheres(const Overlay& overlay, const Camera& camera, float pixelRatio)
{
    m_gl.glBindVertexArray(m_noVertices.get());
    m_sphereProgram->bind();
    setVector(*m_sphereProgram, "right", camera.right());
    setVector(*m_sphereProgram, "up", camera.up());
    m_sphereProgram->setUniformValue("pixelSize", 1.0F / (camera.pixelsPerMetre(1.0F) * pixelRatio));
    m_sphereProgram->setUniformValue("width", kOutline * pixelRatio);
    for (const Overlay::Sphere& sphere : overlay.spheres()) {
        setVector(*m_sphereProgram, "centre", sphere.centre);
        m_sphereProgram->setUniformValue("radius", sphere.radius);
        QVector4D colour = tint(sphere.colour);
        colour.setW(sphere.fill);
        m_sphereProgram->setUniformValue("tint", colour);
        m_gl.glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

void OverlayRenderer::drawSurfaces(const Overlay& overlay)
{
    m_gl.glEnable(GL_CULL_FACE);
    m_gl.glBindVertexArray(m_surfaceVertices.get());
    m_surfaceProgram->bind();
    for (const Overlay::Surface& surface : overlay.surfaces()) {
        const EnvelopeMesh& mesh = *surface.mesh;
        if (m_surface != surface.mesh) {
            std::vector<Vec3> corners;
            corners.reserve(2 * mesh.triangles.size());
            for (const std::uint32_t vertex : mesh.triangles) {
                corners.push_back(mesh.positions[vertex]);
                corners.push_back(mesh.normals[vertex]);
            }
            const std::size_t bytes = corners.size() * sizeof(Vec3);
            m_surfaceBuffer.reserve(bytes);
            m_surfaceBuffer.write(0, corners.data(), bytes);
            m_surface = surface.mesh;
        }
        QVector4D colour = tint(surface.colour);
        colour.setW(surface.rim);
        m_surfaceProgram->setUniformValue("tint", colour);
        m_gl.glDrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(mesh.triangles.size()));
    }
    m_gl.glDisable(GL_CULL_FACE);
}

void OverlayRenderer::drawLines(const Overlay& overlay, const Camera& camera, float pixelRatio)
{
    m_gl.glBindVertexArray(m_lineVertices.get());
    m_lineProgram->bind();
    for (const Overlay::Line& line : overlay.lines()) {
        m_segments.clear();
        const std::span<const Vec3> points = overlay.points().subspan(line.first, line.count);
        double path = 0.0;
        std::optional<QPointF> before = camera.project(points.front());
        for (std::size_t i = 1; i < points.size(); i += line.isBroken ? 2 : 1) {
            const Vec3& a = points[i - 1];
            const Vec3& b = points[i];
            m_segments.push_back(
                {{a.x(), a.y(), a.z()}, {b.x(), b.y(), b.z()}, static_cast<float>(path) * pixelRatio});
            const std::optional<QPointF> now = camera.project(b);
            if (before && now)
                path += std::hypot(now->x() - before->x(), now->y() - before->y());
            before = now;
        }
        const std::size_t bytes = m_segments.size() * sizeof(Segment);
        m_lineBuffer.reserve(bytes);
        m_lineBuffer.write(0, m_segments.data(), bytes);
        m_lineProgram->setUniformValue("width", line.width * pixelRatio);
        m_lineProgram->setUniformValue("dash", line.dash * pixelRatio);
        m_lineProgram->setUniformValue("least", line.isInk ? 1.0F : 0.0F);
        m_lineProgram->setUniformValue("tint", tint(line.colour));
        m_gl.glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(m_segments.size()));
    }
}

void OverlayRenderer::drawDots(const Overlay& overlay, float pixelRatio)
{
    m_gl.glEnable(GL_PROGRAM_POINT_SIZE);
    m_gl.glBindVertexArray(m_dotVertices.get());
    m_dotProgram->bind();
    for (const Overlay::Dots& dots : overlay.dots()) {
        const std::span<const Vec3> points = overlay.points().subspan(dots.first, dots.count);
        m_dotBuffer.reserve(points.size_bytes());
        m_dotBuffer.write(0, points.data(), points.size_bytes());
        const float middle = dots.size * pixelRatio;
        m_dotProgram->setUniformValue("middle", middle);
        m_dotProgram->setUniformValue("size", dots.glow > 0.0F ? kHalo * middle : middle + 2.0F);
        m_dotProgram->setUniformValue("glow", dots.glow);
        m_dotProgram->setUniformValue("tint", tint(dots.colour));
        m_gl.glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
    }
    m_gl.glDisable(GL_PROGRAM_POINT_SIZE);
}

} // namespace espalier
