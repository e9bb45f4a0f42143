// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/RepeatedGrowth.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "model/document/Edit.h"
#include "model/growth/BrushGrowth.h"
#include "model/growth/BrushSample.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace espalier {

/// A hand that gives no sample for longer than this, s, rests.
constexpr double kBrushRest = 0.1;

/// A brush stroke while it is made: the tree grows as samples come in, at a fixed number of growth steps a
/// second of the stroke's own time, so that the same samples give the same tree, live or replayed, on a slow
/// machine as well. A stroke that arrives goes on growing when it has ended (StrokeEnd). finish() makes it
/// one undo step, and another edit that begins finishes it; cancel() takes it back, and so does the
/// destructor of an unfinished gesture.
class BrushGesture {
public:
    BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors = {},
                 StrokeEnd end = StrokeEnd::AtRelease, const StrokePlacement& placement = {});

    /// Grows up to the sample's time. A sample that is not later than the last one is ignored.
    void add(const BrushSample& sample);
    /// Grows up to @p time on the way to @p next, the sample to be added next: the same growth in smaller
    /// parts.
    void moveToward(const BrushSample& next, double time);

    /// Adds a sample of a hand without growing. A hand that has given none for kBrushRest has rested until so
    /// long before this sample.
    void follow(const BrushSample& sample);
    /// The hand has given no sample up to @p time, s: the brush rests.
    void rest(double time);
    /// Grows as far as the samples and the rest go, but not much longer than @p longest.
    void catchUp(std::chrono::nanoseconds longest);

    /// Grows one step after the last sample. Returns false, and does nothing, when there is nothing to grow.
    bool settle();
    /// Grows what is left to grow and ends the stroke.
    void finish();
    void cancel() { m_edit.cancel(); }

    /// The living markers of free space, m, for display.
    std::span<const Vec3> markers() const { return m_growth.markers(); }
    /// Where the brush is when it is drawn at @p point: there, or where the stroke's placement has its
    /// copies, m.
    std::vector<Vec3> placed(const Vec3& point) const { return m_growth.placed(point); }
    /// The path of the brush, for display: the samples, and the ends of the parts between them.
    const std::vector<BrushSample>& path() const { return m_path; }

private:
    /// The stroke so far as an operation.
    BrushStrokeOperation operation() const;
    void holdUntil(double time);
    bool growNext();
    void growAlong(std::span<const BrushSample> way);

    Edit m_edit;
    StrokeEnd m_end;
    RepeatedGrowth m_growth;
    BudReference m_only;
    std::vector<BrushSample> m_path;
    std::vector<BrushSample> m_samples; ///< Samples added so far
    BrushSample m_next;                 ///< The sample that moveToward() had last
    BrushSample m_last;                 ///< The brush at the last growth step
    std::size_t m_met = 0;              ///< Index of the last sample before the last growth step
    double m_due;                       ///< The time up to which growth may go, s
    std::uint64_t m_stepsDone = 0;
};

} // namespace espalier
