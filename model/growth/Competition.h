// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowingTree.h"

#include <vector>

namespace espalier {

/// Markers of free space (TreeSketch §3.2), as columns.
struct MarkerSet {
    std::vector<Vec3> positions;
    std::vector<Step> born; ///< Growth step of the stroke that a marker appeared in

    std::size_t size() const { return positions.size(); }
    void clear();
    /// Keeps the markers for which @p keep(i), in their order.
    template <class Keep>
    void filter(Keep&& keep)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size(); ++i) {
            if (keep(i)) {
                positions[kept] = positions[i];
                born[kept] = born[i];
                ++kept;
            }
        }
        positions.resize(kept);
        born.resize(kept);
    }
};

/// Which buds compete for markers and may grow; all of them still clear the space around themselves
/// (selective growth, TreeSketch figure 9).
struct Competitors {
    /// Only this bud and what grows from it; kNoInternode lets all buds compete.
    InternodeId node = kNoInternode;
    int slot = kTerminalSlot;
};

/// How buds sense free space (TreeSketch figure 8B). Lengths in m.
struct Perception {
    float occupancy;    ///< r
    float reach;        ///< r + d
    float cosHalfAngle; ///< cos(ζ / 2), ζ being the full apex angle

    static Perception of(const GrowthParameters& parameters);
};

struct BudRef {
    InternodeId node;
    int slot;
    auto operator<=>(const BudRef&) const = default;
};

/// A bud that owns at least one marker.
struct EnabledBud {
    BudRef bud;
    Vec3 space; ///< E: the normalised sum of the unit vectors toward its markers
};

/// One round of competition for space: takes out of @p markers what lies within the occupancy radius of a
/// living bud, gives each of the others to the nearest competing bud whose volume of perception contains it
/// (at equal distance to the bud that points at it best), and returns the buds that own some, by ascending
/// node and slot. The result does not depend on the number of threads nor on the order in which nodes came
/// into their voxels.
std::vector<EnabledBud> competeForSpace(const GrowingTree& tree, const VoxelSpace& space,
                                        const Perception& perception, const Competitors& competitors,
                                        MarkerSet& markers);

/// A further round in the same growth step, which asks for the shoots' tips @p tips only: the same answer for
/// them at the cost of what is new. Of the other buds none is returned.
std::vector<EnabledBud> competeAgain(const GrowingTree& tree, const VoxelSpace& space,
                                     const Perception& perception, const Competitors& competitors,
                                     const std::vector<BudRef>& tips, MarkerSet& markers);

/// Whether @p bud is, or grows from, what @p competitors names.
bool competes(const GrowingTree& tree, const Competitors& competitors, BudRef bud);

} // namespace espalier
