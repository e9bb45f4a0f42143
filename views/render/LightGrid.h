// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VoxelSpace.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// The light of the growth model as a dense grid for a 3D texture (algorithms N). It follows growth region by
/// region: the grid has a margin, so that most steps change only a part of it.
class LightGrid {
public:
    static constexpr int kMaxEdge = 96;

    /// A box of cells of the grid.
    struct Region {
        std::array<int, 3> first{};
        std::array<int, 3> count{};
    };

    /// Samples all cells.
    void rebuild(const VoxelSpace& space);
    /// Samples the cells again that nodes can have shaded which came or went within @p changed (m).
    void update(const VoxelSpace& space, const Box3& changed);

    /// Cells along x, y, z; all 0 before rebuild().
    const std::array<int, 3>& size() const { return m_size; }
    /// Light of the cells' centres, 0...255, x fastest, then y.
    std::span<const std::uint8_t> cells() const { return m_cells; }
    /// Lowest corner, m; and edge of a cell, m.
    const Vec3& origin() const { return m_origin; }
    float cellEdge() const { return m_cellEdge; }

    /// The changes since the last call: a region, or everything (the size can differ), or nothing.
    struct Changes {
        bool all = false;
        Region region;
        bool isEmpty() const { return !all && region.count[0] == 0; }
    };
    Changes takeChanges();

private:
    void sample(const VoxelSpace& space, const Region& region);
    void addChange(const Region& region);

    std::array<int, 3> m_size{};
    std::vector<std::uint8_t> m_cells;
    Vec3 m_origin = Vec3::Zero();
    float m_cellEdge = 1.0F;
    float m_voxelEdge = 0.0F;
    int m_stride = 1; ///< Voxels along the edge of a cell
    Cell m_first;     ///< Voxel of the lowest corner
    Changes m_changes;
};

} // namespace espalier
