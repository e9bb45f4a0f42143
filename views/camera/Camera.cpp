// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/camera/Camera.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

const float kHalfHeight = std::tan(Camera::kFieldOfView / 2.0F); ///< Half the height of the view at depth 1
constexpr float kFrameMargin = 1.1F;
constexpr float kSmallestDepth = 1e-4F;

} // namespace

void Camera::setDistance(float metres)
{
    m_distance = std::clamp(metres, kMinDistance, kMaxDistance);
}

void Camera::setElevation(float angle)
{
    m_elevation = std::clamp(angle, -kMaxElevation, kMaxElevation);
}

void Camera::setViewSize(const QSizeF& size)
{
    m_viewSize = size.expandedTo({1.0, 1.0});
}

Vec3 Camera::right() const
{
    return {std::cos(m_azimuth), 0.0F, -std::sin(m_azimuth)};
}

Vec3 Camera::up() const
{
    const float lean = std::sin(m_elevation);
    return {-lean * std::sin(m_azimuth), std::cos(m_elevation), -lean * std::cos(m_azimuth)};
}

Vec3 Camera::forward() const
{
    const float level = std::cos(m_elevation);
    return {-level * std::sin(m_azimuth), -std::sin(m_elevation), -level * std::cos(m_azimuth)};
}

void Camera::orbit(float byAzimuth, float byElevation)
{
    setAzimuth(m_azimuth + byAzimuth);
    setElevation(m_elevation + byElevation);
}

void Camera::pan(const QPointF& by)
{
    const float metres = 1.0F / pixelsPerMetre(m_distance);
    m_target += metres * (static_cast<float>(by.y()) * up() - static_cast<float>(by.x()) * right());
}

void Camera::zoom(float factor, const QPointF& about)
{
    const Vec3 fixed = onPlane(about, m_target);
    const float before = m_distance;
    setDistance(before * factor);
    m_target = fixed + m_distance / before * (m_target - fixed);
}

Camera Camera::framing(std::span<const Vec3> points) const
{
    Camera framed = *this;
    if (points.empty())
        return framed;
    // In the axes of the camera, each side of the view is a plane through the eye. The place of the outermost
    // point along the plane's normal gives the place of the plane, and two opposite planes give the place of
    // the eye.
    const float slopeX = kHalfHeight * aspect() / kFrameMargin;
    const float slopeY = kHalfHeight / kFrameMargin;
    constexpr float kNone = std::numeric_limits<float>::lowest();
    float left = kNone;
    float rightmost = kNone;
    float top = kNone;
    float bottom = kNone;
    float nearest = -kNone;
    float farthest = kNone;
    const Vec3 toRight = right();
    const Vec3 toTop = up();
    const Vec3 ahead = forward();
    for (const Vec3& point : points) {
        const float x = point.dot(toRight);
        const float y = point.dot(toTop);
        const float z = point.dot(ahead);
        left = std::max(left, -x - slopeX * z);
        rightmost = std::max(rightmost, x - slopeX * z);
        top = std::max(top, y - slopeY * z);
        bottom = std::max(bottom, -y - slopeY * z);
        nearest = std::min(nearest, z);
        farthest = std::max(farthest, z);
    }
    const float eyeX = (rightmost - left) / 2.0F;
    const float eyeY = (top - bottom) / 2.0F;
    const float eyeZ = std::min(-(left + rightmost) / (2.0F * slopeX), -(top + bottom) / (2.0F * slopeY));
    const float middle = (nearest + farthest) / 2.0F;
    framed.m_targetShare = {0.5, 0.5};
    framed.m_target = eyeX * toRight + eyeY * toTop + middle * ahead;
    framed.setDistance(middle - eyeZ);
    return framed;
}

Camera Camera::framing(const Box3& box) const
{
    if (box.isEmpty())
        return *this;
    std::array<Vec3, 8> corners;
    for (int corner = 0; corner < 8; ++corner)
        corners[static_cast<std::size_t>(corner)] = box.corner(static_cast<Box3::CornerType>(corner));
    return framing(corners);
}

Camera Camera::turnedTo(NamedView view) const
{
    Camera turned = *this;
    switch (view) {
    case NamedView::Front:
        turned.m_azimuth = 0.0F;
        turned.m_elevation = 0.0F;
        break;
    case NamedView::Side:
        turned.m_azimuth = static_cast<float>(radians(90));
        turned.m_elevation = 0.0F;
        break;
    case NamedView::Top:
        turned.m_azimuth = 0.0F;
        turned.m_elevation = kMaxElevation;
        break;
    case NamedView::ThreeQuarter:
        turned.m_azimuth = static_cast<float>(radians(-35));
        turned.m_elevation = static_cast<float>(radians(18));
        break;
    }
    return turned;
}

std::optional<QPointF> Camera::project(const Vec3& point) const
{
    const Vec3 offset = point - position();
    const float ahead = offset.dot(forward());
    if (ahead < kSmallestDepth)
        return std::nullopt;
    const float scale = pixelsPerMetre(ahead);
    return targetPlace() + QPointF(static_cast<double>(offset.dot(right()) * scale),
                                   static_cast<double>(-offset.dot(up()) * scale));
}

Ray Camera::ray(const QPointF& screen) const
{
    const float metres = 1.0F / pixelsPerMetre(1.0F);
    const QPointF offset = screen - targetPlace();
    const auto x = static_cast<float>(offset.x()) * metres;
    const auto y = static_cast<float>(-offset.y()) * metres;
    return {position(), (forward() + x * right() + y * up()).normalized()};
}

Vec3 Camera::onPlane(const QPointF& screen, const Vec3& through) const
{
    const float wanted = depth(through);
    const Ray towards = ray(screen);
    const float ahead = wanted < kSmallestDepth ? m_distance : wanted;
    return towards.origin + ahead / towards.direction.dot(forward()) * towards.direction;
}

float Camera::pixelsPerMetre(float depth) const
{
    return static_cast<float>(m_viewSize.height()) / (2.0F * kHalfHeight * depth);
}

float Camera::aspect() const
{
    return static_cast<float>(m_viewSize.width() / m_viewSize.height());
}

Matrix4 Camera::viewMatrix() const
{
    Eigen::Matrix3f axes;
    axes.row(0) = right();
    axes.row(1) = up();
    axes.row(2) = -forward();
    Matrix4 view = Matrix4::Identity();
    view.topLeftCorner<3, 3>() = axes;
    view.topRightCorner<3, 1>() = -(axes * position());
    return view;
}

Matrix4 Camera::projectionMatrix(float nearest, float farthest) const
{
    Matrix4 projection = Matrix4::Zero();
    projection(0, 0) = 1.0F / (kHalfHeight * aspect());
    projection(1, 1) = 1.0F / kHalfHeight;
    projection(0, 2) = static_cast<float>(1.0 - 2.0 * m_targetShare.x());
    projection(1, 2) = static_cast<float>(2.0 * m_targetShare.y() - 1.0);
    projection(2, 2) = (farthest + nearest) / (nearest - farthest);
    projection(2, 3) = 2.0F * farthest * nearest / (nearest - farthest);
    projection(3, 2) = -1.0F;
    return projection;
}

} // namespace espalier
