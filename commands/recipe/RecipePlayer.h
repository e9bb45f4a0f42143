// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/Recipe.h"

#include <memory>
#include <optional>

namespace espalier {

/// Does to a document what a recipe says, by the same commands that a hand uses; at once or, for a
/// demonstration, in the time that a hand would take.
class RecipePlayer {
public:
    enum class Start {
        Anew, ///< From a seedling with the recipe's seed and parameters
        GoOn, ///< On the tree that stands, putting the recipe's parameters in force
    };
    RecipePlayer(TreeDocument& document, Recipe recipe, Start start = Start::Anew);
    ~RecipePlayer();

    bool isDone() const;
    /// What operations that are done did not find or could not do, with their places:
    /// "operations[3]: prune: there is no internode 712".
    const QStringList& warnings() const { return m_warnings; }
    /// Share of the operations that are done, 0...1.
    double progress() const;
    /// The one at hand, or the next; null when all is done.
    const RecipeOperation* operation() const { return isDone() ? nullptr : &m_recipe.operations[m_next]; }
    void playAll();
    /// Does the next operation, or what is left of the one at hand.
    void playOperation();
    /// Goes on by @p seconds of a demonstration: brush strokes take their own time, growth goes twelve steps
    /// a second, other operations happen at once, one a call.
    void advance(double seconds);
    /// Where the brush is, while a stroke is made.
    std::optional<BrushSample> brush() const;
    /// The stroke that is being made, or null.
    const BrushGesture* stroke() const { return m_performance ? m_performance->stroke() : nullptr; }
    /// The envelope that is being filled, or null.
    const LassoGesture* lasso() const { return m_performance ? m_performance->lasso() : nullptr; }

private:
    TreeDocument& m_document;
    Recipe m_recipe;
    std::size_t m_next = 0;
    std::unique_ptr<Performance> m_performance; ///< Of the operation at hand
    QStringList m_warnings;
};

} // namespace espalier
