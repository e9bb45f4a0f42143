// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipePlayer.h"
#include "model/document/EditEvent.h"
#include "model/document/TreeDocument.h"

#include <chrono>
#include <cstddef>
#include <vector>

namespace espalier {

/// What a view shows of a recipe that plays.
struct RecipeMoment {
    double progress = 0.0;           ///< Share of the operations that are done, 0...1
    std::size_t operation = 0;       ///< Index of the operation under way, or of the next one
    std::vector<BrushSample> stroke; ///< Of the stroke that is being made; empty if there is none
    std::vector<Vec3> markers;       ///< Of that stroke, or of the envelope that is being filled, m
    bool isFilling = false;          ///< An envelope is being filled
    bool isDone = false;
    QStringList warnings; ///< See RecipePlayer::warnings(); only once the recipe is done
};

/// A part of a recipe that was played, for a document that follows (EditFollower), and the moment after it.
struct RecipePart {
    std::vector<EditEvent> events;
    RecipeMoment moment;
};

/// Plays a recipe on a document of its own, on another thread than the one that shows it, so that the
/// interface does not wait for it. It shares no data that is written.
class RecipeReplica {
public:
    /// Begins anew, with a seedling (RecipePlayer::Start::Anew).
    explicit RecipeReplica(const Recipe& recipe);

    /// Calls RecipePlayer::advance(@p seconds) once, or again until @p work has passed or the recipe is done.
    /// Calls may come from different threads, but must not overlap. Precondition: it is not done.
    RecipePart advance(double seconds, std::chrono::milliseconds work);

private:
    TreeDocument m_document;
    std::vector<EditEvent> m_events; ///< Since the last call of advance()
    RecipePlayer m_player;
};

} // namespace espalier
