// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"

#include <memory>

namespace espalier {

/// A copy of a tree that grows ahead of its document on another thread, so that no hand waits for it. Made
/// from a snapshot it shares nothing that is written; its steps are those that the document would make.
/// Precondition for that: the document's tree is changed by these steps alone, all of them, in their order.
class GrowthReplica {
public:
    /// Costs nothing: what there is to be worked out is left to the first step.
    GrowthReplica(const Tree& tree, std::unique_ptr<GrowthModel> model,
                  std::unique_ptr<GrowthProcess> process);

    /// The next step. Calls must not overlap, but may come from different threads.
    GrownStep grow();

private:
    Tree m_tree;
    TreeIndex m_index;
    std::unique_ptr<GrowthModel> m_model;
    std::unique_ptr<GrowthProcess> m_process;
    bool m_hasIndices = false;
};

} // namespace espalier
