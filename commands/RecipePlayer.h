// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/BrushGesture.h"
#include "commands/GrowGesture.h"
#include "commands/LassoGesture.h"
#include "model/io/recipe/Recipe.h"

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
    const BrushGesture* stroke() const { return m_stroke.get(); }
    /// The envelope that is being filled, or null.
    const LassoGesture* lasso() const { return m_lasso.get(); }

private:
    bool advanceStroke(const BrushStrokeOperation& operation, double seconds);
    bool advanceGrowth(const GrowOperation& operation, double seconds);
    template <class Begin>
    bool advanceLasso(Begin&& begin, double seconds);

    TreeDocument& m_document;
    Recipe m_recipe;
    std::size_t m_next = 0;
    std::unique_ptr<BrushGesture> m_stroke;
    std::size_t m_nextSample = 0;
    double m_strokeTime = 0.0;
    std::unique_ptr<LassoGesture> m_lasso;
    std::unique_ptr<GrowGesture> m_growth;
    int m_growthSteps = 0;
    double m_growthDue = 0.0;
};

} // namespace espalier
