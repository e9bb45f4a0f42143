// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <array>

namespace espalier {

/// The angles of buds, with their sines and cosines, for many queries with the same parameters.
class BudAngles {
public:
    explicit BudAngles(const GrowthParameters& grown);

    /// Whether the angles are those of @p grown.
    bool areOf(const GrowthParameters& grown) const
    {
        return m_branchingAngle == grown.branchingAngle && m_irregularity == grown.irregularity &&
               m_lateralsPerNode == grown.lateralsPerNode;
    }

    /// Unit direction of the bud @p slot in the frame of its internode, which has the key @p key.
    Vec3 direction(InternodeKey key, int slot) const;

private:
    struct Turn {
        double cosine;
        double sine;
    };

    double m_branchingAngle;
    Turn m_branching;
    std::array<Turn, kBudSlots> m_azimuths{};
    double m_irregularity;
    int m_lateralsPerNode;
};

/// World direction, of unit length, of the bud @p slot at a node. The terminal bud points along the
/// internode. Lateral buds stand at the branching angle ψ, evenly spaced around the node from the frame's +X
/// on (TreeSketch figure 8A), with the irregularity of the parameters that the internode grew with.
/// Adventitious buds stand in a spiral of the golden angle.
/// @param key      of the internode
/// @param rotation world frame of the internode
/// @param grown    parameters that the internode grew with
Vec3 budDirection(InternodeKey key, int slot, const Rotation& rotation, const GrowthParameters& grown);

/// The buds of a new internode; all of them are active.
BudMask newBuds(const GrowthParameters& parameters);

} // namespace espalier
