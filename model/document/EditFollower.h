// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/EditEvent.h"
#include "model/document/GradualUndo.h"

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <vector>

namespace espalier {

/// Repeats on a document, in slices of time, what an EditListener heard of another document, for example of
/// one on a worker thread. Both must have been in the same state when the first event was heard. Afterwards
/// they are the same: tree, journal, future and undo stack.
class EditFollower {
public:
    /// @p interrupted is called when another edit of @p document begins, and before the document is saved,
    /// replaced or closed; it may destroy this object. Without it, the edit under way is cancelled.
    explicit EditFollower(TreeDocument& document, std::function<void()> interrupted = {});
    /// Cancels the edit under way; finished ones stay.
    ~EditFollower();
    EditFollower(const EditFollower&) = delete;
    EditFollower& operator=(const EditFollower&) = delete;

    void add(std::vector<EditEvent> events);
    /// Repeats events until @p time has passed, one of them at least; returns whether some are left. Undo,
    /// redo and travels are divided, too. Precondition: isInStep().
    bool advance(std::chrono::milliseconds time);
    bool isWaiting() const { return !m_events.empty(); }
    /// False once something else has changed the document, which then cannot follow any more.
    bool isInStep() const { return m_document.revision() == m_revision; }

private:
    bool step(EditEvent& event, std::chrono::milliseconds time);
    bool moveStack(int commands, std::chrono::milliseconds time);
    bool travelTowards(std::size_t position);

    TreeDocument& m_document;
    std::function<void()> m_interrupted;
    std::deque<EditEvent> m_events;
    std::unique_ptr<Edit> m_edit;        ///< Null between edits
    std::unique_ptr<GradualUndo> m_undo; ///< While an undo or redo is under way
    std::uint64_t m_revision;            ///< Of the document after the last event
};

} // namespace espalier
