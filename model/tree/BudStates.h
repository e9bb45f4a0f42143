// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace espalier {

/// A set of the buds at an internode's node: bit k for the bud in slot k.
using BudMask = std::uint16_t;

inline constexpr int kBudSlots = 16;
/// Lateral buds have the slots 0...kMaxLaterals - 1.
inline constexpr int kMaxLaterals = 6;
/// Slot of the terminal bud: what grows from it continues the axis.
inline constexpr int kTerminalSlot = 7;
/// Adventitious buds, which old wood makes, have the slots from here to kBudSlots - 1.
inline constexpr int kFirstAdventitiousSlot = 8;
inline constexpr BudMask kTerminalBud = 1U << kTerminalSlot;

constexpr BudMask budBit(int slot)
{
    return static_cast<BudMask>(1U << slot);
}

/// Whether there can be a bud in @p slot.
constexpr bool isBudSlot(int slot)
{
    return (slot >= 0 && slot < kMaxLaterals) || (slot >= kTerminalSlot && slot < kBudSlots);
}

enum class BudKind : std::uint8_t { Lateral, Terminal, Adventitious };

constexpr BudKind budKind(int slot)
{
    if (slot == kTerminalSlot)
        return BudKind::Terminal;
    return slot < kTerminalSlot ? BudKind::Lateral : BudKind::Adventitious;
}

enum class BudState : std::uint8_t {
    None,    ///< There is no bud, or it has become a branch
    Dormant, ///< It lives, but does not compete until its state becomes Active
    Active,  ///< It competes for light and space
    Dead,
};

/// The states of all buds at a node.
struct BudStates {
    BudMask living = 0; ///< Active or dormant
    BudMask other = 0;  ///< Dormant or dead

    /// All buds of @p mask are active; the other slots have no bud.
    static constexpr BudStates active(BudMask mask) { return {mask, 0}; }

    constexpr BudMask active() const { return static_cast<BudMask>(living & ~other); }
    constexpr BudState state(int slot) const
    {
        const BudMask bit = budBit(slot);
        if ((living & bit) != 0)
            return (other & bit) != 0 ? BudState::Dormant : BudState::Active;
        return (other & bit) != 0 ? BudState::Dead : BudState::None;
    }
    constexpr void set(int slot, BudState state)
    {
        const BudMask bit = budBit(slot);
        const auto put = [bit](BudMask& mask, bool isIn) {
            mask = static_cast<BudMask>(isIn ? mask | bit : mask & ~bit);
        };
        put(living, state == BudState::Active || state == BudState::Dormant);
        put(other, state == BudState::Dormant || state == BudState::Dead);
    }

    bool operator==(const BudStates&) const = default;
};

} // namespace espalier
