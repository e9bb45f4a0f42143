// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/LightGrid.h"

#include "model/base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Voxels around the tree that growth may fill before the grid must be made again.
constexpr int kMargin = 8;

std::array<int, 3> toArray(const Cell& cell)
{
    return {cell.x, cell.y, cell.z};
}

int floorDivided(int value, int by)
{
    return value >= 0 ? value / by : -((by - 1 - value) / by);
}

} // namespace

void LightGrid::rebuild(const VoxelSpace& space)
{
    const VoxelSpace::Bounds bounds = space.bounds();
    const std::array<int, 3> lower = toArray(bounds.lower);
    const std::array<int, 3> upper = toArray(bounds.upper);
    int longest = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
        longest = std::max(longest, upper[axis] - lower[axis] + 1 + 2 * kMargin);
    m_stride = (longest + kMaxEdge - 1) / kMaxEdge;
    m_voxelEdge = space.edge();
    m_cellEdge = m_voxelEdge * static_cast<float>(m_stride);
    const bool isEmpty = upper[0] < lower[0];
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int extent = isEmpty ? 1 : upper[axis] - lower[axis] + 1 + 2 * kMargin;
        m_size[axis] = (extent + m_stride - 1) / m_stride;
    }
    m_first = isEmpty ? Cell{} : Cell{lower[0] - kMargin, lower[1] - kMargin, lower[2] - kMargin};
    m_origin = m_voxelEdge * Vec3(static_cast<float>(m_first.x), static_cast<float>(m_first.y),
                                  static_cast<float>(m_first.z));
    m_cells.resize(static_cast<std::size_t>(m_size[0]) * static_cast<std::size_t>(m_size[1]) *
                   static_cast<std::size_t>(m_size[2]));
    sample(space, {{0, 0, 0}, m_size});
    m_changes = {};
    m_changes.all = true;
}

void LightGrid::update(const VoxelSpace& space, const Box3& changed)
{
    if (m_cells.empty() || space.edge() != m_voxelEdge) {
        rebuild(space);
        return;
    }
    if (changed.isEmpty())
        return;
    // The pyramid of shadow of a node reaches as far down as to the sides.
    const int reach = space.pyramid().depth + 1;
    const std::array<int, 3> lower = toArray(space.cellAt(changed.min()));
    const std::array<int, 3> upper = toArray(space.cellAt(changed.max()));
    const std::array<int, 3> first = toArray(m_first);
    Region region;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int above = axis == 1 ? 1 : reach;
        const int from = floorDivided(lower[axis] - reach - first[axis], m_stride);
        const int to = floorDivided(upper[axis] + above - first[axis], m_stride);
        if (to >= m_size[axis] || (axis != 1 && from < 0)) {
            rebuild(space);
            return;
        }
        // Shadows below the grid's floor are below ground.
        region.first[axis] = std::max(from, 0);
        region.count[axis] = to - region.first[axis] + 1;
        if (region.count[axis] <= 0)
            return;
    }
    sample(space, region);
    addChange(region);
}

LightGrid::Changes LightGrid::takeChanges()
{
    return std::exchange(m_changes, {});
}

void LightGrid::sample(const VoxelSpace& space, const Region& region)
{
    const auto light = [&](int x, int y, int z) {
        if (m_stride == 1)
            return space.light({m_first.x + x, m_first.y + y, m_first.z + z});
        const Vec3 centre(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                          static_cast<float>(z) + 0.5F);
        return space.lightAt(m_origin + m_cellEdge * centre);
    };
    parallelFor(static_cast<std::size_t>(region.count[2]), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t layer = begin; layer < end; ++layer) {
            const int z = region.first[2] + static_cast<int>(layer);
            for (int y = region.first[1]; y < region.first[1] + region.count[1]; ++y) {
                const auto row =
                    static_cast<std::size_t>(m_size[0]) * static_cast<std::size_t>(z * m_size[1] + y);
                for (int x = region.first[0]; x < region.first[0] + region.count[0]; ++x)
                    m_cells[row + static_cast<std::size_t>(x)] =
                        static_cast<std::uint8_t>(std::lround(255.0F * light(x, y, z)));
            }
        }
    });
}

void LightGrid::addChange(const Region& region)
{
    if (m_changes.all)
        return;
    if (m_changes.isEmpty()) {
        m_changes.region = region;
        return;
    }
    Region& sum = m_changes.region;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int end = std::max(sum.first[axis] + sum.count[axis], region.first[axis] + region.count[axis]);
        sum.first[axis] = std::min(sum.first[axis], region.first[axis]);
        sum.count[axis] = end - sum.first[axis];
    }
}

} // namespace espalier
