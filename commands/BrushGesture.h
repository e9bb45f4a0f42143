// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/BrushStrokeOperation.h"
#include "model/document/Edit.h"
#include "model/growth/BrushGrowth.h"
#include "model/growth/BrushSample.h"

#include <memory>

namespace espalier {

/// A brush stroke while it is made: the tree grows as samples come in, at a fixed number of growth steps a
/// second of the stroke's own time, so that the same samples give the same tree, live or replayed. finish()
/// makes it one undo step, and so does another edit that begins; cancel() takes it back; a gesture that is
/// destroyed unfinished is cancelled.
class BrushGesture {
public:
    BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors = {});

    /// Grows up to the sample's time. While the hand rests, send samples of the resting place (a timer does):
    /// growth goes on. Samples earlier than the last one are ignored.
    void add(const BrushSample& sample);
    /// Grows up to @p time on the way to @p next, a sample yet to be added: the same growth in pieces.
    void moveToward(const BrushSample& next, double time);
    void finish();
    void cancel() { m_edit.cancel(); }

    /// The living markers of free space, for showing them.
    std::span<const Vec3> markers() const { return m_growth.markers(); }
    /// Where the brush has been, for showing the stroke: the samples, and the ends of pieces between them.
    const std::vector<BrushSample>& path() const { return m_path; }

private:
    /// The stroke as it was made.
    BrushStrokeOperation operation() const;

    Edit m_edit;
    BrushGrowth m_growth;
    BudReference m_only;
    std::vector<BrushSample> m_path;
    std::vector<BrushSample> m_samples; ///< Those added
    BrushSample m_next;                 ///< That the brush was on its way to last
    BrushSample m_last;                 ///< Where the last growth step was made
    std::uint64_t m_stepsDone = 0;
};

} // namespace espalier
