// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/CompoundLeaf.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

Vec2 along(const Vec2& from, float angle, float length)
{
    return from + length * Vec2(std::sin(angle), std::cos(angle));
}

float stalkDistance(const LeafStalk& stalk, const Vec2& place)
{
    const Vec2 span = stalk.to - stalk.from;
    const float share = clamped((place - stalk.from).dot(span) / span.squaredNorm());
    return (place - stalk.from - share * span).norm();
}

} // namespace

CompoundForm palmateForm()
{
    CompoundForm form{.aspect = 1.0F,
                      .leaflets = {},
                      .stalks = {{{0.0F, 0.0F}, {0.0F, 0.36F}, 0.016F}},
                      .veins = 7,
                      .veinRise = 0.28F,
                      .veinStrength = 0.8F};
    const Vec2 heart(0.0F, 0.31F);
    struct Lobe {
        float angle; ///< rad, from the midrib
        float length;
        float width;
    };
    for (const Lobe& lobe : {Lobe{0.0F, 0.67F, 0.58F}, Lobe{0.75F, 0.6F, 0.58F}, Lobe{1.6F, 0.45F, 0.62F}}) {
        for (const float side : {-1.0F, 1.0F}) {
            if (lobe.angle == 0.0F && side > 0.0F)
                continue;
            const float angle = side * lobe.angle;
            form.leaflets.push_back({.base = along(heart, angle, -0.02F),
                                     .tip = along(heart, angle, lobe.length),
                                     .width = lobe.width,
                                     .baseCurve = 0.62F,
                                     .tipCurve = 1.0F,
                                     .teeth = 4,
                                     .toothDepth = 0.3F});
        }
    }
    return form;
}

CompoundForm pinnateForm()
{
    CompoundForm form{.aspect = 0.62F,
                      .leaflets = {},
                      .stalks = {{{0.0F, 0.0F}, {0.0F, 0.8F}, 0.009F}},
                      .veins = 9,
                      .veinRise = 0.2F,
                      .veinStrength = 0.6F};
    constexpr int pairs = 5;
    for (int i = 0; i < pairs; ++i) {
        const float share = static_cast<float>(i) / (pairs - 1);
        const Vec2 node(0.0F, 0.18F + 0.5F * share);
        const float length = 0.27F + 0.05F * std::sin(std::numbers::pi_v<float> * (0.2F + 0.6F * share));
        for (const float side : {-1.0F, 1.0F}) {
            const float angle = side * (1.12F - 0.3F * share);
            form.leaflets.push_back({.base = along(node, angle, 0.01F),
                                     .tip = along(node, angle, length),
                                     .width = 0.36F,
                                     .baseCurve = 0.6F,
                                     .tipCurve = 0.95F,
                                     .teeth = 9,
                                     .toothDepth = 0.08F});
        }
    }
    form.leaflets.push_back({.base = {0.0F, 0.7F},
                             .tip = {0.0F, 0.985F},
                             .width = 0.4F,
                             .baseCurve = 0.6F,
                             .tipCurve = 0.95F,
                             .teeth = 9,
                             .toothDepth = 0.08F});
    return form;
}

CompoundForm frondForm()
{
    CompoundForm form{.aspect = 0.42F,
                      .leaflets = {},
                      .stalks = {{{0.0F, 0.0F}, {0.0F, 0.9F}, 0.008F}},
                      .veins = 0,
                      .veinRise = 0.0F,
                      .veinStrength = 0.3F};
    constexpr int pairs = 30;
    for (int i = 0; i < pairs; ++i) {
        const float share = static_cast<float>(i) / (pairs - 1);
        const Vec2 node(0.0F, 0.1F + 0.8F * share);
        // The longest leaflets are a third of the way up.
        const float length = 0.1F + 0.12F * std::sin(std::numbers::pi_v<float> * std::pow(share, 0.7F));
        for (const float side : {-1.0F, 1.0F}) {
            const float angle = side * (1.05F - 0.65F * share);
            form.leaflets.push_back(
                {.base = node,
                 .tip = along(node, angle, std::min(length, (0.985F - node.y()) / std::cos(angle))),
                 .width = 0.1F,
                 .baseCurve = 0.4F,
                 .tipCurve = 0.8F});
        }
    }
    form.leaflets.push_back(
        {.base = {0.0F, 0.86F}, .tip = {0.0F, 0.985F}, .width = 0.14F, .baseCurve = 0.4F, .tipCurve = 0.8F});
    return form;
}

CompoundLeaf::CompoundLeaf(CompoundForm form, int size, double hue)
    : m_form(std::move(form)), m_pixel(1.0F / static_cast<float>(size)), m_hue(static_cast<float>(hue))
{
    for (const Leaflet& leaflet : m_form.leaflets) {
        const float widest = leaflet.baseCurve / (leaflet.baseCurve + leaflet.tipCurve);
        m_scales.push_back(1.0F /
                           (std::pow(widest, leaflet.baseCurve) * std::pow(1.0F - widest, leaflet.tipCurve)));
    }
}

CompoundLeaf::InLeaflet CompoundLeaf::placeIn(std::size_t index, const Vec2& place) const
{
    const Leaflet& leaflet = m_form.leaflets[index];
    const Vec2 span = leaflet.tip - leaflet.base;
    const float length = span.norm();
    const Vec2 axis = span / length;
    const Vec2 offset = place - leaflet.base;
    const float t = offset.dot(axis) / length;
    const float aside = std::abs(axis.x() * offset.y() - axis.y() * offset.x());
    if (t <= 0.0F || t >= 1.0F)
        return {.along = t, .inside = -aside - length * std::max(-t, t - 1.0F), .length = length};
    float half = 0.5F * length * leaflet.width * m_scales[index] * std::pow(t, leaflet.baseCurve) *
                 std::pow(1.0F - t, leaflet.tipCurve);
    if (leaflet.teeth > 0) {
        const float tooth = t * static_cast<float>(leaflet.teeth);
        half *= 1.0F - leaflet.toothDepth * (tooth - std::floor(tooth)) * smoothStep(0.15F, 0.45F, t);
    }
    return {
        .along = t, .across = half > 0.0F ? aside / half : 1.0F, .inside = half - aside, .length = length};
}

LeafPoint CompoundLeaf::operator()(float u, float v) const
{
    const Vec2 place((u - 0.5F) * m_form.aspect, v);
    InLeaflet best{.inside = -2.0F};
    for (std::size_t i = 0; i < m_form.leaflets.size(); ++i) {
        const InLeaflet own = placeIn(i, place);
        // The blade in which the place lies deepest decides; where blades have grown together, the nearest
        // midrib decides whose veins are drawn.
        if (own.inside > best.inside)
            best = own;
    }
    float stalk = -2.0F;
    for (const LeafStalk& each : m_form.stalks)
        stalk = std::max(stalk, each.halfWidth - stalkDistance(each, place));

    float vein = 0.0F;
    float bulge = 0.5F;
    if (m_form.veins > 0) {
        const auto steps = static_cast<float>(m_form.veins);
        const float along = (best.along - m_form.veinRise * best.across) * steps;
        const float off = std::abs(along - std::round(along)) / steps;
        const float fading = 1.0F - smoothStep(0.5F, 1.0F, best.across);
        if (std::round(along) > 0.0F && std::round(along) < steps)
            vein = m_form.veinStrength * (0.35F + 0.65F * fading) * (1.0F - smoothStep(0.004F, 0.022F, off));
        bulge = smoothStep(0.0F, 0.5F / steps, off) * smoothStep(0.0F, 0.25F, best.across);
    }
    const float ribWidth = 0.05F + 0.12F * clamped(1.0F - best.along);
    LeafPoint point = paintedBlade({.u = u,
                                    .v = v,
                                    .along = best.along,
                                    .inside = best.inside / (0.2F * best.length),
                                    .rib = 1.0F - smoothStep(0.45F * ribWidth, ribWidth, best.across),
                                    .vein = vein,
                                    .bulge = bulge},
                                   m_hue, m_form.veinStrength);
    const float blade = clamped(0.5F + best.inside / m_pixel);
    const float stem = clamped(0.5F + stalk / m_pixel);
    if (stalk > best.inside && stem > 0.0F) {
        point.colour = petioleColour(m_hue);
        point.height = 0.4F * clamped(stalk / 0.01F);
    }
    point.alpha = std::max(blade, stem);
    return point;
}

} // namespace espalier
