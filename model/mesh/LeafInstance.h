// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <type_traits>

namespace espalier {

/// A leaf in the form that the graphics card gets: 48 bytes without padding. It has no initial values, like
/// MeshVertex.
struct LeafInstance {
    std::array<float, 3> position; ///< m, where the petiole begins
    float length;                  ///< m, petiole to tip; 0 hides it
    /// Quaternion x, y, z, w: turns +Y into the direction of the midrib and +Z into the normal of the upper
    /// face.
    std::array<float, 4> rotation;
    float width;        ///< m
    float hueShift;     ///< Added to the texture's hue, rad
    float value;        ///< Factor of the texture's brightness
    std::int32_t shape; ///< LeafShape

    bool operator==(const LeafInstance&) const = default;
};
static_assert(sizeof(LeafInstance) == 48 && std::is_trivial_v<LeafInstance>);

} // namespace espalier
