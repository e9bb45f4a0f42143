// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BrushSample.h"
#include "model/growth/GrowthModel.h"

#include <optional>
#include <span>

namespace espalier {

/// Growth steps per second of a stroke's own time.
inline constexpr double kBrushStepsPerSecond = 20.0;

/// Growth under a brush (TreeSketch §3.2): keeps the stroke's markers of free space and grows the tree toward
/// them. As the radius falls from the occupancy radius to zero, growth turns into drawing: there are fewer
/// side shoots, and they follow the markers more closely. Below half an internode, a single axis follows the
/// stroke exactly, starting at a bud. It never turns by more than a right angle from one internode to the
/// next.
class BrushGrowth {
public:
    /// Only the buds that @p competitors names may grow.
    explicit BrushGrowth(Competitors competitors = {}) : m_competitors(competitors) {}

    /// One growth step with the brush at @p brush, which has moved there from @p previous. Empty if nothing
    /// grew.
    TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                   const BrushSample& previous, const BrushSample& brush);

    /// World positions of the living markers, m.
    std::span<const Vec3> markers() const { return m_markers.positions; }

private:
    std::optional<InternodeId> seedlingFor(const Tree& tree, const TreeIndex& index, const Vec3& brush,
                                           float sight) const;
    void layMarkers(const Tree& tree, const BrushSample& previous, const BrushSample& brush);
    TreeDelta draw(const Tree& tree, const TreeIndex& index, const BrushSample& previous,
                   const BrushSample& brush);

    bool beginPath(const GrowingTree& growing, float length);

    Competitors m_competitors;
    MarkerSet m_markers;
    GrowthWorkspace m_workspace;
    Step m_time = 0; ///< Growth steps of this stroke so far
    // While drawing: the bud at the end of the drawn axis, and the path from there to the brush.
    std::optional<BudRef> m_drawnBud;
    bool m_hasDrawn = false; ///< Whether at least one internode was drawn
    std::vector<Vec3> m_path;
    // Smoothed direction of the stroke, from which θ is derived; zero until the brush has moved.
    Vec3 m_strokeDirection = Vec3::Zero();
};

} // namespace espalier
