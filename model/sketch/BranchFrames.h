// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/BranchPlace.h"
#include "model/tree/TreeIndex.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace espalier {

/// The living internodes of an axis from its first one to its tip, with their frames carried along it by
/// parallel transport: from one internode to the next by the least turn (Okabe 2005, 3.5, needs angles around
/// a branch that a bend and the phyllotaxis do not change). Computed in double precision.
class BranchFrames {
public:
    /// The axis that @p id, which is alive, is on.
    BranchFrames(const Tree& tree, const TreeIndex& index, InternodeId id);

    /// m, along the internodes.
    double length() const { return m_ends.back(); }
    /// The distance of a place from the branch's base along it, m; nothing if it is on another branch.
    std::optional<double> distanceOf(const BranchPlace& place) const;
    /// The place at @p distance (0...length(), m) from the base; a node belongs to the internode below it.
    BranchPlace placeAt(double distance) const;

    /// The frame @p rotation of a leaf against its internode, as a frame against the carried frame there, and
    /// the other way round. Precondition: the internode is on the branch.
    Eigen::Quaterniond carriedFrom(InternodeId id, const Rotation& rotation) const;
    Rotation localFrom(InternodeId id, const Eigen::Quaterniond& carried) const;

private:
    std::size_t rowOf(InternodeId id) const;

    std::vector<InternodeId> m_internodes;
    std::vector<double> m_ends;              ///< Distances of their nodes from the base, m
    std::vector<Eigen::Quaterniond> m_turns; ///< The carried frames against the internodes' own
};

} // namespace espalier
