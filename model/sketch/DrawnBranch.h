// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/BranchPlace.h"
#include "model/tree/TreeIndex.h"

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// World position of a place, m.
Vec3 positionOf(const Tree& tree, const TreeIndex& index, const BranchPlace& place);

/// Where a line would grow from the tree.
struct Attachment {
    BranchPlace place;
    bool isReversed = false; ///< The line's last point is nearer to the tree than its first
    double distance = 0.0;   ///< Between that end and the place, in the projection's unit
};

/// A point of the world as a picture shows it; none where it does not.
using Projection = std::function<std::optional<Eigen::Vector2d>(const Vec3&)>;

/// The place on the living wood that one of the two ends of a line is nearest to, as seen in a projection
/// (Okabe 2005, 3.2); of equal ones the place on the oldest internode. @p isWood: which internodes count, all
/// if it is empty. None if no wood is seen.
std::optional<Attachment> nearestAttachment(const Tree& tree, const TreeIndex& index,
                                            const Projection& projection, const Eigen::Vector2d& first,
                                            const Eigen::Vector2d& last,
                                            const std::function<bool(InternodeId)>& isWood = {});

/// A branch as it was drawn, in space.
struct DrawnBranch {
    std::optional<BranchPlace> base; ///< None: it becomes the trunk, where there is only a seedling
    std::vector<Vec3> line;          ///< m; base first, two points or more
    std::vector<float> radii; ///< m, at even distances from base to tip; empty: what it carries decides
};

/// The edit that makes a drawn branch grow. Its first point moves onto the base, or a trunk's to the ground,
/// its tip stays, and the displacement of the points between falls off linearly (Okabe 2005, 3.2). It is
/// divided into internodes as curvePieces() says: about @p internodeLength, m, or less where chords would
/// leave the line by more than kDrawingTolerance of the tree's size. A branch that begins at the tip of
/// another one continues it. All nodes have active buds.
///
/// Fails (Kind::Input) if the line has no length, is longer than an internode or farther away than a node can
/// be, or has no base although something has grown.
Result<TreeDelta> growDrawnBranch(const Tree& tree, const TreeIndex& index, DrawnBranch branch,
                                  double internodeLength);

} // namespace espalier
