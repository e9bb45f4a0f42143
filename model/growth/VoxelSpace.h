// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/base/Vector.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

namespace espalier {

/// A voxel's integer coordinates; voxel (i, j, k) covers [i h, (i+1) h) and so on for edge length h.
struct Cell {
    int x = 0;
    int y = 0;
    int z = 0;
    auto operator<=>(const Cell&) const = default;
};

/// How one shadow caster darkens what lies below it (Pałubicki 2009; TreeSketch §3.2): in layer q below it a
/// square of (2q+1)² voxels, each by a b^-q.
struct ShadowPyramid {
    double intensity = 0.02; ///< a
    double falloff = 1.8;    ///< b
    int depth = 6;           ///< q_max
    bool operator==(const ShadowPyramid&) const = default;
};

/// The voxel space that growth happens in: which nodes are in a voxel, and how deep in shadow it lies. Voxels
/// are kept in bricks of 8³ that exist only where something is or was. Shadow is a sum of integers, so that
/// taking a caster out restores it exactly.
class VoxelSpace {
public:
    /// Shadow 1.0 in the integer unit of the sums.
    static constexpr double kShadowUnit = 1 << 18;
    static constexpr int kBrickEdge = 8;
    /// More bricks than this (half a gigabyte) are not made: the space is then overfull, and its contents are
    /// of no use. That takes a tree that is very large, or very sparse, for its voxels.
    static constexpr std::size_t kMostBricks = std::size_t{1} << 17;

    VoxelSpace() = default;
    /// @p edge of a voxel, m, > 0.
    VoxelSpace(float edge, const ShadowPyramid& pyramid);

    float edge() const { return m_edge; }
    bool isOverfull() const { return m_bricks.size() >= kMostBricks; }
    const ShadowPyramid& pyramid() const { return m_pyramid; }
    Cell cellAt(const Vec3& position) const;
    Vec3 centreOf(const Cell& cell) const;

    /// Puts a node in, or takes it out. Its shadow is cast or lifted by the next castShadows().
    void insert(InternodeId id, const Vec3& position);
    void remove(InternodeId id, const Vec3& position);
    /// Casts and lifts the shadows that are due, then calls @p visit(firstNode, shadow) once for each voxel
    /// that holds a node and whose shadow changed, in an order that depends on the set of changes alone.
    template <class Visit>
    void castShadows(Visit&& visit)
    {
        castPending();
        for (const std::uint32_t index : m_dirtyBricks) {
            Brick& brick = *m_bricks[index];
            forEachBit(brick.dirty, [&](std::size_t voxel) {
                if (brick.first[voxel] != kNoInternode)
                    visit(brick.first[voxel], brick.shadow[voxel]);
            });
            brick.dirty = {};
        }
        m_dirtyBricks.clear();
    }

    /// Calls @p visit(firstNode) for each voxel with a node that shadows of casters in @p cells fall on, once
    /// each.
    template <class Visit>
    void forEachShaded(const std::vector<Cell>& cells, Visit&& visit) const
    {
        std::vector<BitSet> marks(m_bricks.size(), BitSet{});
        for (const Cell& cell : cells) {
            forEachPyramidRow(cell, [&](std::uint32_t brick, std::size_t row, int from, int to, int) {
                marks[brick][row / 8] |= rowBits(row, from, to);
            });
        }
        for (std::size_t brick = 0; brick < marks.size(); ++brick) {
            forEachBit(marks[brick], [&](std::size_t voxel) {
                if (m_bricks[brick]->first[voxel] != kNoInternode)
                    visit(m_bricks[brick]->first[voxel]);
            });
        }
    }

    /// Calls @p visit(firstNode) for each voxel with a node among those of the box @p lower … @p upper,
    /// inclusive, until it says true; whether it did.
    template <class Visit>
    bool anyOccupied(const Cell& lower, const Cell& upper, Visit&& visit) const
    {
        for (int by = lower.y >> 3; by <= upper.y >> 3; ++by) {
            for (int bz = lower.z >> 3; bz <= upper.z >> 3; ++bz) {
                for (int bx = lower.x >> 3; bx <= upper.x >> 3; ++bx) {
                    const Brick* brick = findBrick(bx, by, bz);
                    if (brick != nullptr && brick->nodes > 0 &&
                        anyInBox(*brick, {bx, by, bz}, lower, upper, visit))
                        return true;
                }
            }
        }
        return false;
    }

    InternodeId nextInCell(InternodeId id) const { return m_next[id]; }

    /// Shadow of a voxel, in units of 1 / kShadowUnit.
    std::uint32_t shadow(const Cell& cell) const;
    /// The light that the casters in such a voxel see: 1 − s + a, clamped to 0...1 (Pałubicki 2009: C − s + a
    /// with C = 1).
    float lightOfShadow(std::uint32_t shadow) const;
    float light(const Cell& cell) const { return lightOfShadow(shadow(cell)); }
    /// Trilinear between the voxels' centres.
    float lightAt(const Vec3& position) const;

    /// The voxels that something is or was in or above: inclusive, lower > upper if there are none.
    struct Bounds {
        Cell lower{1, 1, 1};
        Cell upper{0, 0, 0};
    };
    Bounds bounds() const;

    std::size_t bytes() const;

private:
    static constexpr std::size_t kVoxels = kBrickEdge * kBrickEdge * kBrickEdge;
    using BitSet = std::array<std::uint64_t, kVoxels / 64>;

    struct Brick {
        std::array<std::uint32_t, kVoxels> shadow{};
        std::array<InternodeId, kVoxels> first;
        BitSet dirty{};
        BitSet occupied{}; ///< Voxels with a node
        std::uint32_t nodes = 0;
        bool listed = false; ///< in m_dirtyBricks
    };

    struct Caster {
        Cell cell;
        int count;
    };

    static std::uint64_t keyOf(int bx, int by, int bz);
    static std::size_t voxelOf(const Cell& cell)
    {
        return static_cast<std::size_t>((((cell.y & 7) << 3 | (cell.z & 7)) << 3) | (cell.x & 7));
    }
    static std::uint64_t rowBits(std::size_t row, int from, int to)
    {
        return ((std::uint64_t{1} << (to - from + 1)) - 1)
               << ((row % 8) * 8 + static_cast<std::size_t>(from));
    }
    template <class Visit>
    static void forEachBit(const BitSet& bits, Visit&& visit)
    {
        for (std::size_t word = 0; word < bits.size(); ++word) {
            for (std::uint64_t rest = bits[word]; rest != 0; rest &= rest - 1)
                visit(word * 64 + static_cast<std::size_t>(std::countr_zero(rest)));
        }
    }

    const Brick* findBrick(int bx, int by, int bz) const
    {
        const auto found = m_index.find(keyOf(bx, by, bz));
        return found == m_index.end() ? nullptr : m_bricks[found->second].get();
    }
    std::uint32_t makeBrick(int bx, int by, int bz);
    void castPending();
    void makeBricksBelow(const Cell& cell);

    /// Calls @p visit(brick, row, from, to, layer) for each run of voxels along x that a caster in @p cell
    /// shades; row is y·8 + z within the brick. Bricks that do not exist are passed over.
    template <class Visit>
    void forEachPyramidRow(const Cell& cell, Visit&& visit) const
    {
        for (int q = 0; q <= m_pyramid.depth; ++q) {
            const int y = cell.y - q;
            for (int bz = (cell.z - q) >> 3; bz <= (cell.z + q) >> 3; ++bz) {
                for (int bx = (cell.x - q) >> 3; bx <= (cell.x + q) >> 3; ++bx) {
                    const auto found = m_index.find(keyOf(bx, y >> 3, bz));
                    if (found == m_index.end())
                        continue;
                    const int zFrom = std::max(cell.z - q, bz * 8) & 7;
                    const int zTo = std::min(cell.z + q, bz * 8 + 7) & 7;
                    const int xFrom = std::max(cell.x - q, bx * 8) & 7;
                    const int xTo = std::min(cell.x + q, bx * 8 + 7) & 7;
                    for (int z = zFrom; z <= zTo; ++z)
                        visit(found->second, static_cast<std::size_t>((y & 7) * 8 + z), xFrom, xTo, q);
                }
            }
        }
    }

    template <class Visit>
    static bool anyInBox(const Brick& brick, const Cell& b, const Cell& lower, const Cell& upper,
                         Visit&& visit)
    {
        const auto low = [](int brickCoordinate, int limit) {
            return std::max(limit, brickCoordinate * 8) & 7;
        };
        const auto high = [](int brickCoordinate, int limit) {
            return std::min(limit, brickCoordinate * 8 + 7) & 7;
        };
        const int xFrom = low(b.x, lower.x);
        const int xTo = high(b.x, upper.x);
        const int zFrom = low(b.z, lower.z);
        const int zTo = high(b.z, upper.z);
        const int yTo = high(b.y, upper.y);
        for (int y = low(b.y, lower.y); y <= yTo; ++y) {
            for (int z = zFrom; z <= zTo; ++z) {
                const auto row = static_cast<std::size_t>(y * 8 + z);
                for (std::uint64_t rest = brick.occupied[row / 8] & rowBits(row, xFrom, xTo); rest != 0;
                     rest &= rest - 1) {
                    if (visit(brick.first[row / 8 * 64 + static_cast<std::size_t>(std::countr_zero(rest))]))
                        return true;
                }
            }
        }
        return false;
    }

    float m_edge = 0.2F;
    ShadowPyramid m_pyramid;
    std::vector<std::uint32_t> m_layerShadow;
    std::unordered_map<std::uint64_t, std::uint32_t> m_index;
    std::vector<std::unique_ptr<Brick>> m_bricks;
    std::vector<Cell> m_coordinates; ///< Of the bricks
    std::vector<InternodeId> m_next;
    std::vector<Caster> m_pending;
    std::vector<std::uint32_t> m_dirtyBricks;
};

} // namespace espalier
