// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Parallel.h"
#include "model/texture/TextureShading.h"
#include "model/texture/Textures.h"
#include "model/texture/TileNoise.h"

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace espalier {

namespace {

/// Long ridges that part and join again around furrows, crossed by fine cracks: oak, ash, willow.
class FurrowedBark {
public:
    static constexpr float kRelief = 0.045F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float sway = m_noise(v + 0.31F, u + 0.17F);
        const float fray = m_noise(4.0F * u, 3.0F * v + 0.5F);
        const float fibre = m_noise(12.0F * u + 0.4F * bend, 2.0F * v);
        const float grain = m_noise(8.0F * u, 8.0F * v);
        const float x = u + 0.045F * bend + 0.012F * fray;
        const TileCells::Nearest ridge = m_ridges.nearest(x, v + 0.05F * sway + 0.006F * fray);
        // Furrows run along the trunk: lines across it are only cracks.
        const float furrow = ridge.edge * (1.0F + 2.2F * ridge.levelness) + 0.05F * fray;
        const float side = std::abs(m_noise(3.0F * u + 0.2F * sway, v + 0.6F)) + 0.05F;
        const float crack = std::abs(m_noise(2.0F * u + 0.3F, 5.0F * v + 0.2F * bend));

        const float wall = smoothStep(0.02F, 0.23F, furrow) * smoothStep(-0.04F, 0.16F, side);
        const float crest = smoothStep(0.14F, 0.46F, furrow) * smoothStep(0.04F, 0.3F, side);
        const float split = 1.0F - smoothStep(0.0F, 0.07F, crack);
        const float height =
            0.62F * wall + 0.22F * crest + wall * (0.12F * fibre + 0.07F * grain - 0.16F * split);

        const Colour deep{0.12F, 0.095F, 0.075F};
        const Colour flank{0.36F, 0.30F, 0.24F};
        const Colour top{0.55F, 0.50F, 0.43F};
        Colour colour = mix(deep, flank, wall);
        colour = mix(colour, top, crest * clamped(0.6F + 0.5F * fibre + 0.3F * grain));
        colour = mix(colour, {0.43F, 0.46F, 0.35F}, 0.45F * smoothStep(0.1F, 0.6F, sway) * crest);
        return {colour * ((1.0F - 0.4F * split * wall) * (1.0F + 0.2F * fibre + 0.16F * grain)), height,
                0.95F - 0.22F * crest * (1.0F - split) + 0.08F * grain};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_ridges{9, 3, 0.95F, 12};
};

/// Thin grey skin, blotched, with faint wrinkles and scattered lenticels: beech, hornbeam, young trees of all
/// kinds.
class SmoothBark {
public:
    static constexpr float kRelief = 0.012F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float wrinkles = m_noise(u + 0.6F, 5.0F * v + 0.25F * bend);
        const float grain = m_noise(7.0F * u, 11.0F * v);
        const float blotch =
            smoothStep(0.02F, 0.4F, m_noise(2.0F * u + 0.15F * bend, 2.0F * v + 0.4F) + 0.12F * grain);
        const float algae = smoothStep(0.1F, 0.7F, m_noise(u + 0.23F, v + 0.77F));
        const TileCells::Sample cell = m_lenticels.own(u, v + 0.004F * grain);
        const float size = cell.value - 0.62F;
        const float dot = std::sqrt(cell.x * cell.x + 6.0F * cell.y * cell.y);
        const float lenticel = size > 0.0F ? 1.0F - smoothStep(0.3F * size, 0.25F * size + 0.12F, dot) : 0.0F;

        const float height = 0.5F + 0.3F * wrinkles + 0.2F * bend + 0.14F * grain + 0.3F * lenticel;
        Colour colour =
            mix({0.45F, 0.44F, 0.41F}, {0.60F, 0.59F, 0.55F}, clamped(0.5F + 0.5F * wrinkles + 0.7F * bend));
        colour = mix(colour, {0.71F, 0.72F, 0.68F}, 0.6F * blotch);
        colour = mix(colour, {0.43F, 0.47F, 0.36F}, 0.4F * algae);
        colour = mix(colour, {0.36F, 0.32F, 0.28F}, 0.55F * lenticel);
        return {colour * (1.0F + 0.14F * grain), height,
                0.6F + 0.16F * blotch + 0.2F * algae + 0.15F * lenticel + 0.1F * grain};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_lenticels{13, 34, 0.6F, 27};
};

/// Thick plates of many flaking layers with deep cracks between them: pine, larch.
class PlatedBark {
public:
    static constexpr float kRelief = 0.05F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float sway = m_noise(v + 0.43F, u + 0.71F);
        const float fray = m_noise(4.0F * u + 0.3F, 3.0F * v);
        const float grain = m_noise(9.0F * u, 9.0F * v);
        const float flakes = m_noise(u + 0.57F, v + 0.19F);
        const float x = u + 0.06F * bend + 0.018F * fray;
        const float y = v + 0.07F * sway + 0.018F * fray;
        const TileCells::Nearest plate = m_plates.nearest(x, y);
        const float rim = plate.edge * (1.0F + 0.9F * plate.levelness) + 0.06F * fray;

        const float raised = smoothStep(-0.01F, 0.12F, rim);
        // Layers lie one on the other like shingles: each ends in a step.
        const float layers =
            5.5F * (0.4F + 0.75F * flakes + 0.35F * smoothStep(0.05F, 0.5F, rim) + 0.2F * plate.value);
        const float level = std::floor(layers);
        const float rise = layers - level;
        const float step = level + smoothStep(0.0F, 0.14F, rise);
        const float lip = (1.0F - smoothStep(0.0F, 0.2F, rise)) * raised;
        const float height = raised * (0.42F + 0.11F * step) + 0.045F * grain;

        const Colour deep{0.13F, 0.09F, 0.075F};
        const Colour rust{0.53F, 0.345F, 0.235F};
        const Colour grey{0.57F, 0.50F, 0.445F};
        const float tone = 0.5F + 0.32F * std::sin(2.4F * level + 5.0F * plate.value);
        Colour colour = mix(rust, grey, clamped(0.25F + 0.5F * tone + 0.35F * grain + 0.3F * sway));
        colour = colour * ((0.84F + 0.065F * step) * (1.0F - 0.42F * lip));
        colour = mix(deep, colour, smoothStep(-0.02F, 0.13F, rim));
        return {colour * (1.0F + 0.22F * grain), height, 0.96F - 0.2F * raised * (1.0F - lip) + 0.1F * grain};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_plates{5, 3, 0.95F, 32};
};

/// A level lenticel, pointed at both ends, in cells whose random value is @p rarity or more; the higher the
/// value, the longer the lenticel.
float lenticelIn(const TileCells::Sample& cell, float rarity, float thickness, float grain)
{
    if (cell.value < rarity)
        return 0.0F;
    const float length = 0.14F + 0.24F * (cell.value - rarity) / (1.0F - rarity);
    const float along = cell.x / length;
    const float half = thickness * (1.0F - along * along) + 0.04F * grain;
    return half > 0.0F ? 1.0F - smoothStep(0.6F * half, half + 0.03F, std::abs(cell.y)) : 0.0F;
}

/// White paper with dark lenticels in level dashes, and black scars where it has torn: birch.
class BirchBark {
public:
    static constexpr float kRelief = 0.018F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float wear = m_noise(v + 0.37F, u + 0.59F);
        const float grain = m_noise(9.0F * u, 16.0F * v);
        const float rough = m_noise(7.0F * u, 5.0F * v + 0.3F);
        const float bands = m_noise(u + 0.2F, 6.0F * v);
        const float y = v + 0.01F * bend;
        // Lenticels of three sizes; they come in swarms.
        const float swarm = 0.16F * wear;
        const float dash = std::max({lenticelIn(m_longDashes.own(u, y), 0.74F + swarm, 0.1F, grain),
                                     lenticelIn(m_dashes.own(u + 0.3F, y), 0.76F + swarm, 0.13F, grain),
                                     0.75F * lenticelIn(m_specks.own(u, y), 0.72F - swarm, 0.2F, grain)});
        const TileCells::Sample scarCell = m_scars.own(u + 0.012F * rough, y + 0.012F * rough);
        const float reach = 0.5F * (scarCell.value - 0.55F);
        const float torn =
            std::abs(scarCell.x) * 0.75F + std::abs(scarCell.y) * 1.5F + 0.1F * rough + 0.05F * grain;
        const float scar = reach > 0.0F ? 1.0F - smoothStep(reach, reach + 0.05F, torn) : 0.0F;
        const float peel = smoothStep(0.0F, 0.035F, std::abs(bands - 0.28F));

        const float height = 0.55F + 0.1F * bands + 0.08F * grain - 0.32F * dash - 0.14F * (1.0F - peel) +
                             scar * (0.3F * rough - 0.2F);
        Colour colour = mix({0.85F, 0.84F, 0.81F}, {0.94F, 0.925F, 0.895F}, clamped(0.5F + bands));
        colour = mix(colour, {0.84F, 0.71F, 0.60F}, 0.55F * smoothStep(0.1F, 0.55F, wear));
        colour = mix(colour, {0.66F, 0.66F, 0.64F}, 0.5F * smoothStep(0.1F, 0.6F, bend));
        colour = colour * (0.86F + 0.14F * peel);
        colour = mix(colour, {0.2F, 0.165F, 0.15F}, 0.88F * dash);
        colour = mix(colour, Colour{0.15F, 0.13F, 0.12F} * (1.0F + 0.9F * rough), scar);
        return {colour * (1.0F + 0.06F * grain), height,
                0.5F + 0.35F * std::max(dash, scar) + 0.12F * (1.0F - peel) + 0.1F * grain};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_longDashes{2, 26, 0.35F, 47};
    TileCells m_dashes{5, 44, 0.35F, 48};
    TileCells m_specks{15, 64, 0.35F, 49};
    TileCells m_scars{2, 4, 0.3F, 50};
};

/// Thin glossy skin, red-brown, in level bands with long corky lenticels: cherry.
class CherryBark {
public:
    static constexpr float kRelief = 0.014F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float wear = m_noise(v + 0.21F, u + 0.83F);
        const float grain = m_noise(8.0F * u, 18.0F * v);
        const float bands = m_noise(u + 0.4F, 9.0F * v + 0.2F * bend);
        const float y = v + 0.008F * bend;
        const float cork = std::max(lenticelIn(m_long.own(u, y), 0.45F, 0.2F, grain),
                                    0.8F * lenticelIn(m_short.own(u + 0.17F, y), 0.55F, 0.26F, grain));
        const float peel = 1.0F - smoothStep(0.0F, 0.03F, std::abs(bands - 0.35F));

        const float height = 0.45F + 0.12F * bands + 0.06F * grain + 0.4F * cork - 0.2F * peel;
        Colour colour = mix({0.27F, 0.155F, 0.13F}, {0.45F, 0.29F, 0.24F}, clamped(0.5F + 0.8F * bands));
        colour = mix(colour, {0.47F, 0.42F, 0.39F}, 0.6F * smoothStep(0.0F, 0.5F, wear));
        colour = mix(colour, {0.60F, 0.48F, 0.38F}, 0.75F * cork);
        return {colour * ((1.0F + 0.12F * grain) * (1.0F - 0.3F * peel)), height,
                0.38F + 0.45F * cork + 0.25F * smoothStep(0.0F, 0.5F, wear) + 0.15F * peel + 0.08F * grain};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_long{3, 24, 0.5F, 61};
    TileCells m_short{7, 30, 0.6F, 62};
};

/// Bark that falls in plates and leaves patches of cream, olive and grey: plane, lacebark pine.
class MottledBark {
public:
    static constexpr float kRelief = 0.014F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float sway = m_noise(v + 0.63F, u + 0.11F);
        const float fray = m_noise(5.0F * u + 0.1F, 4.0F * v);
        const float grain = m_noise(9.0F * u, 9.0F * v);
        // Each fallen layer left its own patches; the oldest layer is drawn on top.
        const float x = u + 0.06F * bend;
        const float y = v + 0.06F * sway;
        const float middle = patch(m_noise(2.0F * x + 0.31F, 2.0F * y + 0.17F) + 0.12F * fray, -0.05F);
        const float oldest = patch(m_noise(3.0F * x + 0.77F, 2.0F * y + 0.59F) + 0.12F * fray, 0.22F);
        const float specks = smoothStep(0.35F, 0.6F, m_noise(6.0F * u + 0.4F, 6.0F * v + 0.7F));

        Colour colour = mix({0.70F, 0.67F, 0.52F}, {0.78F, 0.76F, 0.66F}, clamped(0.5F + bend));
        colour = mix(colour, {0.50F, 0.51F, 0.37F}, middle);
        colour = mix(colour, mix({0.40F, 0.37F, 0.31F}, {0.47F, 0.41F, 0.34F}, clamped(0.5F + sway)), oldest);
        colour = mix(colour, {0.36F, 0.31F, 0.26F}, 0.35F * specks);
        const float height = 0.3F + 0.2F * middle + 0.3F * oldest + 0.06F * grain + 0.08F * fray;
        return {colour * (1.0F + 0.1F * grain), height,
                0.58F + 0.1F * middle + 0.2F * oldest + 0.08F * specks + 0.08F * grain};
    }

private:
    static float patch(float level, float margin) { return smoothStep(margin, margin + 0.03F, level); }

    const TileNoise& m_noise = TileNoise::shared();
};

/// Soft strips of long red fibres that come off in shreds: redwood, cedar, juniper.
class FibrousBark {
public:
    static constexpr float kRelief = 0.035F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float sway = m_noise(v + 0.51F, u + 0.27F);
        const float x = u + 0.03F * bend + 0.015F * sway;
        const TileCells::Nearest strip = m_strips.nearest(x, v + 0.06F * sway);
        const float gap = strip.edge * (1.0F + 2.6F * strip.levelness);
        const float strand = m_noise(14.0F * x, v + 0.3F);
        const float thread = m_noise(16.0F * x + 0.5F, 3.0F * v);
        const float shred = smoothStep(0.15F, 0.5F, m_noise(5.0F * x + 0.2F, 2.0F * v + 0.6F));

        const float wall = smoothStep(0.0F, 0.2F, gap);
        const float height = wall * (0.55F + 0.2F * strand + 0.12F * thread + 0.18F * shred);
        Colour colour = mix({0.17F, 0.085F, 0.06F}, {0.47F, 0.27F, 0.185F}, wall);
        colour =
            mix(colour, {0.58F, 0.44F, 0.36F}, clamped(0.35F * shred + 0.35F * strand + 0.15F * strip.value));
        return {colour * (1.0F + 0.28F * thread * wall + 0.1F * strand), height,
                0.97F - 0.14F * wall * (1.0F - shred) + 0.06F * thread};
    }

private:
    const TileNoise& m_noise = TileNoise::shared();
    TileCells m_strips{11, 2, 0.95F, 83};
};

/// Rings where leaves once stood, with short fibres between them: palms, tree ferns.
class RingedBark {
public:
    static constexpr float kRelief = 0.03F;

    TexturePoint operator()(float u, float v) const
    {
        const float bend = m_noise(u, v);
        const float fray = m_noise(6.0F * u, 3.0F * v + 0.2F);
        const float fibre = m_noise(15.0F * u + 0.3F * bend, 4.0F * v);
        const float grain = m_noise(9.0F * u, 9.0F * v);
        const float ring = static_cast<float>(kRings) * (v + 0.012F * bend + 0.006F * fray) + 0.5F;
        const float within = ring - std::floor(ring);
        // The lip of a scar stands out, and there are no fibres below it.
        const float lip = smoothStep(0.0F, 0.1F, within) * (1.0F - smoothStep(0.16F, 0.42F, within));
        const float groove = 1.0F - smoothStep(0.0F, 0.09F, std::min(within, 1.0F - within));
        const float height = 0.35F + 0.4F * lip - 0.3F * groove + 0.16F * fibre + 0.06F * grain;
        Colour colour = mix({0.40F, 0.345F, 0.28F}, {0.56F, 0.51F, 0.44F}, clamped(lip + 0.5F * bend));
        colour = mix(colour, {0.20F, 0.165F, 0.13F}, 0.8F * groove);
        return {colour * (1.0F + 0.22F * fibre + 0.12F * grain), height,
                0.8F - 0.16F * lip + 0.15F * groove + 0.1F * fibre};
    }

private:
    static constexpr int kRings = 9;

    const TileNoise& m_noise = TileNoise::shared();
};

using Bark = std::variant<FurrowedBark, SmoothBark, PlatedBark, BirchBark, CherryBark, MottledBark,
                          FibrousBark, RingedBark>;

Bark barkOf(BarkKind kind)
{
    switch (kind) {
    case BarkKind::Furrowed:
        return FurrowedBark{};
    case BarkKind::Smooth:
        return SmoothBark{};
    case BarkKind::Plated:
        return PlatedBark{};
    case BarkKind::Birch:
        return BirchBark{};
    case BarkKind::Cherry:
        return CherryBark{};
    case BarkKind::Mottled:
        return MottledBark{};
    case BarkKind::Fibrous:
        return FibrousBark{};
    case BarkKind::Ringed:
        return RingedBark{};
    }
    return SmoothBark{};
}

} // namespace

QImage barkAlbedo(BarkKind kind, int size)
{
    return std::visit([size](const auto& bark) { return paintAlbedo(size, bark); }, barkOf(kind));
}

SurfaceTextures barkTextures(BarkKind kind, int size)
{
    return std::visit([size](const auto& bark) { return paintSurface(size, bark, bark.kRelief, true); },
                      barkOf(kind));
}

} // namespace espalier
