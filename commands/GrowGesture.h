// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/growth/GrowthStep.h"

namespace espalier {

/// Growth without a hand, as long as somebody lets it go on: each step shows at once; finish() makes all of
/// them one undo step, cancel() takes them back, and so does destroying the gesture unfinished.
class GrowGesture {
public:
    explicit GrowGesture(TreeDocument& document, Competitors competitors = {});
    ~GrowGesture();
    GrowGesture(const GrowGesture&) = delete;
    GrowGesture& operator=(const GrowGesture&) = delete;

    /// Grows one step; false, and nothing changed, if the tree has no more room to grow in.
    bool step();
    void finish();
    void cancel();

private:
    TreeDocument& m_document;
    Competitors m_competitors;
    GrowthWorkspace m_workspace;
    Journal m_deltas;
    bool m_ended = false;
};

} // namespace espalier
