// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/Competition.h"
#include "model/growth/GrowingTree.h"
#include "model/growth/VoxelSpace.h"

#include <vector>

namespace espalier {

/// The vigour parameters that a tree with @p parameters grows by. If another model is in force, lengths and
/// angles are those of that model, so that shoots match the rest of the tree.
VigourParameters vigourParametersOf(const TreeParameters& parameters);

/// The part of a tree that a step of the vigour model grows.
struct VigourScope {
    /// Only this internode and what it carries takes part; kNoInternode for the whole tree.
    InternodeId subtree = kNoInternode;
    /// Only these buds grow; the others still inhibit and shade.
    Competitors competitors{};
    /// Growth that every shoot is due, years.
    double years = 0.0;
};

/// The growth rates of all shoots in one step of the vigour model: light and potential of each node with
/// active buds, and the inhibitor that comes down from growing tips (EvoEngine 2024, after Li et al. 2023).
/// Sums are made in the order of ids, so the result does not depend on the number of threads.
class VigourFlux {
public:
    /// @p addedYears: by id, growth from added vigour that the node's shoots get, years; or empty.
    VigourFlux(const GrowingTree& growing, const VoxelSpace& space, const VigourParameters& parameters,
               const VigourScope& scope, std::vector<float> addedYears = {});

    /// The nodes with active buds that take part, by ascending id.
    const std::vector<InternodeId>& nodes() const { return m_nodes; }
    bool takesPart(InternodeId id) const { return m_takesPart[id] != 0; }
    /// Whether the bud @p slot at the node of @p id may grow.
    bool mayGrow(InternodeId id, int slot) const;

    /// 0 for the trunk, 1 for its branches, and so on.
    int order(InternodeId id) const { return m_order[id]; }
    /// Light at the node, 0...1. Of a node of nodes(), like the functions below.
    double light(InternodeId id) const { return m_light[id]; }
    /// Growth potential, 0...1; 1 for the greatest among the nodes of which a bud may grow.
    double potential(InternodeId id) const { return m_potential[id]; }
    /// Growth rate g = factor · light · potential, 0...light.
    double rate(InternodeId id) const { return m_factor * m_light[id] * m_potential[id]; }
    /// Inhibitor at the node, from the growing tips above it; ≥ 0.
    double inhibitor(InternodeId id) const { return m_inhibitor[id]; }

    /// Height of the highest node with active buds that takes part, m.
    double height() const { return m_height; }

    /// The growth that the node's shoots get in this step, years, and which share of it is added vigour.
    double years(InternodeId id) const { return m_years + addedYears(id); }
    double addedShare(InternodeId id) const
    {
        const double sum = years(id);
        return sum > 0.0 ? addedYears(id) / sum : 0.0;
    }

private:
    void findNodes(const GrowingTree& growing, const VigourScope& scope);
    void sense(const GrowingTree& growing, const VoxelSpace& space);
    void findPotentials(const GrowingTree& growing, const VigourParameters& parameters);
    void inhibit(const GrowingTree& growing, const VigourParameters& parameters);
    double addedYears(InternodeId id) const { return m_addedYears.empty() ? 0.0 : m_addedYears[id]; }

    double m_years;
    std::vector<float> m_addedYears;
    Competitors m_competitors;
    std::vector<InternodeId> m_nodes;
    std::vector<std::uint8_t> m_takesPart;
    std::vector<std::uint8_t> m_isCompetitor; ///< Whether it descends from the competing bud
    std::vector<std::uint8_t> m_order;
    std::vector<float> m_light;
    std::vector<float> m_potential;
    std::vector<float> m_inhibitor;
    double m_factor = 0.0;
    double m_height = 0.0;
};

} // namespace espalier
