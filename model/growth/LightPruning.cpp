// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/LightPruning.h"

#include <algorithm>

namespace espalier {

namespace {

/// Growth steps that a new internode is spared.
constexpr Step kSparedMonths = 12;
/// Height of the bare trunk at full shade pruning, relative to the tree's.
constexpr double kMostBareHeight = 0.4;

} // namespace

double bareHeight(const VigourFlux& flux, const VigourParameters& p)
{
    return kMostBareHeight * p.lightPruning * flux.height();
}

std::vector<std::uint8_t> pruneShaded(GrowingTree& growing, const VigourFlux& flux, const VoxelSpace& space,
                                      const VigourParameters& p, double bare,
                                      std::span<const InternodeId> spared)
{
    if (p.lightPruning <= 0.0)
        return {};
    const Tree& tree = growing.tree();
    const TreeIndex& index = growing.index();
    std::vector<std::uint8_t> isShed(tree.size(), 0);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!flux.takesPart(id) || flux.order(id) == 0)
            continue;
        const InternodeId parent = tree.parent(id);
        if (isShed[parent] == 0) {
            if (tree.step() + 1 < tree.birth(id) + kSparedMonths || index.isPlacedByHand(tree, id))
                continue;
            const bool isOnTrunk = flux.order(parent) == 0;
            const bool isLow = isOnTrunk && index.nodePosition(parent).y() < bare;
            const bool isDark = index.firstChild(id) == kNoInternode &&
                                space.light(space.cellAt(growing.nodePosition(id))) < p.lightPruning &&
                                !std::ranges::binary_search(spared, id);
            if (!isLow && !isDark)
                continue;
        }
        isShed[id] = 1;
        growing.kill(id);
    }
    return isShed;
}

} // namespace espalier
