// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TimeGesture.h"

#include "commands/DeltaCommand.h"

#include <QCoreApplication>

#include <memory>
#include <utility>

namespace espalier {

namespace {

/// Turns time back, or forth again. Travels in a row are one; an edit at an earlier moment joins the travel
/// there, so that one undo brings the lost future back.
class TimeTravelCommand : public QUndoCommand {
public:
    /// The document stands at @p to.
    TimeTravelCommand(TreeDocument& document, std::size_t from, std::size_t to)
        : QUndoCommand(QCoreApplication::translate("Commands", "Travel in Time")),
          m_document(document),
          m_from(from),
          m_to(to)
    {
    }

    void undo() override
    {
        if (m_edit)
            m_edit->undo();
        m_document.travelTo(m_from);
        m_applied = false;
    }
    void redo() override
    {
        if (std::exchange(m_applied, true))
            return;
        m_document.travelTo(m_to);
        if (m_edit)
            m_edit->redo();
    }
    int id() const override { return m_edit ? -1 : kTimeTravelId; }
    bool mergeWith(const QUndoCommand* other) override
    {
        if (const auto* travel = dynamic_cast<const TimeTravelCommand*>(other)) {
            m_to = travel->m_to;
            setObsolete(m_to == m_from);
            return true;
        }
        if (const auto* edit = dynamic_cast<const DeltaCommand*>(other)) {
            m_edit = edit->copy();
            setText(edit->text());
            return true;
        }
        return false;
    }

private:
    TreeDocument& m_document;
    std::size_t m_from;
    std::size_t m_to;
    std::unique_ptr<DeltaCommand> m_edit;
    bool m_applied = true;
};

} // namespace

TimeGesture::TimeGesture(TreeDocument& document)
    : m_document(document),
      m_start(document.journal().size()),
      m_historyLength(document.journal().size() + document.future().size())
{
}

TimeGesture::~TimeGesture()
{
    cancel();
}

void TimeGesture::moveTo(std::size_t position)
{
    if (m_ended)
        return;
    while (!m_grown.empty() && m_document.journal().size() > position) {
        m_document.revertLast();
        m_grown.pop_back();
    }
    m_document.travelTo(std::min(position, m_historyLength) + m_grown.size());
    while (m_document.journal().size() < position && grow()) {
    }
}

bool TimeGesture::grow()
{
    GrowthStepOptions options = GrowthStepOptions::of(m_document.parameters().growth);
    options.competitors = m_document.competitors();
    TreeDelta delta =
        autonomousStep(m_document.tree(), m_document.index(), m_document.growthIndex(), options, m_workspace);
    if (delta.isEmpty())
        return false;
    m_grown.push_back(std::make_shared<TreeDelta>(std::move(delta)));
    m_document.apply(m_grown.back());
    return true;
}

void TimeGesture::finish()
{
    if (std::exchange(m_ended, true))
        return;
    const std::size_t position = m_document.journal().size() - m_grown.size();
    if (position != m_start)
        m_document.undoStack().push(new TimeTravelCommand(m_document, m_start, position));
    if (!m_grown.empty())
        m_document.undoStack().push(new DeltaCommand(
            m_document, QCoreApplication::translate("Commands", "Grow"), std::move(m_grown)));
}

void TimeGesture::cancel()
{
    if (std::exchange(m_ended, true))
        return;
    for (std::size_t i = 0; i < m_grown.size(); ++i)
        m_document.revertLast();
    m_grown.clear();
    m_document.travelTo(m_start);
}

} // namespace espalier
