// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>

namespace espalier {

/// An internode's identity and its row in every column; given out in order of birth, never reused in a
/// document's life. A parent's id is always smaller than its children's.
using InternodeId = std::uint32_t;
inline constexpr InternodeId kNoInternode = std::numeric_limits<InternodeId>::max();

/// Simulation time in growth steps.
using Step = std::uint32_t;
inline constexpr Step kNever = std::numeric_limits<Step>::max();

/// Consecutive internodes, as one growth step makes them.
struct IdRange {
    InternodeId first = 0;
    std::uint32_t count = 0;

    InternodeId end() const { return first + count; }
    bool contains(InternodeId id) const { return id >= first && id - first < count; }
    bool operator==(const IdRange&) const = default;
};

} // namespace espalier
