// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BudBreak.h"

#include "model/base/Random.h"
#include "model/growth/LightPruning.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// At a share of 1, added vigour takes this part of the inhibitor and of what the flushing rate lacks to 1.
constexpr double kAddedRelease = 0.5;

} // namespace

double breakChance(const VigourFlux& flux, const VigourParameters& p, InternodeId id)
{
    const double added = kAddedRelease * flux.addedShare(id);
    const double flushing = p.flushingRate + added * (1.0 - p.flushingRate);
    const double inhibitor = (1.0 - added) * flux.inhibitor(id);
    const double internodes = flux.rate(id) * flux.years(id) * p.growthRate / p.internodeLength;
    return std::clamp(flushing * std::exp(-inhibitor) * internodes, 0.0, 1.0);
}

bool breaks(const GrowingTree& growing, const BudRef& bud, double chance)
{
    const auto number =
        static_cast<std::uint32_t>(bud.slot) + std::uint32_t{kBudSlots} * (growing.tree().step() + 1);
    return Random(growing.key(bud.node), number, Purpose::BudDormancy).uniform() < chance;
}

std::vector<BudRef> breakingBuds(const GrowingTree& growing, const VigourFlux& flux,
                                 const VigourParameters& p)
{
    std::vector<BudRef> result;
    for (const InternodeId id : flux.nodes()) {
        const auto laterals = static_cast<unsigned>(growing.buds(id) & ~kTerminalBud);
        const bool isTip = (growing.buds(id) & kTerminalBud) != 0;
        if (laterals == 0 || isTip || flux.order(id) >= p.maximumOrder)
            continue;
        if (flux.order(id) == 0 && growing.nodePosition(id).y() < bareHeight(flux, p))
            continue;
        const double chance = breakChance(flux, p, id);
        for (unsigned rest = laterals; rest != 0; rest &= rest - 1) {
            const BudRef bud{id, std::countr_zero(rest)};
            if (flux.mayGrow(id, bud.slot) && breaks(growing, bud, chance))
                result.push_back(bud);
        }
    }
    return result;
}

} // namespace espalier
