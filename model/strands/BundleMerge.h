// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/HexLattice.h"

#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// How far bundles of strands of radius 1 are moved in the direction @p side (a unit vector) so that they lie
/// beside the bundles that are placed already: the extents of both along it and the diameter of a strand
/// (Strands 2024, equations 1 and 2). Extents are those of the centres.
float mergeDistance(std::span<const Vec2> placed, std::span<const Vec2> added, const Vec2& side);

/// A bundle of strands on the first slots of a lattice, into which other bundles are merged. Keeps its
/// buffers: use one for each thread.
class BundleMerge {
public:
    explicit BundleMerge(const HexLattice& lattice) : m_lattice(lattice) {}

    /// Begins with strands @p first... on the slots @p slots, which are the first slots of the lattice.
    void begin(std::span<const std::uint32_t> slots, std::uint32_t first);
    /// Adds the strands @p first... of a bundle that comes from the side @p side (a unit vector); their own
    /// places @p places decide which of them take which slots. It takes the slots nearest to the rim on that
    /// side; the strands there yield toward the new slots at the rim, along straight lines, slot by slot.
    void add(std::span<const Vec2> places, std::uint32_t first, const Vec2& side);
    /// Writes the slot of each strand; @p slots has as many elements as there are strands.
    void finish(std::span<std::uint32_t> slots) const;

private:
    void chooseNearest(std::uint32_t count, std::uint32_t total, const Vec2& target);
    void fill(std::uint32_t hole, std::uint32_t total, const Vec2& target);

    const HexLattice& m_lattice;
    std::vector<std::uint32_t> m_occupant; ///< By slot: a strand, or HexLattice::kNone
    std::vector<std::uint8_t> m_isTaken;   ///< By slot: among the nearest of the present add()
    std::vector<std::pair<float, std::uint32_t>> m_byDistance;
    std::vector<std::uint32_t> m_nearest;
    std::size_t m_nextNearest = 0; ///< Where fill() looks on for a strand that no line leads to
    std::vector<Vec2> m_slotPlaces;
    std::vector<std::uint32_t> m_chosen;
};

} // namespace espalier
