// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/MoveBranchOperation.h"
#include "model/document/Edit.h"

#include <optional>

namespace espalier {

/// A drag that moves a branch along or around the wood, or to other wood, or scales it, with all that it
/// carries. The tree follows at each call of set(). finish() makes the whole drag one undo step; cancel()
/// takes it back, and so does the destructor of an unfinished gesture. Another edit that begins finishes it.
class MoveGesture {
public:
    explicit MoveGesture(TreeDocument& document);

    /// Moves the branch as moved() does to the tree before the gesture; replaces what the call before did.
    /// Fails as moved() does; then the branch is where it was before the gesture.
    Result<void> set(const BranchMove& move);
    /// The first internode of the branch where it is now; nothing before a set() that moved it.
    std::optional<InternodeId> branch() const { return m_branch; }

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    Edit m_edit;
    MoveBranchOperation m_operation;
    std::optional<InternodeId> m_branch;
};

/// Moves a branch as one undo step: see MoveGesture::set(). Fails, and changes nothing, as that does.
Result<void> moveBranch(TreeDocument& document, const BranchMove& move);

} // namespace espalier
