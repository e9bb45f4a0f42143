// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/texture/TextureShading.h"
#include "model/texture/TileNoise.h"

#include <numbers>

namespace espalier {

/// One place of a leaf's texture.
struct LeafPoint : TexturePoint {
    LeafPoint() { roughness = 0.0F; } // what is added to the leaf's roughness here

    float alpha = 0.0F;
};

/// A colour of the given hue (rad), saturation and value (0...1).
inline Colour fromHsv(float hue, float saturation, float value)
{
    const auto channel = [&](float offset) {
        const float turn = std::fmod(hue * (3.0F / std::numbers::pi_v<float>)+offset + 12.0F, 6.0F);
        return value - value * saturation * clamped(std::min(turn, 4.0F - turn));
    };
    return {channel(5.0F), channel(3.0F), channel(1.0F)};
}

/// The position of a pixel in a blade.
struct BladePlace {
    float u = 0.0F; ///< Position in the image
    float v = 0.0F;
    float along = 0.0F;  ///< 0 at the blade's base, 1 at its tip
    float inside = 0.0F; ///< Distance from the margin inward, in half widths
    float rib = 0.0F;    ///< 0...1, midrib
    float vein = 0.0F;   ///< 0...1, lateral vein
    float bulge = 0.0F;  ///< 0...1, between the veins
};

/// The upper face of a leaf of the given hue (rad): darker than its veins, mottled, worn at the margin.
inline LeafPoint paintedBlade(const BladePlace& place, float leafHue, float veinStrength)
{
    const TileNoise& noise = TileNoise::shared();
    const float net = 1.0F - smoothStep(0.0F, 0.12F, std::abs(noise(4.0F * place.u, 5.0F * place.v)));
    const float mottle = noise(place.u + 0.2F, place.v);
    const float fine = noise(8.0F * place.u, 8.0F * place.v);
    const float margin = 1.0F - smoothStep(0.0F, 0.1F, place.inside);

    const float pale = std::max(place.rib, 0.75F * place.vein);
    const float hue = leafHue - 0.06F * mottle - 0.10F * pale - 0.05F * margin;
    const float saturation = 0.66F - 0.16F * pale - 0.05F * net + 0.05F * mottle;
    const float value = 0.47F + 0.13F * pale + 0.03F * net + 0.06F * mottle + 0.03F * fine - 0.05F * margin -
                        0.05F * (1.0F - smoothStep(0.0F, 0.5F, place.along));
    LeafPoint point;
    point.colour = fromHsv(hue, saturation, value);
    point.height = 0.6F * veinStrength * place.bulge + 0.08F * fine - 0.12F * net - 0.5F * place.rib -
                   0.25F * place.vein;
    // Added to the roughness of the shape: the wax is thinnest on ribs and at the margin.
    point.roughness = 0.12F * pale + 0.05F * net + 0.06F * fine + 0.08F * margin;
    return point;
}

/// A petiole's colour.
inline Colour petioleColour(float leafHue)
{
    return fromHsv(leafHue - 0.3F, 0.5F, 0.46F);
}

} // namespace espalier
