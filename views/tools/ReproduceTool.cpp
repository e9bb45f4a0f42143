// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/ReproduceTool.h"

#include "commands/recipe/RecipeLimits.h"
#include "model/sketch/CrownHull.h"
#include "views/tools/ToolColours.h"

#include <QLineF>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// The drawing's plane is drawn on unless it is seen at a sharper angle than this from its edge; and so for
/// each ray to it.
constexpr float kLeastPlaneFacing = 0.5F;
constexpr float kLeastRayFacing = 0.1F;
/// The silhouette must enclose the trunk at this share of its length: its tip may touch the stroke.
constexpr double kEnclosedShare = 0.9;
/// A trunk may dip below its foot by this share of its height, as a wavy stroke does.
constexpr float kMostDip = 0.05F;
/// A stroke shows as a loop when the gap between its ends is below this share of its length, from this length
/// on, px; see StrokeFitOptions.
constexpr double kClosedShare = 0.1;
constexpr double kLeastLoop = 60.0;
constexpr float kFigureInk = 2.8F; ///< px
constexpr float kHalfBar = 6.0F;   ///< px

QColor inkOf(FigureStroke stroke)
{
    return stroke == FigureStroke::Trunk ? kTrunkInk : kSilhouetteInk;
}

/// To the right in the upright plane that is seen from @p azimuth, °.
Vec3 rightOf(double azimuth)
{
    const auto angle = static_cast<float>(radians(azimuth));
    return {std::cos(angle), 0.0F, -std::sin(angle)};
}

Vec3 towardViewer(double azimuth)
{
    const auto angle = static_cast<float>(radians(azimuth));
    return {std::sin(angle), 0.0F, std::cos(angle)};
}

SketchLine inDoubles(const std::vector<Vec2>& line)
{
    SketchLine result;
    for (const Vec2& point : line)
        result.emplace_back(point.cast<double>());
    return result;
}

void paintFigureStroke(Overlay& overlay, FigureStroke stroke, const std::vector<Vec3>& line)
{
    overlay.addInk(line, inkOf(stroke), kFigureInk);
    if (stroke == FigureStroke::Silhouette)
        overlay.addInk(std::array{line.back(), line.front()}, inkOf(stroke), 0.6F * kFigureInk, 5.0F);
}

} // namespace

ReproduceTool::ReproduceTool(ToolContext& context, FigureTaking& figures) : Tool(context), m_figures(figures)
{
    m_figures.expect(due(), false);
}

FigureStroke ReproduceTool::due() const
{
    return m_first && m_first->stroke == FigureStroke::Trunk ? FigureStroke::Silhouette : FigureStroke::Trunk;
}

void ReproduceTool::begin(const PointerSample& sample)
{
    m_isActive = true;
    m_path = {sample.position};
    m_length = 0.0;
    context().requestRepaint();
}

void ReproduceTool::move(const PointerSample& sample)
{
    if (!m_isActive || m_path.back() == sample.position)
        return;
    // The ink comes first: nothing is computed until the pointer is lifted.
    m_length += QLineF(m_path.back(), sample.position).length();
    m_path.push_back(sample.position);
    context().requestRepaint();
}

void ReproduceTool::end(const PointerSample& sample)
{
    move(sample);
    finish();
}

void ReproduceTool::finish()
{
    if (!std::exchange(m_isActive, false))
        return;
    if (const QString why = take(); !why.isEmpty())
        m_figures.refuse(why);
    m_path.clear();
    m_figures.expect(due(), m_first.has_value());
    context().requestRepaint();
}

void ReproduceTool::cancel()
{
    m_isActive = false;
    m_path.clear();
    context().requestRepaint();
}

bool ReproduceTool::keyPressed(int key)
{
    if (key != Qt::Key_Escape || !m_first)
        return false;
    takeBack();
    return true;
}

void ReproduceTool::forget()
{
    if (m_first)
        takeBack();
}

void ReproduceTool::takeBack()
{
    m_first.reset();
    m_figures.expect(due(), false);
    context().requestRepaint();
}

bool ReproduceTool::isSeedling() const
{
    return context().document().index().livingCount() == 1;
}

double ReproduceTool::azimuthOfView() const
{
    return std::remainder(degrees(double{context().camera().azimuth()}), 360.0);
}

QString ReproduceTool::viewFault(double azimuth) const
{
    if (-context().camera().forward().dot(towardViewer(azimuth)) >= kLeastPlaneFacing)
        return {};
    return m_first ? tr("turn the view back to where you drew the first stroke, or press Esc to discard it")
                   : tr("look at the tree from the side, not from above or below, to draw its shape");
}

/// The path on the plane; nothing where the plane is seen too sharply or too far away.
std::optional<ReproduceTool::FlatLine> ReproduceTool::onPlane(double azimuth) const
{
    const Vec3 right = rightOf(azimuth);
    const Vec3 normal = towardViewer(azimuth);
    FlatLine line;
    for (const QPointF& pixel : m_path) {
        const Ray ray = context().camera().ray(pixel);
        const float facing = -ray.direction.dot(normal);
        if (facing < kLeastRayFacing)
            return {};
        const Vec3 offset = ray.origin - foot();
        const Vec3 place = offset + offset.dot(normal) / facing * ray.direction;
        line.emplace_back(place.dot(right), place.y());
        if (!(double{line.back().cwiseAbs().maxCoeff()} < recipeLimits::kCoordinate))
            return {};
    }
    return line;
}

/// Takes the path as a stroke. Returns why not, or an empty text.
QString ReproduceTool::take()
{
    SketchLine samples;
    for (const QPointF& point : m_path)
        samples.emplace_back(point.x(), -point.y());
    const std::optional<SketchStroke> stroke = fitStroke(samples);
    if (isSeedling())
        return tr("there is no tree yet to give another shape: make one first");
    if (!stroke || stroke->kind == SketchStroke::Kind::Dot)
        return due() == FigureStroke::Trunk
                   ? tr("that is a point: draw the trunk as a line")
                   : tr("that is a point: draw the silhouette as a line around the crown");
    const double azimuth = m_first ? m_first->azimuth : azimuthOfView();
    if (QString fault = viewFault(azimuth); !fault.isEmpty())
        return fault;
    std::optional<FlatLine> line = onPlane(azimuth);
    if (!line)
        return tr("the stroke reaches too far away from the tree");
    const bool isLoop = stroke->kind == SketchStroke::Kind::Closed;
    return m_first ? takeSecond(isLoop, std::move(*line)) : takeFirst(isLoop, std::move(*line), azimuth);
}

QString ReproduceTool::takeFirst(bool isLoop, FlatLine line, double azimuth)
{
    if (QString fault = isLoop ? QString() : trunkFault(line); !fault.isEmpty())
        return fault;
    m_first = First{.stroke = isLoop ? FigureStroke::Silhouette : FigureStroke::Trunk,
                    .line = std::move(line),
                    .azimuth = azimuth};
    return {};
}

QString ReproduceTool::takeSecond(bool isLoop, FlatLine line)
{
    const bool isTrunk = due() == FigureStroke::Trunk;
    if (isTrunk && isLoop)
        return tr("the trunk must be an open line");
    const FlatLine& trunk = isTrunk ? line : m_first->line;
    const FlatLine& silhouette = isTrunk ? m_first->line : line;
    if (QString fault = isTrunk ? trunkFault(line) : QString(); !fault.isEmpty())
        return fault;
    SketchLine axis = inDoubles(trunk);
    if (axis.back().y() < axis.front().y())
        std::ranges::reverse(axis);
    const Eigen::Vector2d top = pointAlong(axis, kEnclosedShare);
    if (!CrownHull(inDoubles(silhouette), 1.0).contains({top.x(), top.y(), 0.0}))
        return isTrunk ? tr("the tip of the trunk must be inside the silhouette")
                       : tr("the silhouette must enclose the tip of the trunk");
    TreeFigure figure{.trunk = trunk, .silhouette = silhouette, .azimuth = m_first->azimuth};
    // If the tree refuses the figure, the first stroke stays, and the second one can be drawn again.
    if (QString fault = m_figures.take(std::move(figure)); !fault.isEmpty())
        return fault;
    m_first.reset();
    return {};
}

/// Why a line, drawn from the foot or to it, cannot be a trunk; empty if it can.
QString ReproduceTool::trunkFault(const FlatLine& line)
{
    const float foot = std::min(line.front().y(), line.back().y());
    const float tip = std::max(line.front().y(), line.back().y());
    float lowest = foot;
    for (const Vec2& point : line)
        lowest = std::min(lowest, point.y());
    const bool isBelow = tip <= 0.0F || foot - lowest > kMostDip * (tip - lowest);
    return isBelow ? tr("the trunk must be above the ground: draw it from its foot to its tip") : QString();
}

bool ReproduceTool::looksClosed() const
{
    return m_length > kLeastLoop && QLineF(m_path.front(), m_path.back()).length() < kClosedShare * m_length;
}

void ReproduceTool::paintTrunk(Overlay& overlay) const
{
    const TreeIndex& index = context().document().index();
    std::vector<Vec3> trunk{foot()};
    for (InternodeId id = 0; id != kNoInternode; id = index.mainChild(id))
        trunk.push_back(index.nodePosition(id));
    overlay.addInk(trunk, kTrunkInk, 1.6F, 6.0F);
    // A bar across its end.
    const Camera& camera = context().camera();
    const float depth = std::max(camera.depth(trunk.back()), Camera::kMinDistance);
    const Vec3 bar = kHalfBar / camera.pixelsPerMetre(depth) * camera.right();
    overlay.addInk(std::array<Vec3, 2>{trunk.back() - bar, trunk.back() + bar}, kTrunkInk, 2.0F);
}

void ReproduceTool::paint(Overlay& overlay) const
{
    if (due() == FigureStroke::Trunk && !m_isActive && !isSeedling())
        paintTrunk(overlay);
    if (m_first) {
        const Vec3 right = rightOf(m_first->azimuth);
        std::vector<Vec3> line;
        for (const Vec2& point : m_first->line)
            line.emplace_back(foot() + point.x() * right + point.y() * Vec3::UnitY());
        paintFigureStroke(overlay, m_first->stroke, line);
    }
    if (!m_isActive)
        return;
    std::vector<Vec3> ink;
    for (const QPointF& pixel : m_path)
        ink.push_back(context().camera().onPlane(pixel, foot()));
    paintFigureStroke(overlay, !m_first && looksClosed() ? FigureStroke::Silhouette : due(), ink);
}

QString ReproduceTool::tip() const
{
    return isSeedling() ? tr("Make a tree first, with Brush or Sketch; then draw its new shape")
                        : tr("Draw the new trunk, then the silhouette of its crown");
}

} // namespace espalier
