// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/BroadLeaf.h"
#include "model/texture/CompoundLeaf.h"
#include "model/texture/NeedleSpray.h"
#include "model/texture/Textures.h"

#include <algorithm>

namespace espalier {

namespace {

/// Heights of 1 are this share of the image's edge: veins, and needles.
constexpr float kRelief = 0.012F;
constexpr float kNeedleRelief = 0.03F;

constexpr BladeForm kOvate{.baseCurve = 0.52F,
                           .tipCurve = 1.1F,
                           .petiole = 0.1F,
                           .teeth = 26,
                           .toothDepth = 0.07F,
                           .lobes = 0,
                           .lobeDepth = 0.0F,
                           .veinStrength = 1.0F,
                           .veins = 8,
                           .veinRise = 0.2F};
constexpr BladeForm kLanceolate{.baseCurve = 0.95F,
                                .tipCurve = 1.15F,
                                .petiole = 0.07F,
                                .teeth = 44,
                                .toothDepth = 0.05F,
                                .lobes = 0,
                                .lobeDepth = 0.0F,
                                .veinStrength = 0.45F,
                                .veins = 15,
                                .veinRise = 0.1F};
constexpr BladeForm kLobed{.baseCurve = 0.85F,
                           .tipCurve = 0.72F,
                           .petiole = 0.07F,
                           .teeth = 0,
                           .toothDepth = 0.0F,
                           .lobes = 4,
                           .lobeDepth = 0.52F,
                           .veinStrength = 1.0F,
                           .veins = 4,
                           .veinRise = 0.15F};
constexpr BladeForm kCordate{.baseCurve = 0.5F,
                             .tipCurve = 0.95F,
                             .petiole = 0.24F,
                             .teeth = 30,
                             .toothDepth = 0.04F,
                             .lobes = 0,
                             .lobeDepth = 0.0F,
                             .veinStrength = 0.9F,
                             .veins = 6,
                             .veinRise = 0.26F,
                             .sinus = 0.16F};
constexpr BladeForm kWillow{.baseCurve = 0.7F,
                            .tipCurve = 0.9F,
                            .petiole = 0.05F,
                            .teeth = 0,
                            .toothDepth = 0.0F,
                            .lobes = 0,
                            .lobeDepth = 0.0F,
                            .veinStrength = 0.3F,
                            .veins = 20,
                            .veinRise = 0.06F};

template <class Leaf>
QImage paintLeaf(int size, const Leaf& leaf)
{
    return paintPixels(size, QImage::Format_RGBA8888, [&](float u, float v, uchar*& out) {
        const LeafPoint point = leaf(u, v);
        writeColour(point.colour, out);
        *out++ = toByte(point.alpha);
    });
}

/// Roughness of the upper face between the veins: leathery leaves and needles are waxy, thin leaves are
/// rough.
float roughnessOf(LeafShape shape)
{
    switch (shape) {
    case LeafShape::Needles:
    case LeafShape::Fascicle:
        return 0.42F;
    case LeafShape::Willow:
    case LeafShape::Frond:
        return 0.46F;
    case LeafShape::Lanceolate:
    case LeafShape::Lobed:
        return 0.5F;
    case LeafShape::Ovate:
    case LeafShape::Pinnate:
        return 0.54F;
    case LeafShape::Cordate:
    case LeafShape::Palmate:
    case LeafShape::Own:
        break;
    }
    return 0.6F;
}

/// Calls @p paint(leaf, relief) with the drawing of a shape.
template <class Paint>
auto withLeaf(LeafShape shape, int size, double hue, const Paint& paint)
{
    switch (shape) {
    case LeafShape::Lanceolate:
        return paint(BroadLeaf(kLanceolate, size, hue), kRelief);
    case LeafShape::Lobed:
        return paint(BroadLeaf(kLobed, size, hue), kRelief);
    case LeafShape::Cordate:
        return paint(BroadLeaf(kCordate, size, hue), kRelief);
    case LeafShape::Willow:
        return paint(BroadLeaf(kWillow, size, hue), kRelief);
    case LeafShape::Palmate:
        return paint(CompoundLeaf(palmateForm(), size, hue), kRelief);
    case LeafShape::Pinnate:
        return paint(CompoundLeaf(pinnateForm(), size, hue), kRelief);
    case LeafShape::Frond:
        return paint(CompoundLeaf(frondForm(), size, hue), kRelief);
    case LeafShape::Needles:
        return paint(NeedleSpray(NeedleSpray::Kind::Twig, size, hue), kNeedleRelief);
    case LeafShape::Fascicle:
        return paint(NeedleSpray(NeedleSpray::Kind::Fascicle, size, hue), kNeedleRelief);
    case LeafShape::Ovate:
    case LeafShape::Own:
        break;
    }
    return paint(BroadLeaf(kOvate, size, hue), kRelief);
}

} // namespace

QImage leafAlbedo(LeafShape shape, int size, double hue)
{
    return withLeaf(shape, size, hue, [size](const auto& leaf, float) { return paintLeaf(size, leaf); });
}

void saturateLeaf(QImage& albedo, double factor)
{
    if (factor == 1.0)
        return;
    const auto share = static_cast<float>(factor);
    for (int y = 0; y < albedo.height(); ++y) {
        uchar* pixel = albedo.scanLine(y);
        for (int x = 0; x < albedo.width(); ++x, pixel += 4) {
            const auto value = static_cast<float>(std::max({pixel[0], pixel[1], pixel[2]}));
            for (int i = 0; i < 3; ++i)
                pixel[i] = toByte((value - share * (value - static_cast<float>(pixel[i]))) / 255.0F);
        }
    }
}

SurfaceTextures leafTextures(LeafShape shape, int size, double hue)
{
    return withLeaf(shape, size, hue, [&](const auto& leaf, float relief) {
        const auto whole = [&leaf, roughness = roughnessOf(shape)](float u, float v) {
            LeafPoint point = leaf(u, v);
            point.roughness += roughness;
            return point;
        };
        return paintSurface(size, whole, relief, false);
    });
}

} // namespace espalier
