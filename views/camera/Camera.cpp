// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/camera/Camera.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

const float kHalfHeight = std::tan(Camera::kFieldOfView / 2.0F); ///< Of the view at depth 1
constexpr float kFrameMargin = 1.12F;
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

Camera Camera::framing(const Box3& box) const
{
    Camera framed = *this;
    if (box.isEmpty())
        return framed;
    framed.m_target = box.center();
    const float halfWidth = kHalfHeight * aspect();
    float wanted = kMinDistance;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 offset = box.corner(static_cast<Box3::CornerType>(corner)) - framed.m_target;
        const float extent = std::max(std::abs(offset.dot(right())) / halfWidth, std::abs(offset.dot(up())) / kHalfHeight);
        wanted = std::max(wanted, extent * kFrameMargin - offset.dot(forward()));
    }
    framed.setDistance(wanted);
    return framed;
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
        turned.m_azimuth = static_cast<float>(radians(35));
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
    return QPointF(m_viewSize.width() / 2.0 + static_cast<double>(offset.dot(right()) * scale),
                   m_viewSize.height() / 2.0 - static_cast<double>(offset.dot(up()) * scale));
}

Ray Camera::ray(const QPointF& screen) const
{
    const float metres = 1.0F / pixelsPerMetre(1.0F);
    const auto x = static_cast<float>(screen.x() - m_viewSize.width() / 2.0) * metres;
    const auto y = static_cast<float>(m_viewSize.height() / 2.0 - screen.y()) * metres;
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
    projection(2, 2) = (farthest + nearest) / (nearest - farthest);
    projection(2, 3) = 2.0F * farthest * nearest / (nearest - farthest);
    projection(3, 2) = -1.0F;
    return projection;
}

} // namespace espalier
