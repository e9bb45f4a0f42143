// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/Lighting.h"

namespace espalier {

namespace {

constexpr Lighting kStudio{
    .sun = {3.7F, 3.2F, 2.45F, 0.0F},
    .sky = {0.58F, 0.69F, 0.86F, 0.0F},
    .ground = {0.17F, 0.16F, 0.14F, 0.0F},
    .rim = {0.5F, 0.6F, 0.75F, 0.0F},
    .groundAlbedo = {0.0255F, 0.0315F, 0.0415F, 0.0F},
    .leastAmbient = 0.14F,
    .lightExponent = 1.5F,
    .exposure = 0.86F,
};

constexpr Lighting kDaylight{
    .sun = {3.3F, 3.0F, 2.5F, 0.0F},
    .sky = {0.80F, 0.92F, 1.10F, 0.0F},
    .ground = {0.36F, 0.34F, 0.29F, 0.0F},
    .rim = {0.0F, 0.0F, 0.0F, 0.0F},
    .groundAlbedo = {0.30F, 0.29F, 0.27F, 0.0F},
    .leastAmbient = 0.2F,
    .lightExponent = 1.3F,
    .exposure = 0.8F,
};

constexpr FrameUniforms::Vector displayed(int red, int green, int blue, float kind)
{
    return {static_cast<float>(red) / 255.0F, static_cast<float>(green) / 255.0F,
            static_cast<float>(blue) / 255.0F, kind};
}

FrameUniforms::Vector displayed(const QColor& colour)
{
    return displayed(colour.red(), colour.green(), colour.blue(), 2.0F);
}

} // namespace

const Lighting& lightingOf(const ViewValues& view)
{
    return shownBackdrop(view) == Backdrop::DarkStudio ? kStudio : kDaylight;
}

BackdropColours backdropColours(const ViewValues& view)
{
    switch (shownBackdrop(view)) {
    case Backdrop::Horizon:
        return {displayed(226, 230, 232, 1.0F), displayed(150, 178, 206, 1.0F)};
    case Backdrop::Plain:
        return {displayed(view.backgroundColour), displayed(view.backgroundColour)};
    case Backdrop::Gradient:
        return {displayed(view.backgroundColour), displayed(view.backgroundTop)};
    case Backdrop::LightStudio:
        return {displayed(247, 247, 245, 4.0F), displayed(208, 212, 213, 4.0F)};
    case Backdrop::Studio:
    case Backdrop::DarkStudio:
        break;
    }
    return {displayed(74, 80, 88, 0.0F), displayed(34, 38, 44, 0.0F)};
}

} // namespace espalier
