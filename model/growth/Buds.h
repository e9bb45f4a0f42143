// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Tree.h"

#include <array>

namespace espalier {

/// How buds stand at the nodes of internodes, by the parameters that these grew with.
struct BudForm {
    double branchingAngle; ///< ψ, rad
    double irregularity;   ///< 0...1, spread of the angles
    int laterals;          ///< At a node

    /// By TreeSketch's parameters, whichever model is in force.
    BudForm(const GrowthParameters& p)
        : branchingAngle(p.branchingAngle), irregularity(p.irregularity), laterals(p.lateralsPerNode)
    {
    }
    /// By the parameters of the model that @p parameters name.
    BudForm(const TreeParameters& parameters);

    bool operator==(const BudForm&) const = default;
};

/// The angles of buds, with their sines and cosines, for many queries with the same parameters.
class BudAngles {
public:
    explicit BudAngles(const BudForm& form);

    /// Whether the angles are those of @p form.
    bool areOf(const BudForm& form) const { return m_form == form; }

    /// Unit direction of the bud @p slot in the frame of its internode, which has the key @p key.
    Vec3 direction(InternodeKey key, int slot) const;

private:
    struct Turn {
        double cosine;
        double sine;
    };

    BudForm m_form;
    Turn m_branching;
    std::array<Turn, kBudSlots> m_azimuths{};
};

/// World direction, of unit length, of the bud @p slot at a node. The terminal bud points along the
/// internode. Lateral buds stand at the branching angle ψ, evenly spaced around the node from the frame's +X
/// on (TreeSketch figure 8A), with the irregularity of the form.
/// Adventitious buds stand in a spiral of the golden angle.
/// @param key      of the internode
/// @param rotation world frame of the internode
/// @param form     of the parameters that the internode grew with
Vec3 budDirection(InternodeKey key, int slot, const Rotation& rotation, const BudForm& form);

/// The buds of a new internode; all of them are active.
BudMask newBuds(const BudForm& form);

} // namespace espalier
