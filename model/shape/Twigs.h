// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/shape/SeenWood.h"
#include "model/shape/Widths.h"
#include "model/tree/TreeDelta.h"

#include <limits>

namespace espalier {

/// Which wood is thin enough to be taken by a brush: all that is no thicker than a share of the thickest
/// trunk.
class TwigRule {
public:
    /// @p thickest: 0...1 of the diameter of the thickest trunk; at 1 all wood but the roots is thin.
    TwigRule(const Tree& tree, const TreeIndex& index, double thickest);

    /// Whether the living internode @p id is thin. A root never is.
    bool isThin(InternodeId id) const;

private:
    const Tree& m_tree;
    const TreeIndex& m_index;
    Widths m_widths;
    float m_limit = std::numeric_limits<float>::infinity(); ///< Radius, m
};

/// The internodes that an eraser cuts off where it has @p swept thin wood; ascending.
std::vector<InternodeId> erasedTwigs(const Swept& swept, const TwigRule& rule);

/// Takes away the thin wood that is swept, with all that it carries, and the swept placed leaves.
TreeDelta eraseTwigs(const Tree& tree, const TreeIndex& index, const Swept& swept, const TwigRule& rule);

/// Which twigs thinning takes. A twig is a thin branch of a limb or a trunk. The twigs of a limb are numbered
/// from its base on, and the multiples of the golden section, whose fractions are spread evenly over 0...1,
/// decide: so any share of them leaves even gaps. Where they begin is a function of the limb's key.
class Thinning {
public:
    /// @p share: of the twigs, 0...1
    Thinning(const Tree& tree, const TreeIndex& index, const TwigRule& rule, double share);

    /// The first internodes of the twigs that go if any of @p swept is a part of them; ascending.
    std::vector<InternodeId> cuts(const Swept& swept) const;

private:
    std::vector<InternodeId> m_twigs; ///< By internode: the twig that would go with it, or kNoInternode
};

} // namespace espalier
