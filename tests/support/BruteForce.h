// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowthIndex.h"

#include <map>
#include <vector>

/// The same results as from model/growth, computed directly from the papers' formulas: all pairs of markers
/// and buds, all pairs of casters and buds, plain recursion. In double precision where that does not change
/// the meaning.
namespace espalier::test {

/// One round of competition for space.
struct BruteCompetition {
    std::vector<Vec3> freeMarkers;
    std::vector<EnabledBud> enabled; ///< By ascending node and slot
};
BruteCompetition bruteCompetition(const GrowingTree& tree, const Perception& perception,
                                  const Competitors& competitors, const MarkerSet& markers);

/// @p markers without those for which the last bits of a float decide: on the border of a bud's zone, or
/// equally near to two buds.
MarkerSet clearCut(const GrowingTree& tree, const Perception& perception, const MarkerSet& markers);

/// Shadow of the voxel that @p position lies in, summed over all living internodes, in units of 1 /
/// VoxelSpace::kShadowUnit.
std::int64_t bruteShadow(const Tree& tree, const TreeIndex& index, const Vec3& position);

/// Q and vigour of all living buds and internodes.
struct BruteVigour {
    BruteVigour(const Tree& tree, const TreeIndex& index);

    std::map<BudRef, double> budQ;
    std::map<InternodeId, double> basipetal;
    std::map<InternodeId, double> into; ///< Vigour that flows into an internode; that of the base is its Q
    std::map<BudRef, double> ofBud;

private:
    double gather(const Tree& tree, const TreeIndex& index, InternodeId id);
    void distribute(const Tree& tree, InternodeId id);

    std::map<InternodeId, std::vector<InternodeId>> m_children;
};

/// Living internodes that @p root carries, itself included.
std::vector<InternodeId> bruteSubtree(const Tree& tree, InternodeId root);

/// Internodes that a step with the births @p born should shed, having grown from the nodes @p growingAt: by
/// ascending id.
std::vector<InternodeId> bruteShedding(const Tree& tree, const TreeIndex& index, std::span<const Vec3> born,
                                       std::span<const InternodeId> growingAt);

} // namespace espalier::test
