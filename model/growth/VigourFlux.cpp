// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VigourFlux.h"

#include "model/base/Parallel.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// A shoot that lives on added vigour alone grows as if it had at least this light.
constexpr double kLightOfAddedVigour = 0.4;
constexpr std::size_t kNodesPerTask = 2048;

} // namespace

VigourParameters vigourParametersOf(const TreeParameters& parameters)
{
    VigourParameters vigour = parameters.vigour;
    if (parameters.growth.model == GrowthModelKind::Vigour)
        return vigour;
    const GrowthParameters& growth = parameters.growth;
    const double internodesPerYear = vigour.growthRate / vigour.internodeLength;
    vigour.internodeLength = growth.internodeLength;
    vigour.growthRate = internodesPerYear * growth.internodeLength;
    vigour.branchingAngle = growth.branchingAngle;
    vigour.lateralBuds = growth.lateralsPerNode;
    return vigour;
}

VigourFlux::VigourFlux(const GrowingTree& growing, const VoxelSpace& space,
                       const VigourParameters& parameters, const VigourScope& scope,
                       std::vector<float> addedYears)
    : m_years(scope.years), m_addedYears(std::move(addedYears)), m_competitors(scope.competitors)
{
    findNodes(growing, scope);
    sense(growing, space);
    findPotentials(growing, parameters);
    inhibit(growing, parameters);
}

bool VigourFlux::mayGrow(InternodeId id, int slot) const
{
    return m_competitors.areAll() || (id == m_competitors.node && slot == m_competitors.slot) ||
           m_isCompetitor[id] != 0;
}

void VigourFlux::findNodes(const GrowingTree& growing, const VigourScope& scope)
{
    const Tree& tree = growing.tree();
    m_takesPart.assign(tree.size(), 0);
    m_isCompetitor.assign(tree.size(), 0);
    m_order.assign(tree.size(), 0);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const InternodeId parent = tree.parent(id);
        m_takesPart[id] = scope.subtree == kNoInternode || id == scope.subtree ? 1 : 0;
        if (parent != kNoInternode) {
            const int order = m_order[parent] + (tree.continuesAxis(id) ? 0 : 1);
            m_order[id] = static_cast<std::uint8_t>(std::min(order, 255));
            m_takesPart[id] |= m_takesPart[parent];
            const bool isFirst =
                parent == m_competitors.node && tree.columns().slot[id] == m_competitors.slot;
            m_isCompetitor[id] = isFirst ? 1 : m_isCompetitor[parent];
        }
        if (m_takesPart[id] != 0 && tree.buds(id) != 0) {
            m_nodes.push_back(id);
            m_height = std::max(m_height, static_cast<double>(growing.nodePosition(id).y()));
        }
    }
}

void VigourFlux::sense(const GrowingTree& growing, const VoxelSpace& space)
{
    m_light.assign(growing.tree().size(), 0.0F);
    parallelFor(m_nodes.size(), kNodesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const InternodeId id = m_nodes[i];
            const float light = space.light(space.cellAt(growing.nodePosition(id)));
            m_light[id] = std::max(light, static_cast<float>(kLightOfAddedVigour * addedShare(id)));
        }
    });
}

void VigourFlux::findPotentials(const GrowingTree& growing, const VigourParameters& p)
{
    const Tree& tree = growing.tree();
    std::vector<float> distance; // from the root, m
    if (p.distanceControl > 0.0) {
        distance.assign(tree.size(), 0.0F);
        for (InternodeId id = 0; id < tree.size(); ++id)
            distance[id] = tree.length(id) + (tree.isRoot(id) ? 0.0F : distance[tree.parent(id)]);
    }
    int highest = 0;
    for (const InternodeId id : m_nodes)
        highest = std::max(highest, order(id));
    // Below the length of an internode, a distance would mean nothing.
    const auto decay = [&p](double length, double control) {
        return std::pow(std::max(length, p.internodeLength), -control);
    };
    m_potential.assign(tree.size(), 0.0F);
    double greatest = 0.0;
    for (const InternodeId id : m_nodes) {
        const int steps = p.apicalControl >= 1.0 ? -order(id) : highest - order(id);
        double potential = std::pow(p.apicalControl, steps);
        if (p.distanceControl > 0.0)
            potential *= decay(distance[id], p.distanceControl);
        if (p.heightControl > 0.0)
            potential *= decay(growing.nodePosition(id).y(), p.heightControl);
        m_potential[id] = static_cast<float>(potential);
        for (unsigned rest = tree.buds(id); rest != 0; rest &= rest - 1) {
            if (mayGrow(id, std::countr_zero(rest)))
                greatest = std::max(greatest, static_cast<double>(m_potential[id]));
        }
    }
    double light = 0.0;
    double desired = 0.0;
    for (const InternodeId id : m_nodes) {
        m_potential[id] =
            greatest > 0.0 ? std::min(1.0F, m_potential[id] / static_cast<float>(greatest)) : 0.0F;
        light += m_light[id];
        desired += m_light[id] * m_potential[id];
    }
    m_factor = std::clamp(light / (1.0 + desired), 0.0, 1.0);
}

void VigourFlux::inhibit(const GrowingTree& growing, const VigourParameters& p)
{
    const Tree& tree = growing.tree();
    m_inhibitor.assign(tree.size(), 0.0F);
    for (InternodeId id = tree.size(); id-- > 0;) {
        if (m_takesPart[id] == 0 || tree.isRoot(id))
            continue;
        const bool isTip = (tree.buds(id) & kTerminalBud) != 0;
        const double emission = isTip ? p.apicalDominance * m_light[id] : 0.0;
        m_inhibitor[tree.parent(id)] +=
            static_cast<float>((emission + m_inhibitor[id]) * (1.0 - p.inhibitorLoss));
    }
}

} // namespace espalier
