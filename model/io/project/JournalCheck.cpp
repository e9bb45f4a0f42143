// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/JournalCheck.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>

#include <map>
#include <utility>
#include <vector>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(JournalCheck)
};

constexpr BudMask kAllBuds = kTerminalBud | ((1U << kMaxLaterals) - 1U);

/// Goes back through the journal. Tree::fromColumns has found the last state good; each step back checks that
/// the state before is good too and that it is exactly what the delta turns into the state after: so both
/// directions are safe.
class Rewind {
public:
    explicit Rewind(const Tree& tree);

    /// What is wrong with the delta, or nothing.
    QString revert(const TreeDelta& delta);
    /// What is wrong with the state that the journal begins with, or nothing.
    QString checkBeginning() const;

private:
    enum State : std::uint8_t { Absent, Alive, Dead };

    QString revertBuds(const TreeDelta& delta);
    QString revertFrames(const TreeDelta& delta);
    QString revertWidths(const TreeDelta& delta);
    QString revertLassos(const TreeDelta& delta);
    QString revertDeaths(const TreeDelta& delta);
    QString revertBirths(const TreeDelta& delta);
    QString checkStateBefore(const TreeDelta& delta) const;

    const Tree& m_tree;
    const InternodeColumns& m_columns;
    Step m_step;
    std::uint32_t m_parameters;
    InternodeId m_bornEnd; ///< Rows from here on are accounted for
    QList<BudMask> m_buds;
    QList<Rotation> m_rotations;
    QList<float> m_lengths;
    std::map<InternodeId, float> m_widths;
    std::vector<State> m_state;
    std::vector<std::uint32_t> m_children;      ///< Living ones
    std::vector<std::uint32_t> m_continuations; ///< Living children that continue the axis; two are too many
    std::vector<std::uint32_t>
        m_changedBuds; ///< Number of the last delta, counted from the end, that changed an id's buds
    std::vector<std::uint32_t> m_changedFrames; ///< Likewise, its frame
    std::vector<bool> m_lassoInForce;
    std::vector<std::uint32_t> m_changedLassos; ///< Likewise, a lasso
    std::uint32_t m_round = 0;
};

Rewind::Rewind(const Tree& tree)
    : m_tree(tree),
      m_columns(tree.columns()),
      m_step(tree.step()),
      m_parameters(tree.currentParameterSet()),
      m_bornEnd(tree.size()),
      m_buds(tree.columns().buds),
      m_rotations(tree.columns().rotation),
      m_lengths(tree.columns().length),
      m_state(tree.size(), Absent),
      m_children(tree.size(), 0),
      m_continuations(tree.size(), 0),
      m_changedBuds(tree.size(), 0),
      m_changedFrames(tree.size(), 0),
      m_lassoInForce(static_cast<std::size_t>(tree.lassos().strokes.size()), false),
      m_changedLassos(m_lassoInForce.size(), 0)
{
    for (const std::uint32_t index : tree.lassos().inForce)
        m_lassoInForce[index] = true;
    for (const auto [id, diameter] : tree.widthConstraints())
        m_widths[id] = diameter;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (m_columns.present[id] == 0)
            continue;
        m_state[id] = tree.isAlive(id) ? Alive : Dead;
        if (m_state[id] == Alive && id > 0) {
            const InternodeId parent = m_columns.parent[id];
            ++m_children[parent];
            m_continuations[parent] += tree.continuesAxis(id) ? 1U : 0U;
        }
    }
}

QString Rewind::revert(const TreeDelta& delta)
{
    const auto sets = static_cast<std::uint32_t>(m_tree.parameterSets().size());
    if (delta.stepAfter != m_step || delta.stepBefore > delta.stepAfter)
        return Text::tr("its steps do not join those around it");
    if (delta.parametersAfter != m_parameters || delta.parametersBefore >= sets)
        return Text::tr("its parameters do not join those around it");
    if (delta.born.first > m_bornEnd || delta.born.count > m_bornEnd - delta.born.first ||
        (delta.born.count > 0 && delta.born.first == 0))
        return Text::tr("its births are out of order");
    ++m_round;
    if (QString fault = revertBuds(delta); !fault.isEmpty())
        return fault;
    if (QString fault = revertFrames(delta); !fault.isEmpty())
        return fault;
    if (QString fault = revertWidths(delta); !fault.isEmpty())
        return fault;
    if (QString fault = revertLassos(delta); !fault.isEmpty())
        return fault;
    if (QString fault = revertDeaths(delta); !fault.isEmpty())
        return fault;
    if (QString fault = revertBirths(delta); !fault.isEmpty())
        return fault;
    if (QString fault = checkStateBefore(delta); !fault.isEmpty())
        return fault;
    m_step = delta.stepBefore;
    m_parameters = delta.parametersBefore;
    return {};
}

QString Rewind::revertBuds(const TreeDelta& delta)
{
    for (const TreeDelta::BudChange& change : delta.buds) {
        const InternodeId id = change.id;
        if (id >= m_tree.size() || delta.born.contains(id) || m_state[id] == Absent ||
            m_changedBuds[id] == m_round)
            return Text::tr("it changes buds that were not there");
        if (change.after != m_buds[id] || ((change.before | change.after) & ~kAllBuds) != 0)
            return Text::tr("it changes buds in a way that cannot be");
        m_buds[id] = change.before;
        m_changedBuds[id] = m_round;
    }
    return {};
}

QString Rewind::revertFrames(const TreeDelta& delta)
{
    for (const TreeDelta::FrameChange& change : delta.frames) {
        const InternodeId id = change.id;
        if (id >= m_tree.size() || delta.born.contains(id) || m_state[id] == Absent ||
            m_changedFrames[id] == m_round)
            return Text::tr("it bends an internode that was not there");
        if (change.after.coeffs() != m_rotations[id].coeffs() || change.lengthAfter != m_lengths[id] ||
            !isFrame(change.before, change.lengthBefore))
            return Text::tr("it bends an internode in a way that cannot be");
        m_rotations[id] = change.before;
        m_lengths[id] = change.lengthBefore;
        m_changedFrames[id] = m_round;
    }
    return {};
}

QString Rewind::revertWidths(const TreeDelta& delta)
{
    for (const TreeDelta::WidthChange& change : delta.widths) {
        const auto found = m_widths.find(change.id);
        if (change.id >= m_tree.size() || (found == m_widths.end() ? 0.0F : found->second) != change.after ||
            !(change.before >= 0.0F && change.before <= kGreatestDiameter) || change.before == change.after)
            return Text::tr("it sets a width in a way that cannot be");
        if (change.before > 0.0F)
            m_widths[change.id] = change.before;
        else
            m_widths.erase(change.id);
    }
    return {};
}

QString Rewind::revertLassos(const TreeDelta& delta)
{
    for (const auto [index, isInForce] : delta.lassos) {
        if (index >= m_lassoInForce.size() || m_lassoInForce[index] != isInForce ||
            std::exchange(m_changedLassos[index], m_round) == m_round)
            return Text::tr("it changes an envelope in a way that cannot be");
        m_lassoInForce[index] = !isInForce;
    }
    return {};
}

QString Rewind::revertDeaths(const TreeDelta& delta)
{
    for (const InternodeId id : delta.died) {
        if (id >= m_tree.size() || id == 0 || m_state[id] != Dead || m_columns.death[id] != delta.stepAfter)
            return Text::tr("it lets an internode die that did not");
        m_state[id] = Alive;
    }
    for (const InternodeId id : delta.died) {
        const InternodeId parent = m_columns.parent[id];
        ++m_children[parent];
        m_continuations[parent] += m_tree.continuesAxis(id) ? 1U : 0U;
    }
    return {};
}

QString Rewind::revertBirths(const TreeDelta& delta)
{
    if (delta.born.count == 0)
        return {};
    m_bornEnd = delta.born.first;
    for (InternodeId id = delta.born.end(); id-- > delta.born.first;) {
        if (m_state[id] != Alive)
            return Text::tr("it bears an internode that is not there");
        if (m_columns.birth[id] < delta.stepBefore || m_columns.birth[id] > delta.stepAfter)
            return Text::tr("it bears an internode at another time");
        // Children have higher ids: those of the same delta are gone already.
        if (m_children[id] != 0)
            return Text::tr("it bears an internode after what grows on it");
        m_state[id] = Absent;
        const InternodeId parent = m_columns.parent[id];
        --m_children[parent];
        m_continuations[parent] -= m_tree.continuesAxis(id) ? 1U : 0U;
    }
    return {};
}

QString Rewind::checkStateBefore(const TreeDelta& delta) const
{
    for (const InternodeId id : delta.died) {
        if (m_state[id] != Alive) // the delta bears it, too
            continue;
        const InternodeId parent = m_columns.parent[id];
        if (m_state[parent] != Alive)
            return Text::tr("before it, an internode would live on a dead one");
        if (m_tree.continuesAxis(id) && m_continuations[parent] > 1)
            return Text::tr("before it, two internodes would continue the same axis");
    }
    for (const TreeDelta::BudChange& change : delta.buds) {
        if (m_state[change.id] != Alive)
            return Text::tr("it changes the buds of a dead internode");
    }
    return {};
}

QString Rewind::checkBeginning() const
{
    for (InternodeId id = 0; id < m_tree.size(); ++id) {
        if (m_state[id] == Absent)
            continue;
        if (m_columns.birth[id] > m_step || (m_state[id] == Dead && m_columns.death[id] > m_step))
            return Text::tr("internode %1 has no beginning or no end in the history").arg(id);
    }
    return {};
}

} // namespace

Result<void> checkJournal(const Tree& tree, const Journal& journal)
{
    Rewind rewind(tree);
    for (std::size_t i = journal.size(); i-- > 0;) {
        if (const QString fault = rewind.revert(*journal[i]); !fault.isEmpty())
            return inputError(Text::tr("step %1 of the history").arg(i + 1), fault);
    }
    if (const QString fault = rewind.checkBeginning(); !fault.isEmpty())
        return inputError(Text::tr("the history"), fault);
    return {};
}

} // namespace espalier
