// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthProcess.h"

#include <memory>

namespace espalier {

/// A copy of a tree that grows ahead of its document on another thread, so that the interface does not wait
/// for it. It is made from a snapshot and shares no data that is written. Its steps are those that the
/// document would make. Precondition: the document's tree changes only by these steps, by all of them, in
/// their order.
class GrowthReplica {
public:
    /// Takes constant time: the first step makes the indices.
    GrowthReplica(const Tree& tree, std::unique_ptr<GrowthModel> model,
                  std::unique_ptr<GrowthProcess> process);

    /// The next step. Calls may come from different threads, but must not overlap.
    GrownStep grow();

private:
    Tree m_tree;
    TreeIndex m_index;
    std::unique_ptr<GrowthModel> m_model;
    std::unique_ptr<GrowthProcess> m_process;
    bool m_hasIndices = false;
};

} // namespace espalier
