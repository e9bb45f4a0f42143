// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

#include <memory>
#include <optional>

namespace espalier {

/// Performs a recipe on a document, by the same gestures and commands that the interface uses: at once, or,
/// for a demonstration, in the time that a user would take.
class RecipePlayer {
public:
    enum class Start {
        Anew, ///< From a seedling with the recipe's seed and parameters
        GoOn, ///< On the present tree, with the recipe's parameters put in force
    };
    RecipePlayer(TreeDocument& document, Recipe recipe, Start start = Start::Anew);
    ~RecipePlayer();

    bool isDone() const;
    /// What finished operations did not find or could not do, with their places:
    /// "operations[3]: prune: there is no internode 712".
    const QStringList& warnings() const { return m_warnings; }
    /// Share of the operations that are done, 0...1.
    double progress() const;
    std::size_t operationsDone() const { return m_next; }
    void playAll();
    /// Performs the next operation, or the rest of the one under way.
    void playOperation();
    /// Advances by @p seconds of a demonstration: brush strokes take their own time, growth makes twelve
    /// steps a second, other operations happen at once, one per call.
    void advance(double seconds);
    /// The brush while a stroke is made.
    std::optional<BrushSample> brush() const;
    /// The stroke that is being made, or null.
    const BrushGesture* stroke() const { return m_performance ? m_performance->stroke() : nullptr; }
    /// The envelope that is being filled, or null.
    const LassoGesture* lasso() const { return m_performance ? m_performance->lasso() : nullptr; }

private:
    TreeDocument& m_document;
    Recipe m_recipe;
    std::size_t m_next = 0;
    std::unique_ptr<Performance> m_performance; ///< Of the operation under way
    QStringList m_warnings;
};

} // namespace espalier
