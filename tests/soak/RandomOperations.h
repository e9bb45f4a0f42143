// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Random.h"
#include "model/document/TreeDocument.h"
#include "model/io/recipe/Recipe.h"

namespace espalier::test {

/// Thinks of what a person might do next with a tree: something sensible for the most part, absurd now and
/// then, all within the limits of a recipe. The same seed and the same documents give the same operations.
class RandomOperations {
public:
    /// Trees of more than @p most living internodes are cut back rather than grown.
    RandomOperations(std::uint64_t seed, std::uint32_t most);

    /// What a document begins with.
    TreeParameters parameters();
    /// @param undoable how many commands may be undone at most; 0 brings no undo
    RecipeOperation next(const TreeDocument& document, int undoable);
    /// 0...@p count - 1.
    int below(int count);
    /// True once in @p count times.
    bool onceIn(int count) { return below(count) == 0; }

private:
    template <class Operation>
    Operation make(const TreeDocument& document, int undoable);

    InternodeId living(const TreeDocument& document);
    InternodeId any(const TreeDocument& document);
    InternodeId large(const TreeDocument& document);
    Competitors competitors(const TreeDocument& document);
    std::vector<Vec2> loop(float radius);
    float internode(const TreeDocument& document) const;

    Random m_random;
    std::uint32_t m_most;
};

} // namespace espalier::test
