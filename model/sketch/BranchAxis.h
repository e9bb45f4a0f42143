// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <cstddef>
#include <vector>

namespace espalier {

/// A branch as one line: the living internodes of an axis from its base to its tip, and a frame for each that
/// does not depend on how the internodes' own frames are rolled (the turtle of L-systems; Okabe 2005, 4.3 and
/// figure 18).
///
/// A frame's +Y runs along the internode. At the base, +X is the side toward which the parent branch runs on;
/// where the branch runs in its parent's direction, and for a trunk, it is the +X of the internode's own
/// frame. From node to node the frame is carried along without a twist. So what is at the same place in the
/// frames of two branches looks alike on both.
class BranchAxis {
public:
    /// The axis that @p id is on. Precondition: @p id is alive.
    BranchAxis(const Tree& tree, const TreeIndex& index, InternodeId id);

    /// A place on the axis.
    struct Place {
        std::size_t number = 0; ///< Of the internode on the axis, from the base
        float along = 1.0F;     ///< On that internode: 0 at its lower end, 1 at its node
    };

    const std::vector<InternodeId>& internodes() const { return m_internodes; }
    /// Arc length, m, > 0.
    double length() const { return m_ends.back(); }
    /// Arc length from the base to a place, m.
    double distanceOf(const Place& place) const;
    /// The place at an arc length from the base (m, clamped to the axis). At a node it is the end of the
    /// internode below.
    Place at(double distance) const;
    /// The turtle's frame, in the world, on an internode.
    const Eigen::Quaterniond& frame(std::size_t number) const { return m_frames[number]; }

private:
    std::vector<InternodeId> m_internodes;
    std::vector<double> m_ends; ///< Arc length from the base to each node, m
    std::vector<Eigen::Quaterniond> m_frames;
};

/// A branch on a branch.
struct ChildBranch {
    InternodeId id;           ///< Its first internode, the id of its axis
    BranchAxis::Place place;  ///< On the parent's axis
    double distance;          ///< From the parent's base to the place, arc length, m
    Eigen::Vector3d heading;  ///< Of its first internode, in the turtle's frame at the place
    double downAngle() const; ///< Between the parent's direction and the heading, rad, 0...π
    /// Around the parent, from the turtle's +X toward its +Z, rad, -π...π; 0 if it runs along the parent.
    double rotationAngle() const;
};

/// The living branches on @p axis by ascending distance; keys decide between branches at the same place.
std::vector<ChildBranch> childBranches(const Tree& tree, const TreeIndex& index, const BranchAxis& axis);

} // namespace espalier
