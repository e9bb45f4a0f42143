// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BorchertHonda.h"

namespace espalier {

VigourShares shareVigour(double vigour, double lambda, double mainQ, double lateralQ)
{
    const double mainDemand = lambda * mainQ;
    const double lateralDemand = (1.0 - lambda) * lateralQ;
    const double demand = mainDemand + lateralDemand;
    if (!(demand > 0.0))
        return {0.0, 0.0};
    return {vigour * (mainDemand / demand), vigour * (lateralDemand / demand)};
}

VigourFlow::VigourFlow(const Tree& tree, const TreeIndex& index, const GrowthIndex& growth,
                       StampedColumn<double>& known)
    : m_tree(tree),
      m_index(index),
      m_growth(growth),
      m_lambda(tree.parameters().growth.apicalDominance),
      m_known(known)
{
    m_known.clear(tree.size());
    double whole = 0.0;
    for (const InternodeId root : index.roots()) {
        m_known.set(root, static_cast<double>(growth.basipetal(root)));
        whole += m_known[root];
    }
    m_average = whole / std::max(1U, index.livingCount());
}

double VigourFlow::into(InternodeId id)
{
    m_path.clear();
    while (!m_known.has(id)) {
        m_path.push_back(id);
        id = m_tree.parent(id);
    }
    double vigour = m_known[id];
    while (!m_path.empty()) {
        const InternodeId child = m_path.back();
        m_path.pop_back();
        vigour = ofChild(id, child, vigour);
        m_known.set(child, vigour);
        id = child;
    }
    return vigour;
}

double VigourFlow::ofBud(InternodeId id, int slot)
{
    const VigourShares shares = atNode(id, into(id));
    if (slot == kTerminalSlot)
        return shares.main;
    const double lateral = static_cast<double>(m_growth.basipetal(id)) - mainQ(id);
    if (!(lateral > 0.0))
        return 0.0;
    return shares.lateral * static_cast<double>(m_growth.lateralQ(m_tree, m_index, id, slot)) / lateral;
}

double VigourFlow::perInternode(InternodeId id)
{
    return m_average > 0.0 ? into(id) / m_index.subtreeSize(id) / m_average : 0.0;
}

VigourShares VigourFlow::atNode(InternodeId id, double vigour) const
{
    const double main = mainQ(id);
    return shareVigour(vigour, m_lambda, main, static_cast<double>(m_growth.basipetal(id)) - main);
}

double VigourFlow::mainQ(InternodeId id) const
{
    const InternodeId main = m_index.mainChild(id);
    return static_cast<double>(main == kNoInternode ? m_growth.terminalQ(m_tree, id)
                                                    : m_growth.basipetal(main));
}

double VigourFlow::ofChild(InternodeId parent, InternodeId child, double vigour) const
{
    const VigourShares shares = atNode(parent, vigour);
    if (m_tree.continuesAxis(child))
        return shares.main;
    // Several laterals share the lateral part in proportion to their Q.
    const double lateral = static_cast<double>(m_growth.basipetal(parent)) - mainQ(parent);
    return lateral > 0.0 ? shares.lateral * static_cast<double>(m_growth.basipetal(child)) / lateral : 0.0;
}

} // namespace espalier
