// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace espalier {

/// The uniforms that all programs of one picture share, in the layout of the uniform block of
/// resources/shaders/frame.glsl (std140), which documents each field.
struct FrameUniforms {
    using Vector = std::array<float, 4>;
    using Matrix = std::array<float, 16>;
    static constexpr std::size_t kMostFeet = 8; ///< As in frame.glsl

    Matrix viewProjection{};
    Matrix inverseViewProjection{};
    Matrix shadowFromWorld{};
    Vector eye{};
    Vector sunDirection{};
    Vector sunColour{};
    Vector skyColour{};
    Vector groundColour{};
    Vector rimColour{};
    Vector lightOrigin{};
    Vector lightScale{};
    Vector crown{};
    Vector crownRadii{};
    Vector viewSize{};
    Vector backgroundInner{};
    Vector backgroundOuter{};
    Vector ground{};
    Vector foot{};
    Vector pass{};
    Vector groundShadow{};
    std::array<Vector, kMostFeet> feet{};
    Matrix centredViewProjection{}; ///< For the middles of the pixels; not in the block
};
static_assert(offsetof(FrameUniforms, centredViewProjection) ==
              3 * 64 + (17 + FrameUniforms::kMostFeet) * 16);

} // namespace espalier
