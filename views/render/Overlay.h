// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/envelope/EnvelopeMesh.h"

#include <QColor>
#include <QPointF>
#include <QString>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// The shapes that a tool draws over the tree: places are in the world, line widths and point sizes in
/// device-independent pixels. Parts behind the tree are drawn fainter, to show their depth.
class Overlay {
public:
    /// A translucent ball with an outline.
    struct Sphere {
        Vec3 centre = Vec3::Zero();
        float radius = 0.5F; ///< m
        QColor colour;
        float fill = 0.2F; ///< Opacity of the inside, 0...1
    };
    struct Line {
        std::size_t first = 0; ///< Index of the first point in points()
        std::size_t count = 0;
        QColor colour;
        float width = 1.5F;
        float dash = 0.0F;     ///< Length of a dash and of a gap, px; 0 = solid
        bool isInk = false;    ///< As on paper: the tree in front of it does not make it fainter
        bool isBroken = false; ///< Each two points are a line of their own
    };
    struct Dots {
        std::size_t first = 0; ///< Index of the first point in points()
        std::size_t count = 0;
        QColor colour;
        float size = 5.0F; ///< Diameter of the bright middle, px
        float glow = 0.0F; ///< Strength of the halo around it, 0...1
    };
    /// A faint grid in a plane, fading out from its middle.
    struct Grid {
        Vec3 centre = Vec3::Zero();
        Vec3 right = Vec3::UnitX(); ///< Unit
        Vec3 up = Vec3::UnitY();    ///< Unit
        float extent = 1.0F;        ///< m, from the middle to where it has faded
        float spacing = 0.25F;      ///< m
        Vec3 origin = Vec3::Zero(); ///< A point of the plane where two lines of the grid cross
        QColor colour;
    };
    /// Words beside a point; always in front, and never over each other.
    struct Label {
        Vec3 place = Vec3::Zero();
        QPointF offset; ///< From the point to the left end of the words, px
        QString text;
        QColor colour;
        std::optional<InternodeId> subject{}; ///< The internode whose property a tap on the label edits
    };

    /// A translucent surface, transparent where it faces the camera.
    struct Surface {
        std::shared_ptr<const EnvelopeMesh> mesh; ///< Never null
        QColor colour;
        float rim = 0.3F; ///< Opacity where the surface is seen edge-on, 0...1
    };

    void clear();
    void addSphere(const Sphere& sphere) { m_spheres.push_back(sphere); }
    void addLine(std::span<const Vec3> points, const QColor& colour, float width, float dash = 0.0F);
    /// The same, with Line::isInk.
    void addInk(std::span<const Vec3> points, const QColor& colour, float width, float dash = 0.0F);
    /// Lines from the first point to the second, from the third to the fourth, and so on.
    void addSegments(std::span<const Vec3> points, const QColor& colour, float width);
    void addDots(std::span<const Vec3> points, const QColor& colour, float size, float glow = 0.0F);
    void addLabel(const Label& label) { m_labels.push_back(label); }
    void addSurface(const Surface& surface) { m_surfaces.push_back(surface); }
    void addGrid(const Grid& grid) { m_grids.push_back(grid); }
    /// A circle as a line; @p u and @p v are perpendicular unit vectors.
    void addCircle(const Vec3& centre, const Vec3& u, const Vec3& v, float radius, const QColor& colour,
                   float width);

    const std::vector<Sphere>& spheres() const { return m_spheres; }
    const std::vector<Surface>& surfaces() const { return m_surfaces; }
    const std::vector<Line>& lines() const { return m_lines; }
    const std::vector<Dots>& dots() const { return m_dots; }
    const std::vector<Grid>& grids() const { return m_grids; }
    const std::vector<Label>& labels() const { return m_labels; }
    std::span<const Vec3> points() const { return m_points; }

private:
    std::vector<Sphere> m_spheres;
    std::vector<Surface> m_surfaces;
    std::vector<Line> m_lines;
    std::vector<Dots> m_dots;
    std::vector<Grid> m_grids;
    std::vector<Label> m_labels;
    std::vector<Vec3> m_points;
};

} // namespace espalier
