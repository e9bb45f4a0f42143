// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/JournalCheck.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>

namespace espalier {

namespace {

struct JournalText {
    Q_DECLARE_TR_FUNCTIONS(JournalCheck)
};

enum class ChangeFault { Fixed, NoRow, Impossible };

QString changeOf(QLatin1StringView column, ChangeFault fault)
{
    switch (fault) {
    case ChangeFault::Fixed:
        return JournalText::tr("it changes “%1”, which never changes").arg(column);
    case ChangeFault::NoRow:
        return JournalText::tr("it changes “%1” of a row that was not there").arg(column);
    case ChangeFault::Impossible:
        break;
    }
    return JournalText::tr("it changes “%1” in a way that is not possible").arg(column);
}

/// A tree that is taken back through its history. Before each delta is reverted, all conditions of reverting
/// it and of applying it again are checked.
class Rewind {
public:
    explicit Rewind(const Tree& tree);

    /// Checks @p delta as the last one of the tree. Returns what is wrong, or reverts it and returns an empty
    /// text.
    QString revert(const TreeDelta& delta);
    const Tree& tree() const { return m_tree; }

private:
    QString timeFault(const TreeDelta& delta) const;
    QString birthFault(const TreeDelta& delta) const;
    QString leafBirthFault(const TreeDelta& delta) const;
    QString leafChangeFault(const TreeDelta& delta) const;
    QString deathFault(const TreeDelta& delta);
    template <class Table, class Columns, class Changes>
    QString changeFault(const Columns& columns, const Changes& changes, std::uint32_t end);
    QString sparseFault(const TreeDelta& delta);
    QString lassoFault(const TreeDelta& delta);
    QString danglingFault(bool removesProfiles) const;

    bool isNewInRound(std::uint32_t row) { return std::exchange(m_rounds[row], m_round) != m_round; }
    void countContinuation(InternodeId id, int by);

    Tree m_tree;
    std::vector<std::uint32_t> m_rounds; ///< By row: number of the round in which it was last checked
    std::uint32_t m_round = 0;
    /// Living children that continue the axis; more than one is an error.
    std::vector<std::int32_t> m_continuations;
};

Rewind::Rewind(const Tree& tree)
    : m_tree(tree),
      m_rounds(std::max({std::size_t{tree.size()}, std::size_t{tree.placedLeaves().size()},
                         static_cast<std::size_t>(tree.lassos().size())}),
               0),
      m_continuations(tree.size(), 0)
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            countContinuation(id, 1);
    }
}

void Rewind::countContinuation(InternodeId id, int by)
{
    if (const InternodeId parent = m_tree.parent(id); parent != kNoInternode && m_tree.continuesAxis(id))
        m_continuations[parent] += by;
}

QString Rewind::revert(const TreeDelta& delta)
{
    for (const auto& look : {&Rewind::timeFault, &Rewind::birthFault, &Rewind::leafBirthFault}) {
        if (QString fault = (this->*look)(delta); !fault.isEmpty())
            return fault;
    }
    const TreeContent& content = m_tree.content();
    if (QString fault = changeFault<InternodeTable>(content.internodes, delta.internodes, delta.born.first);
        !fault.isEmpty())
        return fault;
    if (QString fault = changeFault<LeafTable>(content.leaves, delta.leaves, delta.bornLeaves.first);
        !fault.isEmpty())
        return fault;
    if (QString fault = leafChangeFault(delta); !fault.isEmpty())
        return fault;
    for (const auto& look : {&Rewind::deathFault, &Rewind::sparseFault, &Rewind::lassoFault}) {
        if (QString fault = (this->*look)(delta); !fault.isEmpty())
            return fault;
    }
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id)
        countContinuation(id, -1);
    m_tree.revertDropping(delta);
    return danglingFault(delta.kept.profiles > 0 || !delta.sparse.profile.empty());
}

QString Rewind::timeFault(const TreeDelta& delta) const
{
    if (delta.stepAfter != m_tree.step() || delta.stepBefore > delta.stepAfter)
        return JournalText::tr("its steps do not follow on from those around it");
    const auto sets = static_cast<std::uint32_t>(m_tree.parameterSets().size());
    if (delta.parametersAfter != m_tree.currentParameterSet() || delta.kept.parameters >= sets ||
        delta.parametersBefore >= sets - delta.kept.parameters)
        return JournalText::tr("its parameters do not follow on from those of the steps around it");
    bool hasAll = true;
    KeptTable::visit(
        [&](const auto&, const auto& values, std::uint32_t count) {
            hasAll = hasAll && count <= static_cast<std::uint32_t>(values.size());
        },
        m_tree.content().kept, delta.kept);
    if (!hasAll)
        return JournalText::tr("it refers to strokes or profiles that are not there");
    return {};
}

QString Rewind::birthFault(const TreeDelta& delta) const
{
    const InternodeColumns& c = m_tree.columns();
    if (delta.born.end() != m_tree.size() || delta.bornLeaves.end() != m_tree.placedLeaves().size() ||
        delta.born.first == 0)
        return JournalText::tr("its births are out of order");
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id) {
        if (c.birth[id] < delta.stepBefore || c.birth[id] > delta.stepAfter)
            return JournalText::tr("it creates an internode at another time");
        if (c.death[id] != kNever && c.death[id] != delta.stepAfter)
            return JournalText::tr("it creates an internode that is not there");
        if (c.parameterSet[id] >= m_tree.parameterSets().size())
            return JournalText::tr("it creates an internode whose parameters are not there");
    }
    return {};
}

QString Rewind::leafBirthFault(const TreeDelta& delta) const
{
    const LeafColumns& c = m_tree.placedLeaves();
    for (LeafId id = delta.bornLeaves.first; id != delta.bornLeaves.end(); ++id) {
        if (c.internode[id] >= delta.born.end())
            return JournalText::tr("it places a leaf on an internode that is not there");
        if (c.birth[id] < delta.stepBefore || c.birth[id] > delta.stepAfter)
            return JournalText::tr("it places a leaf at another time");
        if (c.death[id] != kNever)
            return JournalText::tr("it places a leaf that is not there");
    }
    return {};
}

/// Checks the changes of leaves against other rows and the steps: a leaf that exists dies at stepAfter, for
/// good, and its internode exists before and after.
QString Rewind::leafChangeFault(const TreeDelta& delta) const
{
    for (const auto& change : delta.leaves.death) {
        if (change.before != kNever || change.after != delta.stepAfter)
            return changeOf(QLatin1StringView("death"), ChangeFault::Impossible);
    }
    for (const auto& change : delta.leaves.internode) {
        if (change.before >= delta.born.first || change.after >= delta.born.end())
            return changeOf(QLatin1StringView("internode"), ChangeFault::Impossible);
    }
    return {};
}

template <class Table, class Columns, class Changes>
QString Rewind::changeFault(const Columns& columns, const Changes& changes, std::uint32_t end)
{
    QString fault;
    Table::visit(
        [&](const auto& info, const auto& column, const auto& columnChanges) {
            ++m_round;
            for (const auto& change : columnChanges) {
                if (!fault.isEmpty())
                    return;
                const QLatin1StringView name(info.name);
                if (info.edits == Edits::Never)
                    fault = changeOf(name, ChangeFault::Fixed);
                else if (change.row >= end || !isNewInRound(change.row))
                    fault = changeOf(name, ChangeFault::NoRow);
                else if (change.after != column[change.row] || info.faultOf(change.before) != nullptr)
                    fault = changeOf(name, ChangeFault::Impossible);
            }
        },
        columns, changes);
    return fault;
}

QString Rewind::deathFault(const TreeDelta& delta)
{
    const InternodeColumns& c = m_tree.columns();
    ++m_round;
    for (const InternodeId id : delta.died) {
        if (id >= m_tree.size() || id == 0 || c.death[id] != delta.stepAfter || !isNewInRound(id))
            return JournalText::tr("it records the death of an internode that did not die");
        countContinuation(id, 1);
    }
    for (const InternodeId id : delta.died) {
        const InternodeId parent = c.parent[id];
        if (parent == kNoInternode || delta.born.contains(id))
            continue;
        if (c.death[parent] != kNever && m_rounds[parent] != m_round)
            return JournalText::tr("before it, an internode would live on a dead one");
        if (m_tree.continuesAxis(id) && m_continuations[parent] > 1)
            return JournalText::tr("before it, two internodes would continue the same axis");
    }
    for (InternodeId id = delta.born.first; id != delta.born.end(); ++id) {
        if (c.death[id] != kNever && m_rounds[id] != m_round)
            return JournalText::tr("it creates an internode that is not there");
    }
    return {};
}

QString Rewind::sparseFault(const TreeDelta& delta)
{
    QString fault;
    SparseTable::visit(
        [&](const auto& info, const auto& column, const auto& changes) {
            ++m_round;
            for (const auto& change : changes) {
                if (!fault.isEmpty())
                    return;
                const bool isRow = change.row < m_tree.size();
                if (!isRow || !isNewInRound(change.row) || column.at(change.row) != change.after ||
                    change.before == change.after ||
                    (change.before && info.faultOf(*change.before) != nullptr) ||
                    (change.before && change.row >= delta.born.first))
                    fault = changeOf(QLatin1StringView(info.name), ChangeFault::Impossible);
            }
        },
        m_tree.content().sparse, delta.sparse);
    return fault;
}

QString Rewind::lassoFault(const TreeDelta& delta)
{
    ++m_round;
    const std::vector<std::uint32_t>& inForce = m_tree.lassoIndicesInForce();
    for (const auto [index, isInForce] : delta.lassos) {
        if (index >= static_cast<std::uint32_t>(m_tree.lassos().size()) ||
            std::ranges::binary_search(inForce, index) != isInForce || !isNewInRound(index))
            return JournalText::tr("it changes an envelope in a way that is not possible");
    }
    return {};
}

/// Returns a fault if a row or a value refers to rows or values that have just been removed.
QString Rewind::danglingFault(bool removesProfiles) const
{
    const TreeContent& content = m_tree.content();
    bool dangles =
        !content.lassosInForce.empty() && content.lassosInForce.back() >= content.kept.lassos.size();
    SparseTable::visit(
        [&](const auto&, const auto& column) {
            dangles = dangles || (!column.cells().empty() && column.cells().back().id >= m_tree.size());
        },
        content.sparse);
    if (removesProfiles) {
        for (const auto& cell : content.sparse.profile.cells())
            dangles = dangles || cell.value >= content.kept.profiles.size();
    }
    return dangles ? JournalText::tr("something is set before it on what it brings") : QString();
}

} // namespace

Error emptyDelta(std::size_t place)
{
    return inputError(JournalText::tr("step %1 of the history").arg(place + 1),
                      JournalText::tr("it changes nothing"));
}

Result<void> checkJournal(const Tree& tree, const Journal& journal)
{
    Rewind rewind(tree);
    for (std::size_t i = journal.size(); i-- > 0;) {
        if (journal[i]->isEmpty())
            return emptyDelta(i);
        if (const QString fault = rewind.revert(*journal[i]); !fault.isEmpty())
            return inputError(JournalText::tr("step %1 of the history").arg(i + 1), fault);
    }
    // The rest, from before the first delta, must be a valid tree.
    if (const QString fault = treeFault(rewind.tree().content()); !fault.isEmpty())
        return inputError(JournalText::tr("the beginning of the history"), fault);
    return {};
}

} // namespace espalier
