// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/tree/LassoStroke.h"

#include <span>

namespace espalier {

/// The filling of envelopes that tools start and stop; app implements it.
class EnvelopeFilling {
public:
    virtual ~EnvelopeFilling() = default;
    /// Ends what is under way, adds the envelope of @p stroke and fills it.
    virtual void fill(const LassoStroke& stroke) = 0;
    /// The same with several envelopes at once.
    virtual void fillAll(std::span<const LassoStroke> strokes) = 0;
    /// Ends filling at once and keeps what has grown.
    virtual void end() = 0;
    /// World positions of the living markers of free space, m; empty while nothing is filled.
    virtual std::span<const Vec3> markers() const = 0;
};

} // namespace espalier
