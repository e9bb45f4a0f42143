// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"

namespace espalier {

/// A width that a person has set at an internode (TreeSketch §3.3).
struct WidthConstraint {
    InternodeId id = 0;
    float diameter = 0.0F; ///< m, > 0

    bool operator==(const WidthConstraint&) const = default;
};

} // namespace espalier
