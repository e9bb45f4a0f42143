// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/render/FrameUniforms.h"

namespace espalier {

/// The light before one backdrop; colours are linear.
struct Lighting {
    using Vector = FrameUniforms::Vector;

    Vector sun;
    Vector sky;
    Vector ground; ///< Light from below
    Vector rim;
    Vector groundAlbedo;
    float leastAmbient;  ///< a_min
    float lightExponent; ///< γ
    float exposure;
};

const Lighting& lightingOf(const ViewValues& view);

/// What the shaders draw behind the tree: two colours, as shown, and what they make of them.
struct BackdropColours {
    FrameUniforms::Vector inner; ///< w: kind, as in frame.glsl
    FrameUniforms::Vector outer;
};

BackdropColours backdropColours(const ViewValues& view);

} // namespace espalier
