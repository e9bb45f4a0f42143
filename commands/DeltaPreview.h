// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier {

/// What a drag has come to so far: a delta that stands applied while the hand moves, and that the next one
/// takes the place of. All of them count from the tree as it was before the drag, so that the whole drag ends
/// as one delta. What has not been finished is taken back.
class DeltaPreview {
public:
    explicit DeltaPreview(TreeDocument& document) : m_document(document) {}
    ~DeltaPreview() { cancel(); }
    DeltaPreview(const DeltaPreview&) = delete;
    DeltaPreview& operator=(const DeltaPreview&) = delete;

    /// @p delta starts at the tree before the drag; if it is empty, that is what stands.
    void show(TreeDelta delta);
    /// Makes what stands one undo step; nothing, if the drag has led back to where it began.
    void finish(const QString& text);
    void cancel();

    bool hasEnded() const { return m_ended; }

private:
    void takeBack();

    TreeDocument& m_document;
    std::shared_ptr<TreeDelta> m_delta; ///< Applied; or null
    bool m_ended = false;
};

} // namespace espalier
