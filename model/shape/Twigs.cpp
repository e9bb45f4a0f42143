// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Twigs.h"

#include "model/base/Random.h"
#include "model/shape/Pruning.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace espalier {

TwigRule::TwigRule(const Tree& tree, const TreeIndex& index, double thickest)
    : m_tree(tree), m_index(index), m_widths(tree, index)
{
    if (thickest >= 1.0)
        return;
    float trunk = 0.0F;
    for (const InternodeId root : index.roots()) {
        if (tree.isAlive(root))
            trunk = std::max(trunk, m_widths.radius(index, root));
    }
    m_limit = static_cast<float>(thickest) * trunk;
}

bool TwigRule::isThin(InternodeId id) const
{
    return !m_tree.isRoot(id) && m_widths.radius(m_index, id) <= m_limit;
}

std::vector<InternodeId> erasedTwigs(const Swept& swept, const TwigRule& rule)
{
    std::vector<InternodeId> cuts;
    std::ranges::copy_if(swept.internodes, std::back_inserter(cuts),
                         [&](InternodeId id) { return rule.isThin(id); });
    return cuts;
}

TreeDelta eraseTwigs(const Tree& tree, const TreeIndex& index, const Swept& swept, const TwigRule& rule)
{
    TreeDelta delta = prune(tree, index, erasedTwigs(swept, rule));
    for (const LeafId leaf : swept.leaves) {
        if (!std::ranges::binary_search(delta.died, tree.placedLeaves().internode[leaf]))
            delta.leaves.death.push_back({leaf, kNever, delta.stepAfter});
    }
    return delta;
}

Thinning::Thinning(const Tree& tree, const TreeIndex& index, const TwigRule& rule, double share)
    : m_twigs(tree.size(), kNoInternode)
{
    std::vector<std::uint8_t> goes(tree.size(), 0);
    std::vector<InternodeId> twigs; // Of one internode of a limb
    for (InternodeId axis = 0; axis < tree.size(); ++axis) {
        if (!tree.isAlive(axis) || index.axis(axis) != axis || (!tree.isRoot(axis) && rule.isThin(axis)))
            continue;
        double place = Random(tree.key(axis), 0, Purpose::Thinning).uniform();
        for (InternodeId on = axis; on != kNoInternode; on = index.mainChild(on)) {
            twigs.clear();
            for (InternodeId child = index.firstChild(on); child != kNoInternode;
                 child = index.nextSibling(child)) {
                if (child != index.mainChild(on) && rule.isThin(child))
                    twigs.push_back(child);
            }
            std::ranges::stable_sort(twigs, {}, [&](InternodeId id) { return tree.columns().along[id]; });
            for (const InternodeId twig : twigs) {
                goes[twig] = static_cast<std::uint8_t>(place < share);
                place += 1.0 / std::numbers::phi;
                place -= std::floor(place);
            }
        }
    }
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id) && !tree.isRoot(id))
            m_twigs[id] = goes[id] != 0 ? id : m_twigs[tree.parent(id)];
    }
}

std::vector<InternodeId> Thinning::cuts(const Swept& swept) const
{
    std::vector<InternodeId> cuts;
    for (const InternodeId id : swept.internodes) {
        if (m_twigs[id] != kNoInternode)
            cuts.push_back(m_twigs[id]);
    }
    std::ranges::sort(cuts);
    const auto repeated = std::ranges::unique(cuts);
    cuts.erase(repeated.begin(), repeated.end());
    return cuts;
}

} // namespace espalier
