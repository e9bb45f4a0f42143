// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"
#include "model/envelope/EnvelopeSet.h"

#include <optional>

namespace espalier {

/// Growth into envelopes (TreeSketch §3.2): markers fill them uniformly, and the tree grows until it reaches
/// no more markers; branches do not leave the envelopes. Thin parts and rims are then filled a second time,
/// more densely, because there are no branches behind them that would close gaps. Where no bud perceives the
/// remaining markers, a bare shoot grows there from the nearest bud: the trunk of a seedling into a crown
/// above it, a branch from one part of a topiary to the next.
class EnvelopeGrowth : public GrowthProcess {
public:
    /// Growth ends after this number of steps, even if markers are left.
    static constexpr int kMostSteps = 600;

    /// Only the buds that @p competitors names may grow.
    EnvelopeGrowth(EnvelopeSet envelopes, const Tree& tree, Competitors competitors = {});

    TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model) override;
    std::span<const Vec3> markers() const override { return m_markers.positions; }

private:
    /// A shoot on its way to markers that no bud perceives.
    struct Leader {
        BudRef tip;
        Vec3 target = Vec3::Zero();
        int remaining = 0; ///< internodes
    };

    bool isInside(const Tree& tree, const TreeIndex& index) const;
    void layMarkers(const Tree& tree);
    TreeDelta lead(const Tree& tree, const TreeIndex& index, const Perception& perception);
    std::optional<Leader> nextLeader(const Tree& tree, const TreeIndex& index, const Perception& perception);

    EnvelopeSet m_envelopes;
    Competitors m_competitors;
    MarkerSet m_markers;
    GrowthWorkspace m_workspace;
    std::optional<Leader> m_leader;
    bool m_hasEntered = false;    ///< Whether a bud is inside an envelope
    bool m_isInThinParts = false; ///< Whether this is the second filling
    int m_steps = 0;
    int m_leaders = 0;
};

} // namespace espalier
