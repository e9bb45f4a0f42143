// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/GrowthIndex.h"
#include "model/growth/StampedColumn.h"

namespace espalier {

/// Vigour at a branching point, shared between the continuing axis and all that is lateral.
struct VigourShares {
    double main;
    double lateral;
};

/// The extended Borchert-Honda split (Pałubicki 2009; TreeSketch §3.2): v_m = v λQ_m / (λQ_m + (1−λ)Q_l), v_l
/// the rest. Where nothing above can use vigour (denominator 0) both get none. @p lambda in 0...1, all Q and
/// v ≥ 0.
VigourShares shareVigour(double vigour, double lambda, double mainQ, double lateralQ);

/// Vigour that flows up from the base, for the internodes and buds that are asked for: each answer costs the
/// part of the path to the base that no answer before it has visited. The whole tree's vigour is its
/// basipetal Q (α = 1).
class VigourFlow {
public:
    VigourFlow(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
               StampedColumn<double>& known);

    /// Into internode @p id, which lives.
    double into(InternodeId id);
    /// Into the living bud @p slot at the node of @p id.
    double ofBud(InternodeId id, int slot);
    /// Vigour per internode of the branch that starts with @p id, relative to the whole tree's (what Th is
    /// compared with).
    double perInternode(InternodeId id);

private:
    VigourShares atNode(InternodeId id, double vigour) const;
    double mainQ(InternodeId id) const;
    double ofChild(InternodeId parent, InternodeId child, double vigour) const;

    const Tree& m_tree;
    const TreeIndex& m_index;
    const GrowthIndex& m_growth;
    double m_lambda;
    double m_average; ///< Vigour per living internode of the whole document
    StampedColumn<double>& m_known;
    std::vector<InternodeId> m_path;
};

} // namespace espalier
