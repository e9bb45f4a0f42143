// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QPointF>
#include <QSizeF>

#include <optional>
#include <span>

namespace espalier {

using Matrix4 = Eigen::Matrix4f;

/// A half-line; the direction has length 1.
struct Ray {
    Vec3 origin = Vec3::Zero();
    Vec3 direction = -Vec3::UnitZ();
};

enum class NamedView { Front, Side, Top, ThreeQuarter };

/// A turntable camera: it looks at a target from a distance, at an azimuth around the vertical and an
/// elevation above the horizon, and its horizon is always level. A value type; it holds the size of the view,
/// so that it can convert between points of the world and places on the screen. Screen positions are
/// device-independent pixels from the upper left corner.
class Camera {
public:
    /// Full vertical angle of view, rad.
    static constexpr float kFieldOfView = static_cast<float>(radians(38));
    static constexpr float kMinDistance = 0.05F;   ///< m
    static constexpr float kMaxDistance = 1000.0F; ///< m
    static constexpr float kMaxElevation = static_cast<float>(radians(90));

    /// Upright before a seedling: level, so that a stroke straight up makes an upright trunk; 6 m of the
    /// world are visible from top to bottom at the origin, a quarter of them below ground.
    Camera() = default;

    const Vec3& target() const { return m_target; }
    float distance() const { return m_distance; }
    /// rad, 0 looks from +Z toward −Z, π/2 from +X; not wrapped, so that an animation can turn the short way.
    float azimuth() const { return m_azimuth; }
    /// rad above the horizon, −π/2...π/2.
    float elevation() const { return m_elevation; }
    const QSizeF& viewSize() const { return m_viewSize; }
    /// Where the target is on the screen, in shares of the view's width and height: the middle of the view,
    /// or of the part that nothing covers.
    const QPointF& targetShare() const { return m_targetShare; }
    /// The same place, px.
    QPointF targetPlace() const
    {
        return {m_targetShare.x() * m_viewSize.width(), m_targetShare.y() * m_viewSize.height()};
    }

    void setTarget(const Vec3& target) { m_target = target; }
    void setDistance(float metres);
    void setAzimuth(float angle) { m_azimuth = angle; }
    void setElevation(float angle);
    /// Sizes below one pixel count as one.
    void setViewSize(const QSizeF& size);
    /// Moves the picture on the screen, without moving the camera, until the target is there.
    void setTargetShare(const QPointF& share) { m_targetShare = share; }

    Vec3 right() const;
    Vec3 up() const;
    /// Direction of view, a unit vector.
    Vec3 forward() const;
    Vec3 position() const { return m_target - m_distance * forward(); }

    /// Turns about the target, rad.
    void orbit(float byAzimuth, float byElevation);
    /// Moves the target so that the plane through it follows the pointer by @p by, px.
    void pan(const QPointF& by);
    /// Multiplies the distance by @p factor (> 0, below 1 comes nearer); the point under @p about on the
    /// plane through the target stays under it.
    void zoom(float factor, const QPointF& about);
    /// The same camera, moved without turning to the nearest place from which all of @p points are visible,
    /// in the middle and with a margin; unchanged if there are none. The target becomes the middle of the
    /// points, and is in the middle of the view.
    Camera framing(std::span<const Vec3> points) const;
    Camera framing(const Box3& box) const;
    /// The same camera, turned to that view.
    Camera turnedTo(NamedView view) const;

    /// Place of a point of the world on the screen; none if it is not in front of the camera.
    std::optional<QPointF> project(const Vec3& point) const;
    /// How far in front of the camera a point is, along forward(), m.
    float depth(const Vec3& point) const { return (point - position()).dot(forward()); }
    /// The ray from the camera's position through a point of the screen.
    Ray ray(const QPointF& screen) const;
    /// The point of the drawing plane under @p screen. The plane is parallel to the screen and goes through
    /// @p through, or through the target if @p through is at the camera or behind it.
    Vec3 onPlane(const QPointF& screen, const Vec3& through) const;
    /// Pixels on the screen for a metre parallel to it, at a depth > 0.
    float pixelsPerMetre(float depth) const;

    /// Matrix from world to camera space.
    Matrix4 viewMatrix() const;
    /// Matrix from camera space to OpenGL's clip space; 0 < nearest < farthest, m.
    Matrix4 projectionMatrix(float nearest, float farthest) const;

    bool operator==(const Camera&) const = default;

private:
    float aspect() const;

    Vec3 m_target{0.0F, 1.5F, 0.0F};
    float m_distance = 8.7126F;
    float m_azimuth = 0.0F;
    float m_elevation = 0.0F;
    QSizeF m_viewSize{1280.0, 800.0};
    QPointF m_targetShare{0.5, 0.5};
};

} // namespace espalier
