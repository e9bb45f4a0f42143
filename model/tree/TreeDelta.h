// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/tree/InternodeColumns.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace espalier {

/// What one edit did to a tree. Tree::apply and Tree::revert of deltas are the only ways to change one.
struct TreeDelta {
    struct BudChange {
        InternodeId id;
        BudMask before;
        BudMask after;
        bool operator==(const BudChange&) const = default;
    };

    /// An internode that was bent or stretched, with all that hangs on it.
    struct FrameChange {
        InternodeId id;
        Rotation before; ///< Local frame
        Rotation after;
        float lengthBefore; ///< m
        float lengthAfter;  ///< m
        bool operator==(const FrameChange&) const = default;
    };
    /// A width constraint that was set, moved or taken away.
    struct WidthChange {
        InternodeId id;
        float before; ///< Diameter, m; 0 for none
        float after;
        bool operator==(const WidthChange&) const = default;
    };

    /// An envelope that came into force or was taken away.
    struct LassoChange {
        std::uint32_t index; ///< Of the tree's lassos
        bool isInForce;      ///< Afterwards; before, the opposite
        bool operator==(const LassoChange&) const = default;
    };

    Step stepBefore = 0;
    Step stepAfter = 0;
    std::uint32_t parametersBefore = 0; ///< Index of the parameter set in force
    std::uint32_t parametersAfter = 0;
    IdRange born;
    std::vector<InternodeId> died;   ///< At stepAfter; the whole of each shed or pruned branch
    std::vector<BudChange> buds;     ///< Of internodes that lived before; each id at most once
    std::vector<FrameChange> frames; ///< Likewise
    std::vector<WidthChange> widths; ///< Each id at most once
    std::vector<LassoChange> lassos; ///< Each index at most once
    /// The new internodes' rows on their way into the tree: the first apply takes them in and lets go of
    /// them, and they stay in its columns from then on. A copy of the delta can bring them into a copy of the
    /// tree.
    std::shared_ptr<const InternodeColumns> rows;

    /// A delta that changes nothing, to be filled in, at the moment that @p tree is in.
    static TreeDelta startingAt(const class Tree& tree);

    bool isEmpty() const;
    std::size_t bytes() const;

    /// Calls @p visit(id) for each internode whose birth, life or buds differ; not for their neighbours, nor
    /// for those that only moved.
    template <class Visit>
    void forEachTouched(Visit&& visit) const
    {
        for (InternodeId id = born.first; id != born.end(); ++id)
            visit(id);
        for (const InternodeId id : died)
            visit(id);
        for (const BudChange& change : buds)
            visit(change.id);
    }
};

/// The history of a tree in simulation time: every delta that made it what it is.
using Journal = std::vector<std::shared_ptr<TreeDelta>>;

} // namespace espalier
