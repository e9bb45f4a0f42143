// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VoxelSpace.h"

#include "model/base/Headroom.h"

#include <cmath>
#include <tuple>
#include <utility>

namespace espalier {

namespace {

/// Voxels further out are treated as if they were at this distance, which is far beyond any tree and fits
/// into 21 bits per coordinate.
constexpr int kFarthest = 1 << 20;

int coordinate(float value)
{
    const float limited = std::clamp(value, -static_cast<float>(kFarthest), static_cast<float>(kFarthest));
    const int truncated = static_cast<int>(limited);
    return truncated - (limited < static_cast<float>(truncated) ? 1 : 0); // floor, without a call
}

} // namespace

VoxelSpace::VoxelSpace(float edge, const ShadowPyramid& pyramid) : m_edge(edge), m_pyramid(pyramid)
{
    for (int q = 0; q <= pyramid.depth; ++q) {
        const double shadow = pyramid.intensity * std::pow(pyramid.falloff, -q);
        m_layerShadow.push_back(static_cast<std::uint32_t>(std::llround(shadow * kShadowUnit)));
    }
}

Cell VoxelSpace::cellAt(const Vec3& position) const
{
    return {coordinate(position.x() / m_edge), coordinate(position.y() / m_edge),
            coordinate(position.z() / m_edge)};
}

Vec3 VoxelSpace::centreOf(const Cell& cell) const
{
    return m_edge * Vec3(static_cast<float>(cell.x) + 0.5F, static_cast<float>(cell.y) + 0.5F,
                         static_cast<float>(cell.z) + 0.5F);
}

VoxelSpace::Place VoxelSpace::insert(InternodeId id, const Vec3& position)
{
    const Cell cell = cellAt(position);
    const std::uint32_t brick = makeBrick(cell.x >> 3, cell.y >> 3, cell.z >> 3);
    const auto voxel = static_cast<std::uint32_t>(voxelOf(cell));
    m_moves.push_back({brick, voxel, id, 1});
    m_pending.push_back({cell, 1});
    return brick * static_cast<std::uint32_t>(kVoxels) + voxel;
}

void VoxelSpace::remove(InternodeId id, Place place)
{
    const auto brick = place / static_cast<std::uint32_t>(kVoxels);
    const auto voxel = static_cast<int>(place % kVoxels);
    m_moves.push_back({brick, static_cast<std::uint32_t>(voxel), id, -1});
    const Cell& b = m_coordinates[brick];
    m_pending.push_back({{b.x * 8 + voxel % 8, b.y * 8 + voxel / 64, b.z * 8 + voxel / 8 % 8}, -1});
}

bool VoxelSpace::isAt(Place place, const Vec3& position) const
{
    const Cell cell = cellAt(position);
    return m_coordinates[place / kVoxels] == Cell{cell.x >> 3, cell.y >> 3, cell.z >> 3} &&
           voxelOf(cell) == place % kVoxels;
}

void VoxelSpace::settle()
{
    std::ranges::sort(m_moves, {}, [](const Move& move) {
        return std::tuple(move.brick, move.voxel, move.id, move.count);
    });
    for (auto first = m_moves.begin(); first != m_moves.end();) {
        const auto last =
            std::find_if(first, m_moves.end(), [&](const Move& move) { return move.brick != first->brick; });
        settle(*m_bricks[first->brick], {first, last});
        first = last;
    }
    clearScratch(m_moves);
    clearScratch(m_merged);
}

void VoxelSpace::settle(Brick& brick, std::span<const Move> moves)
{
    brick.begin.resize(kVoxels + 1, 0);
    m_merged.clear();
    m_merged.reserve(brick.residents.size() + moves.size());
    auto kept = brick.residents.begin(); // the residents before it are merged
    std::uint32_t shift = 0;             // modulo 2^32
    std::uint32_t from = 0;              // of the present voxel, before the moves
    std::size_t voxel = 0;
    for (std::size_t i = 0; i < moves.size();) {
        const Move& move = moves[i];
        for (; voxel <= move.voxel; ++voxel) {
            from = brick.begin[voxel];
            brick.begin[voxel] += shift;
        }
        int count = 0;
        for (; i < moves.size() && moves[i].voxel == move.voxel && moves[i].id == move.id; ++i)
            count += moves[i].count;
        const auto place = std::lower_bound(std::max(kept, brick.residents.begin() + from),
                                            brick.residents.begin() + brick.begin[move.voxel + 1], move.id);
        const bool wasThere = place != brick.residents.end() &&
                              place - brick.residents.begin() < brick.begin[move.voxel + 1] &&
                              *place == move.id;
        const bool isThere = static_cast<int>(wasThere) + count > 0;
        m_merged.insert(m_merged.end(), kept, place);
        kept = wasThere ? place + 1 : place;
        if (isThere)
            m_merged.push_back(move.id);
        shift += static_cast<std::uint32_t>(count);
    }
    for (; voxel < brick.begin.size(); ++voxel)
        brick.begin[voxel] += shift;
    m_merged.insert(m_merged.end(), kept, brick.residents.end());
    // Allocates no more than is needed if the array has to grow.
    brick.residents.assign(m_merged.begin(), m_merged.end());
}

void VoxelSpace::castPending()
{
    settle();
    std::ranges::sort(m_pending, {}, &Caster::cell);
    for (std::size_t i = 0; i < m_pending.size();) {
        const Cell cell = m_pending[i].cell;
        int count = 0;
        for (; i < m_pending.size() && m_pending[i].cell == cell; ++i)
            count += m_pending[i].count;
        if (count == 0)
            continue;
        if (isOverfull())
            break;
        makeBricksBelow(cell);
        forEachPyramidSlab(cell, [&](const Slab& slab) {
            Brick& brick = *m_bricks[slab.brick];
            // Modulo 2^32, so that removing a shadow is adding its complement. Whole rows are faster than
            // loops of varying length.
            const std::uint32_t shadow =
                static_cast<std::uint32_t>(count) * m_layerShadow[static_cast<std::size_t>(slab.layer)];
            std::array<std::uint32_t, kBrickEdge> row{};
            std::fill(row.begin() + slab.xFrom, row.begin() + slab.xTo + 1, shadow);
            std::uint32_t* voxels =
                brick.shadow.data() + slab.y * 64 + static_cast<std::size_t>(slab.zFrom) * 8;
            for (int z = slab.zFrom; z <= slab.zTo; ++z) {
                for (const std::uint32_t added : row)
                    *voxels++ += added;
            }
            brick.dirty[slab.y] |= slab.bits();
            if (!std::exchange(brick.listed, true))
                m_dirtyBricks.push_back(slab.brick);
        });
    }
    clearScratch(m_pending);
    for (const std::uint32_t index : m_dirtyBricks)
        m_bricks[index]->listed = false;
}

void VoxelSpace::makeBricksBelow(const Cell& cell)
{
    for (int by = (cell.y - m_pyramid.depth) >> 3; by <= cell.y >> 3; ++by) {
        // The pyramid is widest in the lowest layer of the brick that it reaches.
        const int q = std::min(m_pyramid.depth, cell.y - by * 8);
        for (int bz = (cell.z - q) >> 3; bz <= (cell.z + q) >> 3; ++bz) {
            for (int bx = (cell.x - q) >> 3; bx <= (cell.x + q) >> 3; ++bx)
                makeBrick(bx, by, bz);
        }
    }
}

std::uint64_t VoxelSpace::keyOf(int bx, int by, int bz)
{
    const auto part = [](int value) { return static_cast<std::uint64_t>(value + kFarthest) & 0x1fffff; };
    // Multiplied to spread keys over the map's buckets: std::hash of an integer is the integer itself.
    return (part(bx) << 42 | part(by) << 21 | part(bz)) * 0x9e3779b97f4a7c15U;
}

std::uint32_t VoxelSpace::makeBrick(int bx, int by, int bz)
{
    const auto [place, isNew] =
        m_index.try_emplace(keyOf(bx, by, bz), static_cast<std::uint32_t>(m_bricks.size()));
    if (isNew) {
        m_bricks.push_back(std::make_unique<Brick>());
        m_coordinates.push_back({bx, by, bz});
    }
    return place->second;
}

std::uint32_t VoxelSpace::shadow(const Cell& cell) const
{
    const Brick* brick = findBrick(cell.x >> 3, cell.y >> 3, cell.z >> 3);
    return brick == nullptr ? 0 : brick->shadow[voxelOf(cell)];
}

float VoxelSpace::lightOfShadow(std::uint32_t shadow) const
{
    const double light = 1.0 - static_cast<double>(shadow) / kShadowUnit + m_pyramid.intensity;
    return static_cast<float>(std::clamp(light, 0.0, 1.0));
}

float VoxelSpace::lightAt(const Vec3& position) const
{
    const Vec3 scaled = position / m_edge - Vec3::Constant(0.5F);
    const Cell cell{coordinate(scaled.x()), coordinate(scaled.y()), coordinate(scaled.z())};
    const Vec3 t =
        scaled - Vec3(static_cast<float>(cell.x), static_cast<float>(cell.y), static_cast<float>(cell.z));
    float sum = 0.0F;
    for (int corner = 0; corner < 8; ++corner) {
        const int dx = corner & 1;
        const int dy = (corner >> 1) & 1;
        const int dz = corner >> 2;
        const float weight = (dx != 0 ? t.x() : 1.0F - t.x()) * (dy != 0 ? t.y() : 1.0F - t.y()) *
                             (dz != 0 ? t.z() : 1.0F - t.z());
        sum += weight * light({cell.x + dx, cell.y + dy, cell.z + dz});
    }
    return std::clamp(sum, 0.0F, 1.0F);
}

VoxelSpace::Bounds VoxelSpace::bounds() const
{
    Bounds bounds;
    for (std::size_t i = 0; i < m_coordinates.size(); ++i) {
        const Cell& b = m_coordinates[i];
        const Cell lower{b.x * 8, b.y * 8, b.z * 8};
        const Cell upper{b.x * 8 + 7, b.y * 8 + 7, b.z * 8 + 7};
        if (i == 0) {
            bounds = {lower, upper};
            continue;
        }
        bounds.lower = {std::min(bounds.lower.x, lower.x), std::min(bounds.lower.y, lower.y),
                        std::min(bounds.lower.z, lower.z)};
        bounds.upper = {std::max(bounds.upper.x, upper.x), std::max(bounds.upper.y, upper.y),
                        std::max(bounds.upper.z, upper.z)};
    }
    return bounds;
}

std::size_t VoxelSpace::bytes() const
{
    // A hash map has a bucket and a linked entry for each key.
    constexpr std::size_t kEntry = sizeof(std::uint64_t) + sizeof(std::uint32_t) + 3 * sizeof(void*);
    std::size_t bytes = m_bricks.capacity() * sizeof(void*) + m_bricks.size() * (sizeof(Brick) + kEntry) +
                        m_coordinates.capacity() * sizeof(Cell) + m_moves.capacity() * sizeof(Move) +
                        m_pending.capacity() * sizeof(Caster) + m_merged.capacity() * sizeof(InternodeId) +
                        m_dirtyBricks.capacity() * sizeof(std::uint32_t);
    for (const auto& brick : m_bricks)
        bytes += brick->residents.capacity() * sizeof(InternodeId) +
                 brick->begin.capacity() * sizeof(std::uint32_t);
    return bytes;
}

} // namespace espalier
