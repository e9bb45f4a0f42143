// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <array>

namespace espalier {

/// The angles at which buds stand, prepared for many of them.
class BudAngles {
public:
    explicit BudAngles(const GrowthParameters& grown);

    /// Whether they are those of such parameters.
    bool areOf(const GrowthParameters& grown) const
    {
        return m_branchingAngle == grown.branchingAngle && m_irregularity == grown.irregularity &&
               m_lateralsPerNode == grown.lateralsPerNode;
    }

    /// Direction of the bud @p slot in its internode's frame.
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

/// World direction, of unit length, of the bud @p slot at a node: along the internode for the terminal bud,
/// else at the branching angle ψ and evenly around the node, from its frame's +X on (TreeSketch figure 8A),
/// with the irregularity of the parameters that the internode was grown with. Adventitious buds stand in a
/// spiral of the golden angle.
/// @param key      of the internode
/// @param rotation world frame of the internode
/// @param grown    parameters that it was grown with
Vec3 budDirection(InternodeKey key, int slot, const Rotation& rotation, const GrowthParameters& grown);

/// The buds that a new internode bears; all of them are active.
BudMask newBuds(const GrowthParameters& parameters);

} // namespace espalier
