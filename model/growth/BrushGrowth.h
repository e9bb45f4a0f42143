// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/BrushSample.h"
#include "model/growth/GrowthModel.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace espalier {

/// Growth steps per second of a stroke's own time.
inline constexpr double kBrushStepsPerSecond = 20.0;

/// Whether what was drawn is reached, however quick the stroke was.
enum class StrokeEnd {
    AtRelease, ///< Growth ends with the stroke
    Arrives,   ///< Growth goes on after the stroke: a line to its end, a crown as long as its markers live
};

/// Growth under a brush (TreeSketch §3.2): keeps the stroke's markers of free space and grows the tree toward
/// them. As the radius falls from the occupancy radius to zero, growth turns into drawing: there are fewer
/// side shoots, and they follow the markers more closely. Below half an internode, a single axis follows the
/// stroke exactly, starting at a bud. It never turns by more than a right angle from one internode to the
/// next.
///
/// A stroke that arrives (uncertain; the paper's strokes are slow) has as many markers along a quick stroke
/// as along a slow one. Those of a thin brush live until the tree has passed them. Where no bud perceives the
/// beginning of the stroke, the nearest one grows toward it.
class BrushGrowth {
public:
    /// Only the buds that @p competitors names may grow.
    explicit BrushGrowth(Competitors competitors = {}, StrokeEnd end = StrokeEnd::AtRelease)
        : m_competitors(competitors), m_end(end)
    {
    }

    /// One growth step with the brush at the end of @p way, which begins where it was at the step before and
    /// has two samples or more. Empty if nothing grew.
    TreeDelta step(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                   std::span<const BrushSample> way);

    /// One growth step after the stroke has ended at @p brush; nothing if growth has come to its end, at once
    /// with StrokeEnd::AtRelease.
    std::optional<TreeDelta> settle(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                                    const BrushSample& brush);

    /// A line of the stroke begins at a bud of the first @p internodes of the tree, and at no bud that came
    /// later.
    void beginAtFirst(std::uint32_t internodes) { m_mostBegun = internodes; }

    /// World positions of the living markers, m.
    std::span<const Vec3> markers() const { return m_markers.positions; }

private:
    void dropOldMarkers(const Tree& tree);
    TreeDelta growTowardMarkers(const Tree& tree, const TreeIndex& index, const GrowthModel& model,
                                const BrushSample& brush);
    std::optional<BudRef> seedlingFor(const Tree& tree, const TreeIndex& index, const Vec3& brush,
                                      float sight) const;
    std::optional<BudRef> budToReachOut(const Tree& tree, const TreeIndex& index, float sight) const;
    double newMarkerCount(const GrowthParameters& parameters, std::span<const BrushSample> way) const;
    void layMarkers(const Tree& tree, std::span<const BrushSample> way);
    TreeDelta draw(const Tree& tree, const TreeIndex& index, std::span<const BrushSample> way);
    TreeDelta drawPath(const Tree& tree, const TreeIndex& index);
    std::optional<TreeDelta> drawRest(const Tree& tree, const TreeIndex& index);
    void passNewNodes(const Tree& tree, const TreeIndex& index);

    bool beginPath(const GrowingTree& growing, float length);

    Competitors m_competitors;
    std::uint32_t m_mostBegun = kNoInternode; ///< A line begins at one of so many internodes
    StrokeEnd m_end;
    MarkerSet m_markers;
    GrowthWorkspace m_workspace;
    Step m_time = 0; ///< Growth steps of this stroke so far
    // While drawing: the bud at the end of the drawn axis, and the path from there to the brush.
    std::optional<BudRef> m_drawnBud;
    bool m_hasDrawn = false; ///< Whether at least one internode was drawn
    std::vector<Vec3> m_path;
    // Smoothed direction of the stroke, from which θ is derived; zero until the brush has moved.
    Vec3 m_strokeDirection = Vec3::Zero();
    // Of a stroke that arrives.
    std::vector<BrushSample> m_line;      ///< The way of the brush
    std::vector<std::size_t> m_lineSizes; ///< By growth step: the size of m_line then
    std::size_t m_passed = 0; ///< Number of m_line's points that the tree has reached, in their order
    std::optional<std::uint32_t> m_metNodes; ///< Number of internodes at the last look at m_passed
    bool m_isReachingOut = false;            ///< The last step grew toward a line that no bud perceives
    int m_idle = 0;                          ///< Steps without growth since the last that grew
    int m_settlingSteps = 0;
    bool m_hasSettled = false;
};

} // namespace espalier
