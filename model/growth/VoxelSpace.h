// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/base/Vector.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <memory>
#include <span>
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

/// A node in the voxel space: its position, m, and its id.
struct Resident {
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
    bool operator==(const Resident&) const = default;
};

/// The voxel space that growth happens in: which nodes are in a voxel, and how deep in shadow it lies. Voxels
/// are kept in bricks of 8³ that exist only where something is or was, a brick's nodes in one array by voxel
/// and id, so that to look around is to read along. Shadow is a sum of integers, so that taking a caster out
/// restores it exactly.
class VoxelSpace {
public:
    using Residents = std::span<const Resident>;

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

    /// Where a node was put.
    using Place = std::uint32_t;

    /// Puts a node in: found, and its shadow cast, from the next settle() or castShadows() on.
    Place insert(InternodeId id, const Vec3& position);
    /// Takes it out, likewise; to put it in again moves it.
    void remove(InternodeId id, Place place);
    /// Whether a settled node that was put at @p place stands at @p position.
    bool isAt(InternodeId id, Place place, const Vec3& position) const;
    /// Brings the nodes that came and went to their places.
    void settle();
    /// Settles, casts and lifts the shadows that are due, then calls @p visit(residents, shadow) once for
    /// each voxel that holds a node and whose shadow changed, in an order that depends on the set of changes
    /// alone.
    template <class Visit>
    void castShadows(Visit&& visit)
    {
        castPending();
        for (const std::uint32_t index : m_dirtyBricks) {
            Brick& brick = *m_bricks[index];
            forEachBit(brick.dirty, [&](std::size_t voxel) {
                if (const Residents residents = brick.in(voxel, voxel); !residents.empty())
                    visit(residents, brick.shadow[voxel]);
            });
            brick.dirty = {};
        }
        m_dirtyBricks.clear();
    }

    /// Calls @p visit(residents) for each voxel with a node that shadows of casters in @p cells fall on, once
    /// each.
    template <class Visit>
    void forEachShaded(const std::vector<Cell>& cells, Visit&& visit) const
    {
        std::vector<BitSet> marks(m_bricks.size(), BitSet{});
        for (const Cell& cell : cells) {
            forEachPyramidSlab(cell, [&](const Slab& slab) { marks[slab.brick][slab.y] |= slab.bits(); });
        }
        for (std::size_t brick = 0; brick < marks.size(); ++brick) {
            forEachBit(marks[brick], [&](std::size_t voxel) {
                if (const Residents residents = m_bricks[brick]->in(voxel, voxel); !residents.empty())
                    visit(residents);
            });
        }
    }

    /// Calls @p visit(residents) for all nodes in the voxels @p lower … @p upper, inclusive, in runs of
    /// neighbours, until it says true; whether it did.
    template <class Visit>
    bool anyRun(const Cell& lower, const Cell& upper, Visit&& visit) const
    {
        for (int by = lower.y >> 3; by <= upper.y >> 3; ++by) {
            for (int bz = lower.z >> 3; bz <= upper.z >> 3; ++bz) {
                for (int bx = lower.x >> 3; bx <= upper.x >> 3; ++bx) {
                    const Brick* brick = findBrick(bx, by, bz);
                    if (brick != nullptr && !brick->residents.empty() &&
                        anyInBox(*brick, {bx, by, bz}, lower, upper, visit))
                        return true;
                }
            }
        }
        return false;
    }
    /// The same for all nodes at most @p radius from @p box, m, and some beyond; runs are in no order.
    template <class Visit>
    bool anyWithin(const Box3& box, float radius, Visit&& visit) const
    {
        if (m_bricks.empty())
            return false;
        // A little more, because of rounding at the very border.
        const Vec3 reach = Vec3::Constant(radius + 1e-3F * m_edge);
        const Cell lower = cellAt(box.min() - reach);
        const Cell upper = cellAt(box.max() + reach);
        const auto bricks = [](int from, int to) { return static_cast<double>((to >> 3) - (from >> 3) + 1); };
        if (bricks(lower.x, upper.x) * bricks(lower.y, upper.y) * bricks(lower.z, upper.z) <
            static_cast<double>(m_bricks.size()))
            return anyRun(lower, upper, visit);
        // A box with more bricks than there are: looking at each that there is takes less time.
        const auto isWithin = [](int brick, int from, int to) {
            return brick >= from >> 3 && brick <= to >> 3;
        };
        for (std::size_t i = 0; i < m_bricks.size(); ++i) {
            const Cell& b = m_coordinates[i];
            if (isWithin(b.x, lower.x, upper.x) && isWithin(b.y, lower.y, upper.y) &&
                isWithin(b.z, lower.z, upper.z) && anyInBox(*m_bricks[i], b, lower, upper, visit))
                return true;
        }
        return false;
    }

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
        std::array<std::uint32_t, kVoxels + 1> begin{}; ///< Of each voxel's residents
        std::vector<Resident> residents;                ///< By voxel and id
        BitSet dirty{};
        bool listed = false; ///< in m_dirtyBricks

        Residents in(std::size_t firstVoxel, std::size_t lastVoxel) const
        {
            return {residents.data() + begin[firstVoxel], residents.data() + begin[lastVoxel + 1]};
        }
    };

    /// A node that comes (+1) or goes (-1).
    struct Move {
        std::uint32_t brick;
        std::uint32_t voxel;
        Resident resident;
        int count;
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
    /// Voxels of one brick at the same height: the rectangle [xFrom, xTo] × [zFrom, zTo], inclusive.
    struct Slab {
        std::uint32_t brick;
        std::size_t y;
        int xFrom;
        int xTo;
        int zFrom;
        int zTo;
        int layer; ///< q

        /// Of the brick's voxels at that height: bit 8 z + x.
        std::uint64_t bits() const
        {
            const std::uint64_t row = ((std::uint64_t{1} << (xTo - xFrom + 1)) - 1) << xFrom;
            const std::uint64_t rows = ~std::uint64_t{0} >> (8 * (7 - zTo)) & ~std::uint64_t{0}
                                                                                  << (8 * zFrom);
            return row * 0x0101010101010101U & rows;
        }
    };
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
    void settle(Brick& brick, std::span<const Move> moves);
    void castPending();
    void makeBricksBelow(const Cell& cell);

    /// Calls @p visit(slab) for all voxels that a caster in @p cell shades. Bricks that do not exist are
    /// passed over.
    template <class Visit>
    void forEachPyramidSlab(const Cell& cell, Visit&& visit) const
    {
        for (int q = 0; q <= m_pyramid.depth; ++q) {
            const int y = cell.y - q;
            for (int bz = (cell.z - q) >> 3; bz <= (cell.z + q) >> 3; ++bz) {
                for (int bx = (cell.x - q) >> 3; bx <= (cell.x + q) >> 3; ++bx) {
                    const auto found = m_index.find(keyOf(bx, y >> 3, bz));
                    if (found == m_index.end())
                        continue;
                    visit(Slab{found->second, static_cast<std::size_t>(y & 7),
                               std::max(cell.x - q, bx * 8) & 7, std::min(cell.x + q, bx * 8 + 7) & 7,
                               std::max(cell.z - q, bz * 8) & 7, std::min(cell.z + q, bz * 8 + 7) & 7, q});
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
            const std::size_t layer = static_cast<std::size_t>(y) * 64;
            if (brick.in(layer, layer + 63).empty())
                continue;
            for (int z = zFrom; z <= zTo; ++z) {
                const std::size_t row = layer + static_cast<std::size_t>(z) * 8;
                const Residents run =
                    brick.in(row + static_cast<std::size_t>(xFrom), row + static_cast<std::size_t>(xTo));
                if (!run.empty() && visit(run))
                    return true;
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
    std::vector<Move> m_moves;
    std::vector<Resident> m_merged; ///< Scratch
    std::vector<Caster> m_pending;
    std::vector<std::uint32_t> m_dirtyBricks;
};

} // namespace espalier
