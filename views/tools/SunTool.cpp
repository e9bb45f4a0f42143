// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/SunTool.h"

#include "views/render/Sun.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kLeastReach = 16.0; ///< px
constexpr float kSize = 18.0F;       ///< px
constexpr float kSizeInHand = 22.0F; ///< px
// Between the sphere and the view's edges, where bars are, px.
constexpr double kSideMargin = 130.0;
constexpr double kTopMargin = 90.0;
constexpr double kLeastRadius = 60.0;

const QColor kColour(255, 224, 150);
const QColor kTextColour(255, 236, 200);

QPointF middleOf(const Camera& camera)
{
    return camera.targetPlace();
}

/// Half-axes of the ellipse that the sphere appears as, px: it fills the part of the view that sheets leave
/// free, so it is seldom round.
QPointF radiiOf(const Camera& camera)
{
    const QPointF middle = middleOf(camera);
    const QSizeF& view = camera.viewSize();
    return {std::max(std::min(middle.x(), view.width() - middle.x()) - kSideMargin, kLeastRadius),
            std::max(std::min(middle.y(), view.height() - middle.y()) - kTopMargin, kLeastRadius)};
}

QPointF placeOf(const Vec3& toward, const Camera& camera)
{
    const QPointF radii = radiiOf(camera);
    return middleOf(camera) + QPointF(static_cast<double>(toward.dot(camera.right())) * radii.x(),
                                      static_cast<double>(-toward.dot(camera.up())) * radii.y());
}

bool isBehind(const Vec3& toward, const Camera& camera)
{
    return toward.dot(camera.forward()) > 0.0F;
}

/// The direction of the place @p screen on the sphere's front or back; for a place beyond the rim, the
/// direction on the other side, at the same distance from the rim.
Vec3 directionAt(const QPointF& screen, bool behind, const Camera& camera)
{
    const QPointF radii = radiiOf(camera);
    const QPointF offset = screen - middleOf(camera);
    const double x = offset.x() / radii.x();
    const double y = -offset.y() / radii.y();
    const double away = std::min(std::hypot(x, y), 2.0);
    const double level = away <= 1.0 ? away : 2.0 - away;
    const bool back = behind != (away > 1.0);
    const double toViewer = std::sqrt(std::max(1.0 - level * level, 0.0)) * (back ? -1.0 : 1.0);
    const double scale = away > 0.0 ? level / std::hypot(x, y) : 0.0;
    return (static_cast<float>(x * scale) * camera.right() + static_cast<float>(y * scale) * camera.up() -
            static_cast<float>(toViewer) * camera.forward())
        .normalized();
}

} // namespace

QPointF SunTool::place() const
{
    const Camera& camera = context().mainCamera();
    return placeOf(towardSun(context().viewSettings().values(), camera), camera);
}

bool SunTool::isAt(const QPointF& screen, double reach) const
{
    if (!context().viewSettings().values().sunShown)
        return false;
    const QPointF away = screen - place();
    return std::hypot(away.x(), away.y()) <= std::max(reach, kLeastReach);
}

void SunTool::begin(const PointerSample& sample)
{
    const ViewValues& values = context().viewSettings().values();
    const Camera& camera = context().mainCamera();
    m_grip = Grip{place() - sample.position, espalier::isBehind(towardSun(values, camera), camera), values};
    m_pointer = sample.position;
}

void SunTool::move(const PointerSample& sample)
{
    m_pointer = sample.position;
    follow();
}

void SunTool::end(const PointerSample& sample)
{
    move(sample);
    finish();
}

void SunTool::finish()
{
    m_grip.reset();
    context().requestRepaint();
}

void SunTool::cancel()
{
    if (m_grip) {
        ViewValues values = context().viewSettings().values();
        values.sunAzimuth = m_grip->before.sunAzimuth;
        values.sunElevation = m_grip->before.sunElevation;
        context().viewSettings().setValues(values);
    }
    m_grip.reset();
}

void SunTool::hover(const PointerSample&)
{
    if (!std::exchange(m_isUnderPointer, true))
        context().requestRepaint();
}

void SunTool::leave()
{
    if (std::exchange(m_isUnderPointer, false))
        context().requestRepaint();
}

void SunTool::tick(double)
{
    // The camera may have turned since the last sample.
    follow();
}

void SunTool::follow()
{
    const Camera& camera = context().mainCamera();
    ViewValues values = context().viewSettings().values();
    putSun(values, camera, directionAt(m_pointer + m_grip->offset, m_grip->isBehind, camera));
    context().viewSettings().setValues(values);
}

void SunTool::paint(Overlay& overlay) const
{
    const ViewValues& values = context().viewSettings().values();
    if (!values.sunShown)
        return;
    const Camera& camera = context().mainCamera();
    const Vec3 toward = towardSun(values, camera);
    // A ball behind the tree is drawn at a greater depth than the tree, so that the tree hides it.
    constexpr float kMostDepth = 3.0F; // m
    const float aside = std::min(0.35F * camera.distance(), kMostDepth);
    const Ray ray = camera.ray(place());
    const float depth = camera.distance() + aside * toward.dot(camera.forward());
    const Vec3 ball = ray.origin + depth / ray.direction.dot(camera.forward()) * ray.direction;
    const bool isHeld = m_isUnderPointer || isActive();
    overlay.addDots({&ball, 1}, kColour, isHeld ? kSizeInHand : kSize, isHeld ? 1.6F : 1.0F);
    if (isActive()) {
        const double elevation = degrees(values.sunElevation);
        overlay.addLabel({ball, QPointF(20.0, 0.0), tr("%1° high").arg(std::lround(elevation)), kTextColour});
    }
}

QString SunTool::tip() const
{
    return tr("Drag the sun around the tree");
}

} // namespace espalier
