// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/AnotherTree.h"

#include "commands/DocumentProject.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/base/Random.h"

namespace espalier {

namespace {

/// Of a recipe's own time that is played between two looks at whether the work was cancelled, s.
constexpr double kSlice = 0.25;

} // namespace

std::uint64_t seedOfAnother(std::uint64_t seed, int number)
{
    return mixedBits(mixedBits(seed) + static_cast<std::uint64_t>(number));
}

std::unique_ptr<PreparedTree> anotherTree(Recipe recipe, std::uint64_t seed,
                                          const std::atomic<bool>& isCancelled)
{
    TreeDocument document;
    recipe.seed = seed;
    RecipePlayer player(document, std::move(recipe));
    while (!player.isDone()) {
        if (isCancelled)
            return nullptr;
        player.advance(kSlice);
    }
    document.interruptEdit();
    return std::make_unique<PreparedTree>(prepared(projectOf(document, {})));
}

} // namespace espalier
