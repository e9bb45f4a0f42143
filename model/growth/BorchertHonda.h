// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthIndex.h"
#include "model/growth/StampedColumn.h"

namespace espalier {

/// Vigour at a branching point, shared between the continuing axis and all lateral branches and buds.
struct VigourShares {
    double main;
    double lateral;
};

/// The extended Borchert-Honda split (Pałubicki 2009; TreeSketch §3.2): v_m = v λQ_m / (λQ_m + (1−λ)Q_l), v_l
/// the rest. If the denominator is 0, both are 0. @p lambda in 0...1; all Q and v ≥ 0.
VigourShares shareVigour(double vigour, double lambda, double mainQ, double lateralQ);

/// Vigour that flows up from the base, computed on demand: a query costs the part of the path to the base
/// that no earlier query has visited. The vigour of the whole tree is its basipetal Q (α = 1).
class VigourFlow {
public:
    /// @p known is memory for the results. Precondition: @p growth is settled.
    VigourFlow(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
               StampedColumn<double>& known);

    /// Vigour that flows into internode @p id, which is alive.
    double into(InternodeId id);
    /// Vigour that flows into the living bud @p slot at the node of @p id.
    double ofBud(InternodeId id, int slot);
    /// Vigour per internode of the branch that starts with @p id, relative to that of the whole tree: the
    /// value that is compared with Th.
    double perInternode(InternodeId id);

private:
    VigourShares atNode(InternodeId id, double vigour) const;
    double mainQ(InternodeId id) const;
    double ofChild(InternodeId parent, InternodeId child, double vigour) const;

    const Tree& m_tree;
    const TreeIndex& m_index;
    const GrowthIndex& m_growth;
    double m_lambda;
    double m_average; ///< Vigour per living internode of the whole tree
    StampedColumn<double>& m_known;
    std::vector<InternodeId> m_path;
};

} // namespace espalier
