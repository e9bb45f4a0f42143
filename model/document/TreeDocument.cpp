// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/TreeDocument.h"

namespace espalier {

TreeDocument::TreeDocument(QObject* parent) : QObject(parent)
{
    reset(1);
}

TreeDocument::~TreeDocument() = default;

void TreeDocument::reset(std::uint64_t seed, const TreeParameters& parameters)
{
    reset(Tree(seed, parameters), {});
}

void TreeDocument::reset(Tree tree, Journal journal)
{
    m_undoStack.clear();
    m_tree = std::move(tree);
    m_journal = std::move(journal);
    m_index.rebuild(m_tree);
    m_growthIndex.rebuild(m_tree, m_index);
    Q_EMIT changed({TreeChange::Kind::Reset, nullptr});
}

void TreeDocument::apply(std::shared_ptr<TreeDelta> delta)
{
    m_tree.apply(*delta);
    m_index.update(m_tree, *delta);
    m_growthIndex.follow(m_tree, m_index, *delta);
    m_journal.push_back(std::move(delta));
    Q_EMIT changed({TreeChange::Kind::Applied, m_journal.back().get()});
}

void TreeDocument::revertLast()
{
    Q_ASSERT(!m_journal.empty());
    const std::shared_ptr<TreeDelta> delta = std::move(m_journal.back());
    m_journal.pop_back();
    m_tree.revert(*delta);
    m_index.update(m_tree, *delta);
    m_growthIndex.follow(m_tree, m_index, *delta);
    Q_EMIT changed({TreeChange::Kind::Reverted, delta.get()});
}

std::uint32_t TreeDocument::rememberParameters(const TreeParameters& parameters)
{
    return m_tree.rememberParameters(parameters);
}

void TreeDocument::forgetLastParameters()
{
    m_tree.forgetLastParameters();
}

std::size_t TreeDocument::bytes() const
{
    std::size_t journal = 0;
    for (const auto& delta : m_journal)
        journal += delta->bytes() + sizeof(delta);
    return m_tree.bytes() + m_index.bytes() + m_growthIndex.bytes() + journal;
}

} // namespace espalier
