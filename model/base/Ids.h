// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace espalier {

/// An internode's row in every column, in the order of the journal's births. A parent's id is always smaller
/// than its children's. Undo takes the rows of undone births out of the tree: what grows next gets the same
/// ids as if the undone births had never happened. Where an internode must be found again later, name it by
/// its InternodeKey.
using InternodeId = std::uint32_t;
inline constexpr InternodeId kNoInternode = std::numeric_limits<InternodeId>::max();

/// The name of an internode in recipes and the seed of its random numbers: a hash of its parent's key, the
/// bud that it grew from and the step that it was born in (Random.h). Two internodes of a tree have different
/// keys.
using InternodeKey = std::uint64_t;

/// A placed leaf's row in the table of placed leaves. Undo takes rows out as with internodes.
using LeafId = std::uint32_t;

/// Simulation time in growth steps.
using Step = std::uint32_t;
inline constexpr Step kNever = std::numeric_limits<Step>::max();

/// Consecutive rows of a table, which one edit adds.
struct IdRange {
    InternodeId first = 0;
    std::uint32_t count = 0;

    InternodeId end() const { return first + count; }
    bool contains(InternodeId id) const { return id >= first && id - first < count; }
    bool operator==(const IdRange&) const = default;
};

} // namespace espalier
