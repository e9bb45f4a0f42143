// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"
#include "model/growth/BrushGrowth.h"
#include "model/growth/StrokePlacement.h"

#include <span>
#include <vector>

namespace espalier {

/// The growth of a stroke that is made once or several times about a trunk (StrokePlacement): each copy has
/// its own markers and makes its own growth steps, in turn.
class RepeatedGrowth {
public:
    /// @p document: before the stroke
    RepeatedGrowth(const TreeDocument& document, const Competitors& competitors, StrokeEnd end,
                   const StrokePlacement& placement);

    const StrokePlacement& placement() const { return m_placement; }
    /// Applies a growth step of each copy along @p way, as it was drawn (BrushGrowth::step).
    void step(Edit& edit, std::span<const BrushSample> way);
    /// Applies a step of each copy after the stroke has ended at @p brush. Returns whether any has grown on.
    bool settle(Edit& edit, const BrushSample& brush);

    /// The living markers of all copies, m.
    std::span<const Vec3> markers() const;
    /// Where the copies of @p point are, m.
    std::vector<Vec3> placed(const Vec3& point) const;

private:
    BrushSample placed(BrushSample sample, std::size_t copy) const;
    void gatherMarkers();

    StrokePlacement m_placement;
    StrokeTurns m_turns;
    std::vector<BrushGrowth> m_growths; ///< By copy
    std::vector<Vec3> m_markers;        ///< Of all copies, if there are several
};

} // namespace espalier
