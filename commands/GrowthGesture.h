// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"
#include "model/document/TreeDocument.h"

#include <memory>
#include <span>
#include <vector>

namespace espalier {

/// Growth without a hand, as long as somebody lets it go on: each step shows at once; finish() makes all of
/// them one undo step, whether growth has come to its end or not; cancel() takes them back, and so does
/// destroying the gesture unfinished. The steps are worked out here and now by step(); or elsewhere, by the
/// process that was taken out, and added in their order.
class GrowthGesture {
public:
    virtual ~GrowthGesture();
    GrowthGesture(const GrowthGesture&) = delete;
    GrowthGesture& operator=(const GrowthGesture&) = delete;

    /// Grows one step; false, and nothing changed, if growth has come to its end or its process is elsewhere.
    bool step();

    /// Lets the steps be worked out elsewhere from now on.
    std::unique_ptr<GrowthProcess> takeProcess() { return std::move(m_process); }
    /// Grows the step that the process has come to, from the tree as it is now; false, and nothing changed,
    /// if that is empty.
    bool add(GrownStep grown);

    void finish();
    void cancel();

    /// Steps that stand applied.
    std::size_t stepCount() const { return m_stepCount; }
    /// The living markers of free space, for showing them.
    std::span<const Vec3> markers() const { return m_markers; }

protected:
    /// @p first stands applied, @p replaced was taken out of the journal before; if they brought lassos into
    /// the tree, it had @p lassosBefore.
    GrowthGesture(TreeDocument& document, QString text, std::unique_ptr<GrowthProcess> process,
                  Journal replaced, Journal first, std::uint32_t lassosBefore);

private:
    TreeDocument& m_document;
    QString m_text;
    std::unique_ptr<GrowthProcess> m_process;
    std::vector<Vec3> m_markers;
    Journal m_replaced;
    Journal m_deltas;
    std::uint32_t m_lassosBefore;
    std::size_t m_stepCount = 0;
    bool m_ended = false;
};

} // namespace espalier
