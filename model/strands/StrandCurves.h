// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandLayouts.h"

#include <array>

namespace espalier {

/// The strands as uniform cubic B-splines with their places at the nodes as control points (Strands 2024
/// §5.4): twice continuously differentiable, and not through the places. At the ends of a strand the last
/// control point is mirrored, so that it begins and ends at its first and last places.
///
/// Where nodes are nearer to each other than the wood is thick, the control points are means of the strand's
/// line around them (see place).
class StrandCurves {
public:
    explicit StrandCurves(const StrandLayouts& layouts) : m_layouts(layouts), m_skeleton(layouts.skeleton())
    {
    }

    /// World position of a strand at a node, m: the mean of its line within StrandLayouts::reach of the node.
    /// In it the steps from slot to slot, the way from the section of a fork to those of its branches, and
    /// the bend of a branch out of the wood below become smooth.
    Vec3 place(std::uint32_t node, std::uint32_t strand) const;

    using Controls = std::array<Vec3, 4>;
    /// The control points for the part of a strand between the node below @p node and @p node; @p strand is
    /// its number at @p node, which is no base.
    Controls controls(std::uint32_t node, std::uint32_t strand) const
    {
        const StrandNode& upper = m_skeleton.nodes[node];
        const std::uint32_t below = upper.parent;
        const std::uint32_t there = strand + upper.offset;
        Controls points;
        points[1] = place(below, there);
        points[2] = place(node, strand);
        points[0] = m_skeleton.isBase(below)
                        ? Vec3(2.0F * points[1] - points[2])
                        : place(m_skeleton.nodes[below].parent, there + m_skeleton.nodes[below].offset);
        points[3] = Vec3(2.0F * points[2] - points[1]);
        if (upper.childCount > 0) {
            const std::uint32_t child = childWith(node, strand);
            points[3] = place(child, strand - m_skeleton.nodes[child].offset);
        }
        return points;
    }

    /// The point at @p t: 0 near the lower node, 1 near the upper one.
    static Vec3 point(const Controls& c, float t)
    {
        const float s = 1.0F - t;
        return (s * s * s * c[0] + (3.0F * t * t * t - 6.0F * t * t + 4.0F) * c[1] +
                (3.0F * s * s * s - 6.0F * s * s + 4.0F) * c[2] + t * t * t * c[3]) /
               6.0F;
    }

    /// The child that a strand of @p node, which has children, passes next.
    std::uint32_t childWith(std::uint32_t node, std::uint32_t strand) const
    {
        const auto children = m_skeleton.childrenOf(node);
        std::size_t low = 0;
        std::size_t high = children.size();
        while (high - low > 1) {
            const std::size_t middle = (low + high) / 2;
            (m_skeleton.nodes[children[middle]].offset <= strand ? low : high) = middle;
        }
        return children[low];
    }

private:
    static constexpr std::size_t kMostNodes = 16;

    /// A part of a strand's line from a node away, through so many nodes at most.
    struct Line {
        std::array<Vec3, kMostNodes> points;
        std::array<float, kMostNodes> paths; ///< m, along the tree
        std::size_t count = 0;

        void add(const Vec3& point, float path)
        {
            points[count] = point;
            paths[count++] = path;
        }
        float length() const { return paths[count - 1]; }
        /// Precondition: 0 <= @p path <= length().
        Vec3 at(float path) const;
    };

    Vec3 raw(std::uint32_t node, std::uint32_t strand) const
    {
        return m_layouts.world(node, m_layouts.place(node, strand));
    }
    float lengthTo(std::uint32_t node) const
    {
        return (m_layouts.centre(node) - m_layouts.centre(m_skeleton.nodes[node].parent)).norm();
    }
    Line lineAbove(std::uint32_t node, std::uint32_t strand, const Vec3& begin, float reach) const;
    Line lineBelow(std::uint32_t node, std::uint32_t strand, const Vec3& begin, float reach) const;

    const StrandLayouts& m_layouts;
    const StrandSkeleton& m_skeleton;
};

} // namespace espalier
