// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"
#include "model/base/Vector.h"

#include <QList>

namespace espalier {

/// The living buds at an internode's upper end: bit k for the k-th lateral bud, kTerminalBud for the terminal
/// one.
using BudMask = std::uint8_t;
inline constexpr BudMask kTerminalBud = 0x80;
inline constexpr int kMaxLaterals = 6;
/// Slot of the terminal bud where lateral buds have slots 0...kMaxLaterals - 1.
inline constexpr int kTerminalSlot = 7;

constexpr BudMask budBit(int slot)
{
    return static_cast<BudMask>(1U << slot);
}

/// Internodes as columns: row i of each belongs to internode i (or, in a delta, to the i-th one that it
/// bears). QList shares implicitly: a copy is a snapshot that costs nothing until one side writes.
struct InternodeColumns {
    QList<InternodeId> parent; ///< kNoInternode for the base
    QList<Rotation>
        rotation; ///< Local frame against the parent's; +Y along the internode, +X to its first lateral bud
    QList<float> length; ///< m
    QList<float> vigour; ///< Of its bud when it grew, 0...1 of the strongest of the step
    QList<std::uint8_t>
        slot; ///< Bud of the parent's node that it grew from; kTerminalSlot continues the axis
    QList<BudMask> buds;
    QList<Step> birth;
    QList<Step> death;                 ///< kNever while it lives
    QList<std::uint8_t> present;       ///< 0 while its birth is undone
    QList<std::uint16_t> parameterSet; ///< What it was grown with

    std::uint32_t size() const { return static_cast<std::uint32_t>(parent.size()); }

    /// Calls @p visit(name, column) for each column, in a fixed order.
    template <class Self, class Visit>
    static void visit(Self& self, Visit&& visitor)
    {
        visitor("parent", self.parent);
        visitor("rotation", self.rotation);
        visitor("length", self.length);
        visitor("vigour", self.vigour);
        visitor("slot", self.slot);
        visitor("buds", self.buds);
        visitor("birth", self.birth);
        visitor("death", self.death);
        visitor("present", self.present);
        visitor("parameterSet", self.parameterSet);
    }
};

} // namespace espalier
