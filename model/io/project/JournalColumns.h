// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeDelta.h"

#include <QList>

#include <optional>

namespace espalier {

/// How many rows the columns of a journal have.
struct JournalCounts {
    std::uint32_t deltas = 0;
    std::uint32_t died = 0;       ///< Of all deltas together
    std::uint32_t budChanges = 0; ///< Likewise
    std::uint32_t frames = 0;     ///< Likewise
    std::uint32_t widths = 0;     ///< Likewise
    std::uint32_t lassos = 0;     ///< Likewise

    static JournalCounts of(const Journal& journal);
};

/// A journal as columns: a row a delta, then all deaths, and all changes of a kind, in the same order.
struct JournalColumns {
    QList<Step> stepBefore;
    QList<Step> stepAfter;
    QList<std::uint32_t> parametersBefore;
    QList<std::uint32_t> parametersAfter;
    QList<InternodeId> bornFirst;
    QList<std::uint32_t> bornCount;
    QList<std::uint32_t> diedCount;
    QList<std::uint32_t> budCount;
    QList<std::uint32_t> frameCount;
    QList<std::uint32_t> widthCount;
    QList<std::uint32_t> lassoCount;
    QList<InternodeId> died;
    QList<InternodeId> budId;
    QList<BudMask> budBefore;
    QList<BudMask> budAfter;
    QList<InternodeId> frameId;
    QList<Rotation> rotationBefore;
    QList<Rotation> rotationAfter;
    QList<float> lengthBefore;
    QList<float> lengthAfter;
    QList<InternodeId> widthId;
    QList<float> widthBefore;
    QList<float> widthAfter;
    QList<std::uint32_t> lassoIndex;
    QList<std::uint8_t> lassoInForce; ///< Afterwards; 0 or 1

    static JournalColumns of(const Journal& journal);
    /// Nothing if the counts of the deltas do not add up to the rows, or if a flag is none. Precondition: the
    /// columns are of the sizes that @p counts says.
    std::optional<Journal> toJournal(const JournalCounts& counts) const;

    /// Calls @p visitor(name, column, rows) for each column, in a fixed order.
    template <class Self, class Visit>
    static void visit(Self& self, const JournalCounts& counts, Visit&& visitor)
    {
        visitor("stepBefore", self.stepBefore, counts.deltas);
        visitor("stepAfter", self.stepAfter, counts.deltas);
        visitor("parametersBefore", self.parametersBefore, counts.deltas);
        visitor("parametersAfter", self.parametersAfter, counts.deltas);
        visitor("bornFirst", self.bornFirst, counts.deltas);
        visitor("bornCount", self.bornCount, counts.deltas);
        visitor("diedCount", self.diedCount, counts.deltas);
        visitor("budCount", self.budCount, counts.deltas);
        visitor("frameCount", self.frameCount, counts.deltas);
        visitor("widthCount", self.widthCount, counts.deltas);
        visitor("lassoCount", self.lassoCount, counts.deltas);
        visitor("died", self.died, counts.died);
        visitor("budId", self.budId, counts.budChanges);
        visitor("budBefore", self.budBefore, counts.budChanges);
        visitor("budAfter", self.budAfter, counts.budChanges);
        visitor("frameId", self.frameId, counts.frames);
        visitor("rotationBefore", self.rotationBefore, counts.frames);
        visitor("rotationAfter", self.rotationAfter, counts.frames);
        visitor("lengthBefore", self.lengthBefore, counts.frames);
        visitor("lengthAfter", self.lengthAfter, counts.frames);
        visitor("widthId", self.widthId, counts.widths);
        visitor("widthBefore", self.widthBefore, counts.widths);
        visitor("widthAfter", self.widthAfter, counts.widths);
        visitor("lassoIndex", self.lassoIndex, counts.lassos);
        visitor("lassoInForce", self.lassoInForce, counts.lassos);
    }
};

} // namespace espalier
