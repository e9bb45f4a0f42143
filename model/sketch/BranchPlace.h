// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"

namespace espalier {

/// A place on the wood: 0 at the lower end of an internode, 1 at its node.
struct BranchPlace {
    InternodeId internode = 0;
    float along = 1.0F;

    bool operator==(const BranchPlace&) const = default;
};

} // namespace espalier
