// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/EditFollower.h"

#include <algorithm>
#include <iterator>

namespace espalier {

EditFollower::EditFollower(TreeDocument& document, std::function<void()> interrupted)
    : m_document(document), m_interrupted(std::move(interrupted)), m_revision(document.revision())
{
}

EditFollower::~EditFollower() = default;

void EditFollower::add(std::vector<EditEvent> events)
{
    std::ranges::move(events, std::back_inserter(m_events));
}

bool EditFollower::advance(std::chrono::milliseconds time)
{
    Q_ASSERT(isInStep());
    const auto begin = std::chrono::steady_clock::now();
    while (isWaiting()) {
        if (!step(m_events.front(), time))
            m_events.pop_front();
        m_revision = m_document.revision();
        if (std::chrono::steady_clock::now() - begin >= time)
            break;
    }
    return isWaiting();
}

/// Repeats the event or a part of it; returns whether there is more of it.
bool EditFollower::step(EditEvent& event, std::chrono::milliseconds time)
{
    using Kind = EditEvent::Kind;
    switch (event.kind) {
    case Kind::Began:
        m_edit = std::make_unique<Edit>(m_document, m_interrupted);
        return false;
    case Kind::Resumed:
        m_edit.reset(); // Edit::resumed() begins another one.
        m_edit = Edit::resumed(m_document);
        return false;
    case Kind::Applied:
        m_edit->apply(std::move(*event.delta));
        return false;
    case Kind::TookBackLast:
        m_edit->takeBackLast();
        return false;
    case Kind::ReplacedFrom:
        m_edit->replaceFrom(event.position);
        return false;
    case Kind::TravelledTo:
        return travelTowards(event.position);
    case Kind::Committed:
        m_edit->commit(event.text, event.operation);
        m_edit.reset();
        return false;
    case Kind::Cancelled:
        m_edit.reset();
        return false;
    case Kind::Undone:
        return moveStack(-1, time);
    case Kind::Redone:
        return moveStack(1, time);
    }
    return false;
}

bool EditFollower::moveStack(int commands, std::chrono::milliseconds time)
{
    if (!m_undo) {
        const int index = m_document.undoStack().index() + commands;
        m_undo = std::make_unique<GradualUndo>(m_document, index, m_interrupted);
    }
    if (m_undo->advance(time))
        return true;
    m_undo.reset();
    return false;
}

bool EditFollower::travelTowards(std::size_t position)
{
    const std::size_t present = m_document.journal().size();
    if (present < position)
        m_edit->travelTo(present + 1);
    else
        m_edit->travelTo(present > position ? present - 1 : present);
    return m_document.journal().size() != position;
}

} // namespace espalier
