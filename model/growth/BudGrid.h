// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VoxelSpace.h"

#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace espalier {

/// A node for a BudGrid: its position, m, and its id.
struct GridNode {
    float x;
    float y;
    float z;
    InternodeId id;

    float squaredDistance(const Vec3& point) const
    {
        const float dx = point.x() - x;
        const float dy = point.y() - y;
        const float dz = point.z() - z;
        return dx * dx + dy * dy + dz * dz;
    }
};

/// Nodes in the cubic cells of a box, for the many searches of one growth step. It is faster than VoxelSpace:
/// it has no nodes without buds, needs no hashing, and a row of cells is one run of memory. Its cost is
/// proportional to its nodes and cells, so each step makes a new one, of the nodes near the markers.
class BudGrid {
public:
    BudGrid() = default;
    /// @param edge of a cell, m, > 0; greater cells are made if there would be too many for the nodes
    BudGrid(std::span<const GridNode> nodes, float edge);

    bool isEmpty() const { return m_ids.empty(); }

    /// Calls @p visit(id, squared distance) for nodes whose squared distance from @p point, m², is @p inner
    /// to @p outer, both included, until it returns true. Returns whether it did.
    template <class Visit>
    bool anyNear(const Vec3& point, float inner, float outer, Visit&& visit) const
    {
        return anyRun(point, std::sqrt(outer), [&](std::size_t first, std::size_t last) {
            // Most blocks contain no node in range; the compiler checks a whole block with a few
            // instructions.
            for (; first + kBlock <= last; first += kBlock) {
                std::array<float, kBlock> squared;
                for (std::size_t i = 0; i < kBlock; ++i)
                    squared[i] = squaredDistance(first + i, point);
                int count = 0;
                for (const float distance : squared)
                    count += static_cast<int>(distance >= inner) & static_cast<int>(distance <= outer);
                for (std::size_t i = 0; count > 0 && i < kBlock; ++i) {
                    if (squared[i] >= inner && squared[i] <= outer && visit(m_ids[first + i], squared[i]))
                        return true;
                }
            }
            for (; first < last; ++first) {
                const float squared = squaredDistance(first, point);
                if (squared >= inner && squared <= outer && visit(m_ids[first], squared))
                    return true;
            }
            return false;
        });
    }

    /// The indices of @p points, grouped by cell: in this order, searches read memory that is still in the
    /// cache.
    std::vector<std::uint32_t> orderOf(std::span<const Vec3> points) const;

private:
    static constexpr std::size_t kBlock = 8;

    float squaredDistance(std::size_t i, const Vec3& point) const
    {
        return GridNode{m_x[i], m_y[i], m_z[i], 0}.squaredDistance(point);
    }

    /// Calls @p visit(first, last) for runs of nodes that together contain all nodes within @p radius, until
    /// it returns true. Returns whether it did.
    template <class Visit>
    bool anyRun(const Vec3& point, float radius, Visit&& visit) const
    {
        if (isEmpty())
            return false;
        const Vec3 reach = Vec3::Constant(radius + 1e-3F * m_edge); // margin for rounding at the border
        const Cell from = cellAt(point - reach);
        const Cell to = cellAt(point + reach);
        if (to.x < 0 || to.y < 0 || to.z < 0 || from.x >= m_size.x || from.y >= m_size.y ||
            from.z >= m_size.z)
            return false;
        const int xFrom = std::max(from.x, 0);
        const int xTo = std::min(to.x, m_size.x - 1);
        for (int y = std::max(from.y, 0); y <= std::min(to.y, m_size.y - 1); ++y) {
            for (int z = std::max(from.z, 0); z <= std::min(to.z, m_size.z - 1); ++z) {
                const std::uint32_t first = m_begin[cellIndex({xFrom, y, z})];
                const std::uint32_t last = m_begin[cellIndex({xTo, y, z}) + 1];
                if (first != last && visit(first, last))
                    return true;
            }
        }
        return false;
    }

    /// May lie outside the grid; points far outside get a cell just outside.
    Cell cellAt(const Vec3& point) const;
    std::size_t cellIndex(const Cell& cell) const
    {
        return static_cast<std::size_t>((cell.y * m_size.z + cell.z) * m_size.x + cell.x);
    }

    Vec3 m_origin = Vec3::Zero();
    float m_edge = 1.0F;
    Cell m_size{1, 1, 1}; ///< In cells
    // Nodes by cell.
    std::vector<InternodeId> m_ids;
    std::vector<float> m_x;
    std::vector<float> m_y;
    std::vector<float> m_z;
    std::vector<std::uint32_t> m_begin; ///< First node of each cell; one entry more than there are cells
};

} // namespace espalier
