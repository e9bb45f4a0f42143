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

/// The operation that made the deltas of one edit. The model stores this text and does not interpret it.
struct EditRecord {
    /// The greatest size of an operation, bytes; longer ones are not recorded.
    static constexpr qsizetype kMostBytes = 64 << 20;

    QByteArray operation;     ///< Compact JSON of a recipe's operation; empty if it is unknown
    std::uint32_t deltas = 1; ///< Of the whole edit; a journal that ends within the edit has fewer

    /// The record of an edit whose operation is not known, or not known yet.
    static const std::shared_ptr<const EditRecord>& unknown();
    bool operator==(const EditRecord&) const = default;
};

/// A set of changes to a tree. Tree::apply and Tree::revert of deltas are the only ways to change a tree.
struct TreeDelta {
    /// A lasso stroke that came into force or went out of force.
    struct LassoChange {
        std::uint32_t index; ///< Into Tree::lassos()
        bool isInForce;      ///< After the delta; before it, the opposite
        bool operator==(const LassoChange&) const = default;
    };

    Step stepBefore = 0;
    Step stepAfter = 0;
    std::uint32_t parametersBefore = 0; ///< Index of the parameter set in force
    std::uint32_t parametersAfter = 0;
    IdRange born;                    ///< New internodes; the last rows of the tree
    IdRange bornLeaves;              ///< New placed leaves; the last rows of their table
    KeptCounts kept;                 ///< Numbers of new kept values; the last ones of the tree
    std::vector<InternodeId> died;   ///< Internodes that died at stepAfter; all of each shed or pruned branch
    InternodeChanges internodes;     ///< Of internodes that existed before
    LeafChanges leaves;              ///< Of placed leaves that existed before; leaves.death removes them
    SparseChanges sparse;            ///< Each id at most once a column
    std::vector<LassoChange> lassos; ///< Each index at most once
    /// The new rows and values while the tree does not have them: reverting moves them here, and applying
    /// moves them back, so that each row is stored once. Null while the delta is applied, and in a delta
    /// that adds nothing. A document's thread writes it in deltas that snapshots share, so it belongs to that
    /// thread: other threads use Tree::revertDropping(). All else in a shared delta never changes.
    std::shared_ptr<TreeRows> rows;
    /// The record of the edit that begins with this delta. Null in the edit's other deltas, and in deltas
    /// from files that are older than records.
    std::shared_ptr<const EditRecord> record;

    /// Adds the change of an internode that is bent or stretched (lengths in m). Descendants move with it.
    void addFrame(InternodeId id, const Rotation& before, const Rotation& after, float lengthBefore,
                  float lengthAfter);

    /// Frees the memory beyond the sizes of its lists. For deltas that are kept.
    void squeeze();

    bool isEmpty() const;
    bool bringsRows() const { return born.count > 0 || bornLeaves.count > 0 || kept != KeptCounts(); }
    /// Memory in bytes, without rows.
    std::size_t bytes() const;
    /// Compares everything except rows, which depend on whether the delta is applied.
    bool operator==(const TreeDelta& other) const;

    /// Calls @p visit(id) for each internode that the delta creates, or whose death or buds it changes; not
    /// for neighbours of these internodes, nor for internodes that only move. After a revert, the new
    /// internodes' ids are those of rows that are no longer in the tree.
    template <class Visit>
    void forEachTouched(Visit&& visit) const
    {
        for (InternodeId id = born.first; id != born.end(); ++id)
            visit(id);
        forEachTouchedRow(visit);
    }
    /// The same without the new internodes.
    template <class Visit>
    void forEachTouchedRow(Visit&& visit) const
    {
        for (const InternodeId id : died) {
            if (!born.contains(id))
                visit(id);
        }
        forEachOldRow(internodes.buds, visit);
    }
    /// Calls @p visit(id), possibly more than once, for each internode, apart from the new ones, whose place
    /// on its parent, frame, length or root position changes.
    template <class Visit>
    void forEachReframed(Visit&& visit) const
    {
        forEachOldRow(internodes.rotation, visit);
        forEachOldRow(internodes.length, visit);
        forEachOldRow(internodes.along, visit);
        forEachOldRow(sparse.rootPosition, visit);
    }
    bool reframes() const
    {
        return !internodes.rotation.empty() || !internodes.length.empty() || !internodes.along.empty() ||
               !sparse.rootPosition.empty();
    }

private:
    /// Calls @p visit(row) for the rows of @p changes that the delta does not create. After a revert, the
    /// others are no longer in the tree.
    template <class Changes, class Visit>
    void forEachOldRow(const Changes& changes, Visit&& visit) const
    {
        for (const auto& change : changes) {
            if (!born.contains(change.row))
                visit(change.row);
        }
    }
};

/// The history of a tree in simulation time: all deltas that led to its present state, first to last.
using Journal = std::vector<std::shared_ptr<TreeDelta>>;

} // namespace espalier
