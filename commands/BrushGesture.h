// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/growth/BrushGrowth.h"
#include "model/growth/BrushSample.h"

#include <memory>

namespace espalier {

/// A brush stroke while it is made: the tree grows as samples come in, at a fixed number of growth steps a second of the
/// stroke's own time, so that the same samples give the same tree, live or replayed. finish() makes it one undo step, cancel()
/// takes it back; a gesture that is destroyed unfinished is cancelled.
class BrushGesture {
public:
    BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors = {});
    ~BrushGesture();
    BrushGesture(const BrushGesture&) = delete;
    BrushGesture& operator=(const BrushGesture&) = delete;

    /// Grows up to the sample's time. While the hand rests, send samples of the resting place (a timer does): growth goes on.
    /// Samples earlier than the last one are ignored.
    void add(const BrushSample& sample);
    void finish();
    void cancel();

    /// The living markers of free space, for showing them.
    std::span<const Vec3> markers() const { return m_growth.markers(); }
    const std::vector<BrushSample>& samples() const { return m_samples; }

private:
    TreeDocument& m_document;
    BrushGrowth m_growth;
    std::vector<BrushSample> m_samples;
    BrushSample m_last; ///< Where the last growth step was made
    Journal m_deltas;
    std::uint64_t m_stepsDone = 0;
    bool m_ended = false;
};

} // namespace espalier
