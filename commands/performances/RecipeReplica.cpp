// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/performances/RecipeReplica.h"

#include "commands/BrushGesture.h"
#include "commands/LassoGesture.h"

namespace espalier {

RecipeReplica::RecipeReplica(const Recipe& recipe) : m_player(m_document, recipe)
{
    m_document.setEditListener([this](EditEvent event) { m_events.push_back(std::move(event)); });
}

RecipePart RecipeReplica::advance(double seconds, std::chrono::milliseconds work)
{
    const auto begin = std::chrono::steady_clock::now();
    do {
        m_player.advance(seconds);
    } while (!m_player.isDone() && std::chrono::steady_clock::now() - begin < work);

    RecipePart part{.events = std::exchange(m_events, {}), .moment = {}};
    RecipeMoment& moment = part.moment;
    moment.progress = m_player.progress();
    moment.operation = m_player.operationsDone();
    moment.isDone = m_player.isDone();
    if (moment.isDone)
        moment.warnings = m_player.warnings();
    if (const BrushGesture* const stroke = m_player.stroke()) {
        moment.stroke = stroke->path();
        moment.markers.assign(stroke->markers().begin(), stroke->markers().end());
    } else if (const LassoGesture* const lasso = m_player.lasso()) {
        moment.isFilling = true;
        moment.markers.assign(lasso->markers().begin(), lasso->markers().end());
    }
    return part;
}

} // namespace espalier
