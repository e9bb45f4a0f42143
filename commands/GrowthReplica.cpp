// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowthReplica.h"

namespace espalier {

GrowthReplica::GrowthReplica(const Tree& tree, std::unique_ptr<GrowthModel> model,
                             std::unique_ptr<GrowthProcess> process)
    : m_tree(tree), m_model(std::move(model)), m_process(std::move(process))
{
}

GrownStep GrowthReplica::grow()
{
    if (!std::exchange(m_hasIndices, true)) {
        m_index.rebuild(m_tree);
        m_model->rebuild(m_tree, m_index);
    }
    m_model->settle(m_tree, m_index);
    TreeDelta delta = m_process->step(m_tree, m_index, *m_model);
    m_tree.apply(delta);
    m_index.update(m_tree, delta);
    m_model->follow(m_tree, m_index, delta);
    return {std::move(delta), {m_process->markers().begin(), m_process->markers().end()}};
}

} // namespace espalier
