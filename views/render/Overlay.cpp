// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/Overlay.h"

#include <array>
#include <cmath>
#include <numbers>

namespace espalier {

void Overlay::clear()
{
    m_spheres.clear();
    m_surfaces.clear();
    m_lines.clear();
    m_dots.clear();
    m_grids.clear();
    m_labels.clear();
    m_points.clear();
}

void Overlay::addLine(std::span<const Vec3> points, const QColor& colour, float width, float dash)
{
    if (points.size() < 2)
        return;
    m_lines.push_back({m_points.size(), points.size(), colour, width, dash, false});
    m_points.insert(m_points.end(), points.begin(), points.end());
}

void Overlay::addInk(std::span<const Vec3> points, const QColor& colour, float width, float dash)
{
    if (points.size() < 2)
        return;
    addLine(points, colour, width, dash);
    m_lines.back().isInk = true;
}

void Overlay::addSegments(std::span<const Vec3> points, const QColor& colour, float width)
{
    if (points.size() < 2)
        return;
    addLine(points, colour, width);
    m_lines.back().isBroken = true;
}

void Overlay::addDots(std::span<const Vec3> points, const QColor& colour, float size, float glow)
{
    if (points.empty())
        return;
    m_dots.push_back({m_points.size(), points.size(), colour, size, glow});
    m_points.insert(m_points.end(), points.begin(), points.end());
}

void Overlay::addCircle(const Vec3& centre, const Vec3& u, const Vec3& v, float radius, const QColor& colour,
                        float width)
{
    std::array<Vec3, 65> circle;
    for (std::size_t i = 0; i < circle.size(); ++i) {
        const float angle = 2.0F * std::numbers::pi_v<float> * static_cast<float>(i) / (circle.size() - 1);
        circle[i] = centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
    }
    addLine(circle, colour, width);
}

} // namespace espalier
