// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/HistorySnapshot.h"

#include "model/growth/NamedModel.h"

#include <QLoggingCategory>

#include <algorithm>

namespace espalier {

namespace {

/// Undo steps that are never dropped.
constexpr std::size_t kLeastSteps = 10;
/// Shortening a history leaves this share of the memory that it may take; it pays if it frees at least this
/// other share.
constexpr double kLeft = 0.75;
constexpr double kWorthwhile = 0.1;

/// The first moment that undoing or redoing a step leads to.
std::size_t firstMoment(const EditCommand::Content& step)
{
    return std::min(step.from, step.to - step.replaced.size());
}

std::size_t bytesOf(const PreparedTree& tree)
{
    std::size_t bytes =
        tree.tree.bytes() + tree.index.bytes() + tree.growthModel->bytes() + tree.pickIndex.bytes();
    for (const Journal* deltas : {&tree.journal, &tree.future}) {
        for (const auto& delta : *deltas)
            bytes += delta->bytes();
    }
    return bytes;
}

} // namespace

HistorySnapshot::HistorySnapshot(const TreeDocument& document)
    : m_revision(document.revision()),
      m_tree(document.tree()),
      m_journal(document.journal()),
      m_future(document.future()),
      m_index(static_cast<std::size_t>(document.undoStack().index())),
      m_rowBytes((document.tree().bytes() + document.index().bytes()) / document.tree().size())
{
    Q_ASSERT(!document.edit());
    m_steps = AsideDocument::stepsOf(document);
    addRows(m_future);
    for (const AsideDocument::Step& step : m_steps) {
        addRows(step.content.replaced);
        addRows(step.content.deltas);
        addRows(step.content.future);
        if (const PreparedTree* other = step.content.other.get())
            m_otherBytes.emplace(other, bytesOf(*other));
    }
    findReach();
}

void HistorySnapshot::addRows(const Journal& deltas)
{
    for (const auto& delta : deltas) {
        if (delta->rows)
            m_rows.emplace(delta.get(), delta->rows);
    }
}

std::size_t HistorySnapshot::memoryOf(const TreeDelta& delta) const
{
    const bool isReverted = m_rows.contains(&delta);
    return delta.bytes() + m_rowBytes * (delta.died.size() + (isReverted ? delta.born.count : 0));
}

std::size_t HistorySnapshot::memoryOf(const Journal& deltas) const
{
    std::size_t bytes = 0;
    for (const auto& delta : deltas)
        bytes += memoryOf(*delta);
    return bytes;
}

/// What an undo step alone refers to. The deltas of steps that are done are in the journal.
std::size_t HistorySnapshot::memoryOfStep(std::size_t step) const
{
    const EditCommand::Content& content = m_steps[step].content;
    std::size_t bytes = memoryOf(content.replaced) + memoryOf(content.future);
    if (content.other)
        bytes += m_otherBytes.at(content.other.get());
    return step < m_index ? bytes : bytes + memoryOf(content.deltas);
}

std::size_t HistorySnapshot::bytes() const
{
    std::size_t bytes = memoryOf(m_journal) + memoryOf(m_future);
    for (std::size_t i = 0; i < m_steps.size(); ++i)
        bytes += memoryOfStep(i);
    return bytes;
}

void HistorySnapshot::findReach()
{
    m_endOfTree = m_steps.size();
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        if (!m_steps[i].content.other)
            continue;
        if (i < m_index) {
            m_firstOfTree = i + 1;
        } else {
            m_endOfTree = i;
            break;
        }
    }
    m_reach.assign(m_steps.size() + 1, m_journal.size());
    for (std::size_t i = m_steps.size(); i-- > 0;) {
        m_reach[i] = m_reach[i + 1];
        if (isOfThisTree(i))
            m_reach[i] = std::min(m_reach[i], firstMoment(m_steps[i].content));
    }
}

std::optional<ShortenedHistory> HistorySnapshot::shortenedTo(std::size_t most) const
{
    const std::size_t before = bytes();
    if (before <= most)
        return std::nullopt;
    const auto wanted = static_cast<std::size_t>(kLeft * static_cast<double>(most));
    const std::size_t mostSteps = m_index - std::min(m_index, kLeastSteps);
    std::size_t left = before;
    Cut cut{0, 0};
    for (;;) {
        for (; cut.deltas < m_reach[cut.steps] && left > wanted; ++cut.deltas)
            left -= std::min(left, memoryOf(*m_journal[cut.deltas]));
        if (left <= wanted || cut.steps == mostSteps)
            break;
        left -= std::min(left, memoryOfStep(cut.steps));
        ++cut.steps;
    }
    if (static_cast<double>(before - left) < kWorthwhile * static_cast<double>(most))
        return std::nullopt;
    return shortenedAt(cut);
}

std::optional<ShortenedHistory> HistorySnapshot::without(std::size_t deltas) const
{
    std::size_t steps = m_firstOfTree;
    while (m_reach[steps] < deltas)
        ++steps;
    Q_ASSERT(steps <= m_index);
    return shortenedAt({steps, deltas});
}

std::optional<ShortenedHistory> HistorySnapshot::shortenedAt(Cut cut) const
{
    Renumbering renumbering(m_tree, m_journal, cut.deltas, m_rows);
    const auto copiesOf = [&](std::span<const std::shared_ptr<TreeDelta>> deltas) {
        Journal copies;
        copies.reserve(deltas.size());
        for (const auto& delta : deltas)
            copies.push_back(renumbering.copyOf(delta));
        return copies;
    };
    ShortenedHistory shortened;
    shortened.revision = m_revision;
    shortened.steps = static_cast<int>(cut.steps);
    shortened.deltas = cut.deltas;
    AsideDocument& document = shortened.document;
    PreparedTree& tree = document.tree;
    tree.journal = copiesOf(std::span(m_journal).subspan(cut.deltas));
    tree.future = copiesOf(m_future);
    for (std::size_t i = cut.steps; i < m_steps.size(); ++i) {
        AsideDocument::Step step = m_steps[i];
        if (isOfThisTree(i)) {
            EditCommand::Content& content = step.content;
            content.from -= cut.deltas;
            content.to -= cut.deltas;
            for (Journal* deltas : {&content.replaced, &content.deltas, &content.future})
                *deltas = copiesOf(*deltas);
        }
        document.steps.push_back(std::move(step));
    }
    if (const Result<void> done = renumbering.finish(); !done) {
        qWarning("The history could not be shortened: %s", qPrintable(done.error().message));
        return std::nullopt;
    }
    document.index = static_cast<int>(m_index - cut.steps);
    shortened.internodes = renumbering.internodes();
    tree.tree = std::move(renumbering.tree());
    tree.index.rebuild(tree.tree);
    tree.growthModel = std::make_unique<NamedModel>();
    tree.growthModel->rebuild(tree.tree, tree.index);
    return shortened;
}

} // namespace espalier
