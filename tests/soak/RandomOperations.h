// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Random.h"
#include "model/document/TreeDocument.h"
#include "tests/support/AllOperations.h"

namespace espalier::test {

/// Chooses random operations that a user could perform next on a tree: usually sensible, sometimes absurd,
/// all within the limits of a recipe. The same seed and the same documents give the same operations.
class RandomOperations {
public:
    /// Trees of more than @p most living internodes are cut back rather than grown.
    RandomOperations(std::uint64_t seed, std::uint32_t most);

    /// Parameters for the start of a document.
    TreeParameters parameters();
    /// @param undoable how many commands may be undone at most; 0 brings no undo
    RecipeOperation next(const TreeDocument& document, int undoable);
    /// 0...@p count - 1.
    int below(int count);
    /// True once in @p count times.
    DepthOptions depth();
    bool onceIn(int count) { return below(count) == 0; }

private:
    /// A kind of operation: how often it is chosen for a tree that may grow, and for one that must be cut
    /// back.
    struct Kind {
        QLatin1StringView name;
        int growing;
        int cuttingBack;
        RecipeOperation (*make)(RandomOperations&, const TreeDocument&, int undoable);
    };
    template <class Operation>
    static constexpr Kind kindOf(int growing, int cuttingBack)
    {
        return {Operation::kName, growing, cuttingBack,
                [](RandomOperations& random, const TreeDocument& document, int undoable) {
                    if constexpr (std::is_empty_v<Operation>)
                        return RecipeOperation(Operation{});
                    else
                        return RecipeOperation(random.make<Operation>(document, undoable));
                }};
    }
    static std::span<const Kind> kinds();

    template <class Operation>
    Operation make(const TreeDocument& document, int undoable);

    InternodeId living(const TreeDocument& document);
    InternodeId any(const TreeDocument& document);
    InternodeId large(const TreeDocument& document);
    BudReference only(const TreeDocument& document);
    std::vector<Vec2> loop(float radius);
    SweptTwigs sweptTwigs(const TreeDocument& document);
    float internode(const TreeDocument& document) const;

    Random m_random;
    std::uint32_t m_most;
};

} // namespace espalier::test
