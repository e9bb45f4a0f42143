// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <optional>

namespace espalier {

/// Where around a trunk a stroke is made, and how often.
struct StrokePlacement {
    static constexpr int kMostCopies = 12;

    Vec3 around = Vec3::Zero(); ///< A point of the upright line that strokes are turned about, m
    int copies = 1;             ///< 1...kMostCopies strokes, evenly spaced about that line
    /// The stroke is turned about the line so that it leads into the widest gap between limbs of the trunk,
    /// with the length and the elevation that were drawn.
    bool isSpread = false;

    bool isUsual() const { return copies == 1 && !isSpread; }
    bool operator==(const StrokePlacement&) const = default;
};

/// The place of the trunk of @p root at @p height above the ground, m: where it first reaches it, or else its
/// tip.
Vec3 trunkAt(const Tree& tree, const TreeIndex& index, InternodeId root, float height);

/// The azimuth of the middle of the widest gap between the limbs of the tree whose trunk is nearest to @p
/// around, rad from +X toward +Z. Limbs are the branches that are at least a third as long as the longest;
/// the eight that begin nearest to the height of @p around count. Empty if there are none.
std::optional<double> widestGap(const Tree& tree, const TreeIndex& index, const Vec3& around);

/// Turns the strokes of a placement. It is a function of the tree before the stroke and of the points met.
class StrokeTurns {
public:
    /// @p reach: a stroke has a direction once it is so far from the line, m.
    StrokeTurns(const Tree& tree, const TreeIndex& index, const StrokePlacement& placement, float reach);

    /// Notes the next point of the stroke as drawn, m.
    void meet(const Vec3& point);
    /// Where @p point of the stroke as drawn is for the copy 0...copies − 1, m.
    Vec3 placed(const Vec3& point, int copy) const;

private:
    StrokePlacement m_placement;
    float m_reach;
    std::optional<double> m_gap; ///< Until the stroke has a direction
    double m_turn = 0.0;         ///< rad about the line
};

} // namespace espalier
