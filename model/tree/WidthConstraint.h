// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Ids.h"

namespace espalier {

/// A diameter that a person has given to an internode (TreeSketch §3.3). It sleeps while the internode is
/// dead.
struct WidthConstraint {
    InternodeId id = kNoInternode;
    float diameter = 0.0F; ///< m; what is not above 0 counts as a twig's

    bool operator==(const WidthConstraint&) const = default;
};

} // namespace espalier
