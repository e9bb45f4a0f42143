// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <optional>
#include <span>

namespace espalier {

inline constexpr float kSmallestLeaf = 1e-4F; ///< m, of a placed leaf

/// The frame and length of a leaf in the world.
struct LeafBlade {
    Rotation frame = Rotation::Identity(); ///< +Y along the midrib, +Z the upper side
    float length = 0.0F;                   ///< m, from base to tip
};

/// The blade of a leaf that was drawn as a closed outline (Okabe 2005, 3.2): from its first point, the base,
/// to the point that is farthest from it. The upper side looks toward the viewer, @p toViewer, as far as the
/// midrib allows. At most kGreatestLeaf long; nothing if the outline is smaller than
/// kSmallestLeaf.
std::optional<LeafBlade> bladeOf(std::span<const Eigen::Vector3d> outline, const Eigen::Vector3d& toViewer);

/// The row of a leaf with @p blade at @p along (0...1) on a living internode.
LeafRow leafOn(const Tree& tree, const TreeIndex& index, InternodeId id, float along, const LeafBlade& blade);

/// Whether a leaf of @p tree can have these values: its internode lives, and all are within their limits;
/// leaves that the user places are at least kSmallestLeaf long.
bool isLeafPlace(const Tree& tree, const LeafRow& leaf);

/// Adds to @p delta the birth of a leaf, at the step in which the delta ends.
void addLeaf(TreeDelta& delta, const LeafRow& leaf);
/// Adds to @p delta what differs between a leaf of @p tree and @p to: internode, place, frame, length and
/// kind. Precondition: the delta does not change that leaf yet.
void moveLeaf(TreeDelta& delta, const Tree& tree, LeafId leaf, const LeafRow& to);
/// Adds to @p delta the removal of a leaf of @p tree that is not removed yet.
void removeLeaf(TreeDelta& delta, const Tree& tree, LeafId leaf);

/// The values of a placed leaf.
LeafRow leafRow(const Tree& tree, LeafId leaf);

} // namespace espalier
