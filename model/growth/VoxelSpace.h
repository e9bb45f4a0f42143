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

/// The shadow of one caster (Pałubicki 2009; TreeSketch §3.2): in layer q below it, it darkens a square of
/// (2q+1)² voxels, each by a b^-q.
struct ShadowPyramid {
    double intensity = 0.02; ///< a
    double falloff = 1.8;    ///< b
    int depth = 6;           ///< q_max
    bool operator==(const ShadowPyramid&) const = default;
};

/// The voxel space of growth: which nodes are in a voxel, and how much shadow it has. Voxels are stored in
/// bricks of 8³, which are made where they are needed. A brick's nodes are in one array, by voxel and id, so
/// that a search reads consecutive memory; their positions are those of the TreeIndex. Shadow is a sum of
/// integers, so removing a caster restores it exactly.
class VoxelSpace {
public:
    /// The nodes of some voxels.
    using Residents = std::span<const InternodeId>;

    /// Shadow 1.0 in the integer unit of the sums.
    static constexpr double kShadowUnit = 1 << 18;
    static constexpr int kBrickEdge = 8;
    /// The limit of bricks, about half a gigabyte. With more, the space is overfull, and its contents are not
    /// valid. That happens if a tree is very large, or very sparse relative to its voxels.
    static constexpr std::size_t kMostBricks = std::size_t{1} << 17;

    VoxelSpace() = default;
    /// @p edge of a voxel, m, > 0.
    VoxelSpace(float edge, const ShadowPyramid& pyramid);

    float edge() const { return m_edge; }
    bool isOverfull() const { return m_bricks.size() >= kMostBricks; }
    const ShadowPyramid& pyramid() const { return m_pyramid; }
    /// The voxel that contains a position, m.
    Cell cellAt(const Vec3& position) const;
    Vec3 centreOf(const Cell& cell) const;

    /// The voxel that a node was put into.
    using Place = std::uint32_t;

    /// Adds a node. Searches find it after the next settle(); castShadows() also casts its shadow.
    Place insert(InternodeId id, const Vec3& position);
    /// Removes a node in the same way. To move a node, remove it and insert it again.
    void remove(InternodeId id, Place place);
    /// Whether @p position is in the voxel @p place.
    bool isAt(Place place, const Vec3& position) const;
    /// Carries out the insertions and removals in the arrays of nodes.
    void settle();
    /// Calls settle(), adds and removes the shadows of the nodes inserted and removed, then calls
    /// @p visit(residents, shadow) once for each voxel that has a node and whose shadow changed. The order
    /// depends only on the set of changes.
    template <class Visit>
    void castShadows(Visit&& visit)
    {
        castPending();
        for (const std::uint32_t index : m_dirtyBricks) {
            Brick& brick = *m_bricks[index];
            if (!brick.residents.empty()) {
                forEachBit(brick.dirty, [&](std::size_t voxel) {
                    if (const Residents residents = brick.in(voxel, voxel); !residents.empty())
                        visit(residents, brick.shadow[voxel]);
                });
            }
            brick.dirty = {};
        }
        m_dirtyBricks.clear();
    }

    /// Calls @p visit(residents) once for each voxel that has a node and lies in the shadow of casters in
    /// @p cells.
    template <class Visit>
    void forEachShaded(const std::vector<Cell>& cells, Visit&& visit) const
    {
        std::vector<BitSet> marks(m_bricks.size(), BitSet{});
        for (const Cell& cell : cells) {
            forEachPyramidSlab(cell, [&](const Slab& slab) { marks[slab.brick][slab.y] |= slab.bits(); });
        }
        for (std::size_t brick = 0; brick < marks.size(); ++brick) {
            if (m_bricks[brick]->residents.empty())
                continue;
            forEachBit(marks[brick], [&](std::size_t voxel) {
                if (const Residents residents = m_bricks[brick]->in(voxel, voxel); !residents.empty())
                    visit(residents);
            });
        }
    }

    /// Calls @p visit(residents) for all nodes in the voxels @p lower … @p upper, inclusive, in runs of
    /// adjacent voxels, until it returns true. Returns whether it did.
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
    /// The same for all nodes within @p radius of @p box, m, and some beyond; the runs are in no order.
    template <class Visit>
    bool anyWithin(const Box3& box, float radius, Visit&& visit) const
    {
        if (m_bricks.empty())
            return false;
        // A margin for rounding at the border.
        const Vec3 reach = Vec3::Constant(radius + 1e-3F * m_edge);
        const Cell lower = cellAt(box.min() - reach);
        const Cell upper = cellAt(box.max() + reach);
        const auto bricks = [](int from, int to) { return static_cast<double>((to >> 3) - (from >> 3) + 1); };
        if (bricks(lower.x, upper.x) * bricks(lower.y, upper.y) * bricks(lower.z, upper.z) <
            static_cast<double>(m_bricks.size()))
            return anyRun(lower, upper, visit);
        // If the box covers more bricks than exist, it is faster to check each existing brick.
        const auto isWithin = [](int brick, int from, int to) {
            return brick >= from >> 3 && brick <= to >> 3;
        };
        for (std::size_t i = 0; i < m_bricks.size(); ++i) {
            const Cell& b = m_coordinates[i];
            if (isWithin(b.x, lower.x, upper.x) && isWithin(b.y, lower.y, upper.y) &&
                isWithin(b.z, lower.z, upper.z) && !m_bricks[i]->residents.empty() &&
                anyInBox(*m_bricks[i], b, lower, upper, visit))
                return true;
        }
        return false;
    }

    /// Shadow of a voxel, in units of 1 / kShadowUnit.
    std::uint32_t shadow(const Cell& cell) const;
    /// The light that casters in a voxel with this shadow receive: 1 − s + a, clamped to 0...1 (Pałubicki
    /// 2009: C − s + a with C = 1).
    float lightOfShadow(std::uint32_t shadow) const;
    float light(const Cell& cell) const { return lightOfShadow(shadow(cell)); }
    /// Light at a position, m, by trilinear interpolation between the centres of voxels.
    float lightAt(const Vec3& position) const;

    /// The voxels of all bricks, inclusive; lower > upper if there are none.
    struct Bounds {
        Cell lower{1, 1, 1};
        Cell upper{0, 0, 0};
    };
    Bounds bounds() const;
    /// The bricks that exist: brick (i, j, k) has the voxels from (8 i, 8 j, 8 k) on.
    const std::vector<Cell>& bricks() const { return m_coordinates; }

    std::size_t bytes() const;

private:
    static constexpr std::size_t kVoxels = kBrickEdge * kBrickEdge * kBrickEdge;
    using BitSet = std::array<std::uint64_t, kVoxels / 64>;

    struct Brick {
        std::array<std::uint32_t, kVoxels> shadow{};
        /// Of each voxel's residents; kVoxels + 1 elements, or none if the brick has never had residents
        std::vector<std::uint32_t> begin;
        std::vector<InternodeId> residents; ///< By voxel and id
        BitSet dirty{};
        bool listed = false; ///< in m_dirtyBricks

        /// Precondition: the brick has residents.
        Residents in(std::size_t firstVoxel, std::size_t lastVoxel) const
        {
            return {residents.data() + begin[firstVoxel], residents.data() + begin[lastVoxel + 1]};
        }
    };

    /// A node that is to be inserted (+1) or removed (-1).
    struct Move {
        std::uint32_t brick;
        std::uint32_t voxel;
        InternodeId id;
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

        /// The slab as bits of the brick's voxels at that height: bit 8 z + x.
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

    /// Calls @p visit(slab) for all voxels that a caster in @p cell shades, except those in bricks that do
    /// not exist.
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

    /// Precondition: the brick has residents.
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
    std::vector<InternodeId> m_merged; ///< Scratch
    std::vector<Caster> m_pending;
    std::vector<std::uint32_t> m_dirtyBricks;
};

} // namespace espalier
