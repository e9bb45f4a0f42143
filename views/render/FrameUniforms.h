// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace espalier {

/// What all programs of one picture share, laid out as the uniform block of resources/shaders/frame.glsl
/// (std140), where the meaning of each field is told.
struct FrameUniforms {
    using Vector = std::array<float, 4>;
    using Matrix = std::array<float, 16>;

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
};
static_assert(sizeof(FrameUniforms) == 3 * 64 + 14 * 16);

} // namespace espalier
