// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeTables.h"

#include <QByteArray>

#include <cstddef>
#include <memory>
#include <vector>

namespace espalier {

/// Rows and values that a delta adds to a tree.
struct TreeRows {
    InternodeColumns internodes;
    LeafColumns leaves;
    KeptValues kept;
};

/// What made the deltas of one edit, as text that the model keeps and does not read.
struct EditRecord {
    /// A longer operation is not kept, bytes.
    static constexpr qsizetype kMostBytes = 64 << 20;

    QByteArray operation;     ///< Compact JSON of a recipe's operation; empty if it is not known
    std::uint32_t deltas = 1; ///< Of the whole edit; a journal that was cut within it has fewer

    /// The record of an edit of which nothing is known (yet).
    static const std::shared_ptr<const EditRecord>& unknown();
    bool operator==(const EditRecord&) const = default;
};

/// What one edit did to a tree. Tree::apply and Tree::revert of deltas are the only ways to change one.
struct TreeDelta {
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
    IdRange born;                    ///< Internodes; they are the tree's last rows
    IdRange bornLeaves;              ///< Placed leaves, likewise
    KeptCounts kept;                 ///< Values that are new to the tree, likewise
    std::vector<InternodeId> died;   ///< At stepAfter; the whole of each shed or pruned branch
    InternodeChanges internodes;     ///< Of internodes that were there before
    LeafChanges leaves;              ///< Of placed leaves that were there before
    SparseChanges sparse;            ///< Each id at most once a column
    std::vector<LassoChange> lassos; ///< Each index at most once
    /// The new rows and values while they are not in the document's tree: reverting moves them here and
    /// applying moves them back, so a row is stored once. Null in a delta that stands applied, or brings
    /// none.
    std::shared_ptr<TreeRows> rows;
    /// What made the edit that begins with this delta. Null in its other deltas, and in those of files that
    /// are older than records.
    std::shared_ptr<const EditRecord> record;

    /// Notes that an internode was bent or stretched (lengths in m), with all that hangs on it.
    void addFrame(InternodeId id, const Rotation& before, const Rotation& after, float lengthBefore,
                  float lengthAfter);

    bool isEmpty() const;
    bool bringsRows() const { return born.count > 0 || bornLeaves.count > 0 || kept != KeptCounts(); }
    std::size_t bytes() const;
    /// Equal in all but where the rows are.
    bool operator==(const TreeDelta& other) const;

    /// Calls @p visit(id) for each internode whose birth, life or buds differ; not for their neighbours, nor
    /// for those that only moved. After the delta was reverted, ids from the tree's size on are the rows that
    /// went.
    template <class Visit>
    void forEachTouched(Visit&& visit) const
    {
        for (InternodeId id = born.first; id != born.end(); ++id)
            visit(id);
        forEachTouchedRow(visit);
    }
    /// The same without the births.
    template <class Visit>
    void forEachTouchedRow(Visit&& visit) const
    {
        for (const InternodeId id : died)
            visit(id);
        for (const auto& change : internodes.buds)
            visit(change.row);
        for (const auto& change : internodes.death)
            visit(change.row);
    }
    /// Calls @p visit(id), maybe more than once, for each internode that has another place on its parent,
    /// frame or length.
    template <class Visit>
    void forEachReframed(Visit&& visit) const
    {
        for (const auto& change : internodes.rotation)
            visit(change.row);
        for (const auto& change : internodes.length)
            visit(change.row);
        for (const auto& change : internodes.along)
            visit(change.row);
        for (const auto& change : sparse.rootPosition)
            visit(change.row);
    }
    bool reframes() const
    {
        return !internodes.rotation.empty() || !internodes.length.empty() || !internodes.along.empty() ||
               !sparse.rootPosition.empty();
    }
};

/// The history of a tree in simulation time: every delta that made it what it is.
using Journal = std::vector<std::shared_ptr<TreeDelta>>;

} // namespace espalier
