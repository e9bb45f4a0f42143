// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "views/render/FrameUniforms.h"

namespace espalier {

/// The light of one backdrop; colours are linear.
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

/// The uniforms with which the shaders draw the backdrop: two colours, as shown, and parameters of the
/// drawing.
struct BackdropColours {
    FrameUniforms::Vector inner; ///< w: kind, as in frame.glsl
    FrameUniforms::Vector outer;
};

BackdropColours backdropColours(const ViewValues& view);

} // namespace espalier
