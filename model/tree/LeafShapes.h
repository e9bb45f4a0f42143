// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/Parameters.h"

#include <array>

namespace espalier {

/// Width / length that leaves of a drawn shape usually have, within the limits of LeafParameters::aspect; of
/// needles and fascicles, the spray. The drawings and the bend of the blades are made for it.
constexpr double usualAspect(LeafShape shape)
{
    constexpr std::array<double, kLeafShapeCount + 1> aspects{
        0.6,  // Ovate
        0.2,  // Lanceolate
        0.65, // Lobed
        0.5,  // Needles
        0.85, // Cordate
        1.0,  // Palmate
        0.62, // Pinnate
        0.12, // Willow
        0.55, // Fascicle
        0.42, // Frond
        0.8   // Own, whose images say their own
    };
    return aspects[static_cast<std::size_t>(shape)];
}

} // namespace espalier
