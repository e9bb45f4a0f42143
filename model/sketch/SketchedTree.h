// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/StrokeFit.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Names a branch or leaf of a drawing for as long as the drawing lives; ids are never given again.
using SketchId = std::uint32_t;

/// A branch of the drawing.
struct SketchedBranch {
    SketchId id = 0;
    std::optional<SketchId> parent; ///< None: the trunk
    double along = 0.0;             ///< 0...1, the base's share of the parent's arc length
    SketchLine line;                ///< Base first, two points or more. The base lies on the parent's line.
    std::vector<double> radii; ///< m, at even distances from base to tip, as drawn; empty: none was drawn

    bool operator==(const SketchedBranch&) const = default;
};

/// A leaf of the drawing.
struct SketchedLeaf {
    SketchId id = 0;
    SketchId branch = 0; ///< That carries it
    double along = 0.0;  ///< 0...1, the base's share of the branch's arc length
    SketchLine outline; ///< Closed, three points or more; the first is the base and lies on the branch's line

    bool operator==(const SketchedLeaf&) const = default;
};

/// When two strokes, drawn one after the other, are the two sides of one branch (Okabe 2005, 3.2 and figure
/// 4). The paper gives no thresholds.
struct StrokePairRule {
    double farthestEnds = 0.25; ///< Between the ends on either side, as a share of the mean length
    double farthestMean = 0.15; ///< Mean distance of the sides, as a share of the mean length
    double longest = 1.3;       ///< The longer side's length divided by the shorter's
};

/// A drawing of a tree: strokes as branches that hang together (Okabe 2005, 3.2). A value; parents come
/// before their children.
class SketchedTree {
public:
    SketchedTree() = default;

    /// The drawing of strokes in any order. The trunk is the longest open stroke among those that come near
    /// to the lowest point of all open strokes; after it the stroke that is nearest to the tree follows, one
    /// by one. Open strokes that follow each other are tried as pairs. Loops come last. Dots are left out.
    static SketchedTree ofStrokes(std::span<const SketchStroke> strokes, const StrokePairRule& rule = {});

    /// The drawing of branches that hang together already: by ascending id, parents first.
    static SketchedTree ofBranches(std::vector<SketchedBranch> branches);

    /// Adds a stroke, in metres, and returns the id of what came of it; nothing for a dot, or for a loop
    /// while there is no branch.
    ///
    /// An open stroke is a branch. The nearest branch becomes its parent, its end that is nearer to that is
    /// the base, the base moves onto the parent, the tip stays, and the displacement of the points between
    /// falls off linearly with the arc length (3.2). The first branch is the trunk, its lower end the base.
    /// If the stroke and the one added before it are the sides of one branch, that branch gets the middle
    /// line and the radii (half the distance of the sides), and keeps its id.
    ///
    /// A loop is the outline of a leaf. The point that is nearest to a branch is its base, moves onto it, and
    /// takes the other points along, the less the farther away they are.
    std::optional<SketchId> attach(const SketchStroke& stroke, const StrokePairRule& rule = {});

    const std::vector<SketchedBranch>& branches() const { return m_branches; }
    const std::vector<SketchedLeaf>& leaves() const { return m_leaves; }
    bool isEmpty() const { return m_branches.empty(); }

    /// The branch with that id, or null; valid until the drawing changes.
    const SketchedBranch* branch(SketchId id) const;

    bool operator==(const SketchedTree&) const = default;

private:
    /// The stroke that was attached last, as it was drawn, while a second side may follow.
    struct FirstSide {
        SketchId branch = 0;
        SketchLine line;
        bool operator==(const FirstSide&) const = default;
    };

    SketchId addBranch(SketchLine line, std::vector<double> radii);
    void addLeaf(SketchId id, SketchLine outline);

    std::vector<SketchedBranch> m_branches; ///< By ascending id
    std::vector<SketchedLeaf> m_leaves;     ///< By ascending id
    SketchId m_next = 0;
    std::optional<FirstSide> m_firstSide;
};

/// A branch drawn by its two sides.
struct TwoSidedBranch {
    SketchLine axis;           ///< Runs as the first side does
    std::vector<double> radii; ///< m, one for each point of the axis
};

/// The middle line of two strokes, and half their distance, at even shares of their lengths; nothing if they
/// are not the sides of one branch. The second may run either way.
std::optional<TwoSidedBranch> twoSidedBranch(const SketchLine& first, const SketchLine& second,
                                             const StrokePairRule& rule = {});

/// The shares of the arc length of @p line, ascending, at which @p stroke crosses it properly. A crossing
/// through a point between two segments counts once; an end of either line that only touches does not count.
std::vector<double> properCrossings(const SketchLine& line, const SketchLine& stroke);

} // namespace espalier
