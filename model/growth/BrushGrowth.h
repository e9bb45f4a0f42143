// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BrushSample.h"
#include "model/growth/GrowthModel.h"

#include <optional>
#include <span>

namespace espalier {

/// Growth steps a second of a stroke's own time.
inline constexpr double kBrushStepsPerSecond = 20.0;

/// Growth under a brush (TreeSketch §3.2): keeps the stroke's markers of free space and grows the tree toward
/// them. As the radius goes from the occupancy radius toward zero, growth turns into drawing: fewer side
/// shoots, more obedience to the markers; below half an internode a single axis follows the stroke exactly,
/// from a bud on. It never turns by more than a right angle from one internode to the next.
class BrushGrowth {
public:
    /// Only the buds that @p competitors names may grow.
    explicit BrushGrowth(Competitors competitors = {}) : m_competitors(competitors) {}

    /// One growth step with the brush at @p brush, having come from @p previous. Empty if nothing grew.
    TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                   const BrushSample& previous, const BrushSample& brush);

    /// World positions of the living markers.
    std::span<const Vec3> markers() const { return m_markers.positions; }

private:
    void layMarkers(const Tree& tree, const BrushSample& previous, const BrushSample& brush);
    TreeDelta draw(const Tree& tree, const TreeIndex& index, const BrushSample& previous,
                   const BrushSample& brush);

    bool beginPath(const GrowingTree& growing, float length);

    Competitors m_competitors;
    MarkerSet m_markers;
    GrowthWorkspace m_workspace;
    Step m_time = 0; ///< Steps of this stroke
    // While drawing: the bud that the drawn axis goes on from, and the path from there to the brush.
    std::optional<BudRef> m_drawnBud;
    bool m_hasDrawn = false; ///< At least one internode from there
    std::vector<Vec3> m_path;
    // Direction of the stroke, smoothed, for inferring θ; zero until the brush has moved.
    Vec3 m_strokeDirection = Vec3::Zero();
};

} // namespace espalier
