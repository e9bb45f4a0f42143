// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/TreeDocument.h"

#include "model/document/PreparedTree.h"

#include <QScopedValueRollback>

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

void TreeDocument::reset(Tree tree, Journal journal, std::size_t ahead)
{
    reset(PreparedTree(std::move(tree), std::move(journal), ahead));
}

void TreeDocument::replaceBy(PreparedTree prepared)
{
    interruptEdit();
    m_undoStack.clear();
    // clear() does not make an empty stack clean.
    m_undoStack.setClean();
    m_tree = std::move(prepared.tree);
    m_journal = std::move(prepared.journal);
    m_future = std::move(prepared.future);
    m_index = std::move(prepared.index);
    m_growthModel = std::move(prepared.growthModel);
    m_pickIndex = std::move(prepared.pickIndex);
    tell({TreeChange::Kind::Reset, nullptr});
}

void TreeDocument::swapWith(PreparedTree& other)
{
    swapTree(other);
    tell({TreeChange::Kind::Exchanged, nullptr});
}

void TreeDocument::swapTree(PreparedTree& other)
{
    std::swap(m_tree, other.tree);
    std::swap(m_journal, other.journal);
    std::swap(m_future, other.future);
    std::swap(m_index, other.index);
    std::swap(m_growthModel, other.growthModel);
    std::swap(m_pickIndex, other.pickIndex);
}

void TreeDocument::setEdit(const Edit* edit, EditHooks hooks)
{
    m_edit = edit;
    m_editHooks = std::move(hooks);
}

void TreeDocument::interruptEdit()
{
    if (const auto interrupted = std::exchange(m_pausedWork, {}))
        interrupted();
    interruptOpenEdit();
}

void TreeDocument::interruptOpenEdit()
{
    // The edit whose change is being told would be destroyed while it works.
    if (m_isTelling)
        qFatal("A listener of TreeDocument::changed() began or interrupted an edit.");
    if (!m_edit)
        return;
    const EditHooks hooks = m_editHooks; // a copy: the owner may destroy the edit
    if (hooks.interrupted)
        hooks.interrupted();
    if (m_edit)
        hooks.cancel();
}

void TreeDocument::undo()
{
    interruptEdit();
    if (!m_undoStack.canUndo())
        return;
    note({EditEvent::Kind::Undone});
    m_undoStack.undo();
}

void TreeDocument::redo()
{
    interruptEdit();
    if (!m_undoStack.canRedo())
        return;
    note({EditEvent::Kind::Redone});
    m_undoStack.redo();
}

void TreeDocument::apply(std::shared_ptr<TreeDelta> delta)
{
    m_tree.apply(*delta);
    delta->rows.reset(); // the tree has them now
    m_index.update(m_tree, *delta);
    m_growthModel->follow(m_tree, m_index, *delta);
    m_pickIndex.follow(m_tree, m_index, *delta);
    m_journal.push_back(std::move(delta));
    tell({TreeChange::Kind::Applied, m_journal.back().get()});
}

void TreeDocument::revertLast()
{
    Q_ASSERT(!m_journal.empty());
    const std::shared_ptr<TreeDelta> delta = std::move(m_journal.back());
    m_journal.pop_back();
    m_tree.revert(*delta);
    m_index.update(m_tree, *delta);
    m_growthModel->follow(m_tree, m_index, *delta);
    m_pickIndex.follow(m_tree, m_index, *delta);
    tell({TreeChange::Kind::Reverted, delta.get()});
}

void TreeDocument::travelTo(std::size_t position)
{
    Q_ASSERT(position <= m_journal.size() + m_future.size());
    while (m_journal.size() > position) {
        m_future.push_back(m_journal.back());
        revertLast();
    }
    while (m_journal.size() < position) {
        const std::shared_ptr<TreeDelta> next = m_future.back();
        m_future.pop_back();
        apply(next);
    }
}

void TreeDocument::setCompetitors(const Competitors& competitors)
{
    if (competitors == m_competitors)
        return;
    m_competitors = competitors;
    Q_EMIT competitorsChanged();
}

void TreeDocument::setLook(const SceneLook& look)
{
    SceneLook wanted = look;
    keepWithinLimits(wanted);
    if (wanted == m_look)
        return;
    m_look = std::move(wanted);
    Q_EMIT lookChanged();
}

void TreeDocument::holdParameters(bool held)
{
    const bool before = areParametersHeld();
    m_parameterHolds += held ? 1 : -1;
    if (areParametersHeld() != before)
        Q_EMIT parametersHeld(held);
}

void TreeDocument::tell(const TreeChange& change)
{
    ++m_revision;
    const InternodeId node = m_competitors.node;
    const bool isSameTree = change.delta != nullptr || change.kind == TreeChange::Kind::Renumbered;
    if (node != kNoInternode && (!isSameTree || !m_tree.isAlive(node)))
        setCompetitors({});
    const QScopedValueRollback telling(m_isTelling, true);
    Q_EMIT changed(change);
}

std::size_t TreeDocument::bytes() const
{
    std::size_t journal = 0;
    for (const Journal* part : {&m_journal, &m_future}) {
        for (const auto& delta : *part)
            journal += delta->bytes() + sizeof(delta);
    }
    return m_tree.bytes() + m_index.bytes() + m_growthModel->bytes() + m_pickIndex.bytes() + journal;
}

} // namespace espalier
