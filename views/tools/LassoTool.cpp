// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/LassoTool.h"

#include "model/envelope/LassoLoop.h"
#include "views/tools/ToolColours.h"

#include <array>
#include <utility>

namespace espalier {

namespace {

/// A stroke that stays within this many px of its beginning is a tap.
constexpr double kLassoTap = 6.0;
/// s between two previews of what a stroke encloses.
constexpr double kPreviewInterval = 0.06;
constexpr int kPreviewResolution = 64;
/// A stroke of more points is simplified while it is drawn: some devices send thousands of samples a second.
constexpr std::size_t kManyPoints = 10'000;
constexpr double kFineTolerance = 1.0 / 8192.0;

} // namespace

void LassoTool::begin(const PointerSample& sample)
{
    m_filling.end();
    const Camera& camera = context().camera();
    const auto picked = context().pick(sample.position, sample.device);
    m_stroke = {picked ? picked->position : Vec3(Vec3::Zero()), camera.right(), camera.up(), {}};
    m_previewed = 0;
    m_previewTime = sample.time;
    m_preview.clear();
    m_isActive = true;
    add(sample.position);
}

void LassoTool::move(const PointerSample& sample)
{
    if (m_isActive)
        add(sample.position);
}

void LassoTool::end(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    add(sample.position);
    finish();
}

void LassoTool::finish()
{
    if (!std::exchange(m_isActive, false))
        return;
    m_preview.clear();
    Eigen::AlignedBox2f box;
    for (const Vec2& point : m_stroke.points)
        box.extend(point);
    const Camera& camera = context().camera();
    const double pixels = box.sizes().norm() * camera.pixelsPerMetre(camera.depth(m_stroke.origin));
    if (pixels > kLassoTap)
        m_filling.fill(m_stroke);
    context().requestRepaint();
}

void LassoTool::cancel()
{
    m_isActive = false;
    m_preview.clear();
    context().requestRepaint();
}

void LassoTool::tick(double now)
{
    if (m_previewed == m_stroke.points.size() || now - m_previewTime < kPreviewInterval)
        return;
    m_previewTime = now;
    m_previewed = m_stroke.points.size();
    m_preview.show(std::span(&m_stroke, 1), kPreviewResolution);
    context().requestRepaint();
}

void LassoTool::add(const QPointF& screen)
{
    const Vec3 offset = context().camera().onPlane(screen, m_stroke.origin) - m_stroke.origin;
    const Vec2 point(offset.dot(m_stroke.right), offset.dot(m_stroke.up));
    if (m_stroke.points.empty() || m_stroke.points.back() != point)
        m_stroke.points.push_back(point);
    if (m_stroke.points.size() > kManyPoints)
        m_stroke.points = simplified(m_stroke.points, kFineTolerance);
    context().requestRepaint();
}

void LassoTool::paint(Overlay& overlay) const
{
    const ViewValues& view = context().viewSettings().values();
    if (view.markersShown)
        overlay.addDots(m_filling.markers(), kBrushColour, 2.5F, 0.5F);
    if (view.envelopeShown) {
        m_standing.show(context().document().tree().lassosInForce());
        m_standing.paint(overlay, kBrushColour);
    }
    if (!m_isActive)
        return;
    m_preview.paint(overlay, kBrushColour);
    std::vector<Vec3> line;
    line.reserve(m_stroke.points.size());
    for (const Vec2& point : m_stroke.points)
        line.emplace_back(m_stroke.origin + point.x() * m_stroke.right + point.y() * m_stroke.up);
    overlay.addLine(line, kBrushColour, 2.2F);
    overlay.addLine(std::array{line.back(), line.front()}, kBrushColour, 1.4F, 5.0F);
    overlay.addDots(std::array{line.front()}, kBrushColour, 6.0F);
}

QString LassoTool::tip() const
{
    return tr("Draw the silhouette of a crown; the tree fills it. Begin at a branch to draw at its depth");
}

} // namespace espalier
