// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/texture/LeafPaint.h"

namespace espalier {

/// The outline and the veins of a simple leaf. Heights t go from 0 at the blade's base to 1 at its tip.
struct BladeForm {
    float baseCurve; ///< Half the width is t^baseCurve (1 − t)^tipCurve, scaled to a maximum of 1
    float tipCurve;
    float petiole;    ///< Share of the image below the blade
    int teeth;        ///< Along one side
    float toothDepth; ///< Share of the width
    int lobes;        ///< On one side; 0 for an entire leaf
    float lobeDepth;  ///< Share of the width
    float veinStrength;
    int veins;          ///< On one side
    float veinRise;     ///< Height of a vein at the margin above its height at the midrib, in t
    float sinus = 0.0F; ///< How far the blade reaches below its base on either side, in t
};

/// A leaf of one blade, as a texture.
class BroadLeaf {
public:
    BroadLeaf(const BladeForm& form, int size, double hue)
        : m_form(form), m_pixel(1.0F / static_cast<float>(size)), m_hue(static_cast<float>(hue))
    {
        const float widest = form.baseCurve / (form.baseCurve + form.tipCurve);
        m_scale = 0.96F / (std::pow(widest, form.baseCurve) * std::pow(1.0F - widest, form.tipCurve));
    }

    LeafPoint operator()(float u, float v) const
    {
        const float x = std::abs(2.0F * u - 1.0F);
        const bool left = u < 0.5F;
        const float t = bladeHeight(v);
        const float inside = blade(x, t);

        // Veins leave the midrib at the same heights on both sides, but for half a step.
        const float steps = static_cast<float>(m_form.veins);
        const float along = veinHeight(x, t) * steps + (m_form.lobes == 0 && left ? 0.5F : 0.0F);
        const float off = std::abs(along - std::round(along)) / steps;
        const float fading = 1.0F - smoothStep(0.5F, 1.0F, x);
        const bool hasVein = std::round(along) > 0.0F && std::round(along) < steps;
        const float vein = hasVein ? m_form.veinStrength * (0.35F + 0.65F * fading) *
                                         (1.0F - smoothStep(0.002F, 0.009F + 0.006F * fading, off))
                                   : 0.0F;
        const float ribWidth = 0.008F + 0.042F * clamped(1.0F - t);
        // The blade bulges between the veins.
        const float bulge = smoothStep(0.0F, 0.5F / steps, off) * (0.5F + 0.5F * fading);
        LeafPoint point = paintedBlade({.u = u,
                                        .v = v,
                                        .along = t,
                                        .inside = inside,
                                        .rib = 1.0F - smoothStep(0.45F * ribWidth, ribWidth, x),
                                        .vein = vein,
                                        .bulge = bulge * smoothStep(0.0F, 0.25F, x)},
                                       m_hue, m_form.veinStrength);
        point.alpha = std::max(coverage(u, v, inside), petioleCoverage(x, v));
        if (t < 0.0F && inside <= 0.0F)
            point.colour = petioleColour(m_hue);
        return point;
    }

private:
    /// Beyond this distance from the margin, in half widths, a pixel is wholly in or out.
    static constexpr float kEdgeBand = 0.15F;
    static constexpr float kBladeEnd = 0.98F;

    /// Height t of the row @p v in the blade; the blade ends just below the image's edge.
    float bladeHeight(float v) const { return (v - m_form.petiole) / (kBladeEnd - m_form.petiole); }

    /// The height at which the vein through a place leaves the midrib.
    float veinHeight(float x, float t) const { return t - m_form.veinRise * x * (1.0F + 0.35F * x); }

    /// Distance from the margin inward, in half widths; negative outside.
    float blade(float x, float t) const
    {
        // The lobes at the base of a heart-shaped leaf hang below it.
        t += m_form.sinus * std::sin(std::numbers::pi_v<float> * std::min(1.25F * x, 1.0F)) *
             (1.0F - smoothStep(0.0F, 0.5F, t));
        if (t <= 0.0F || t >= 1.0F)
            return -x - std::max(-t, t - 1.0F);
        float width = m_scale * std::pow(t, m_form.baseCurve) * std::pow(1.0F - t, m_form.tipCurve);
        if (m_form.teeth > 0) {
            // Teeth point to the tip.
            const float tooth = t * static_cast<float>(m_form.teeth);
            width *= 1.0F - m_form.toothDepth * (tooth - std::floor(tooth));
        }
        if (m_form.lobes > 0) {
            const float turn =
                2.0F * std::numbers::pi_v<float> * static_cast<float>(m_form.lobes) * veinHeight(x, t);
            const float round = std::sqrt(0.5F + 0.5F * std::cos(turn));
            // The last sinus stays shallow, otherwise it would cut the tip off.
            const float depth = m_form.lobeDepth * (1.0F - smoothStep(0.75F, 1.0F, t));
            width *= 1.0F - depth * (1.0F - round);
        }
        return width - x;
    }

    /// Coverage of a pixel by the region where @p inside > 0, from the slope of @p inside.
    float coverage(float u, float v, float inside) const
    {
        if (std::abs(inside) > kEdgeBand)
            return inside > 0.0F ? 1.0F : 0.0F;
        const auto at = [&](float du, float dv) {
            return blade(std::abs(2.0F * (u + du) - 1.0F), bladeHeight(v + dv));
        };
        const float dx = at(m_pixel, 0.0F) - inside;
        const float dy = at(0.0F, m_pixel) - inside;
        const float slope = std::sqrt(dx * dx + dy * dy) + 1e-6F;
        return clamped(0.5F + inside / slope);
    }

    float petioleCoverage(float x, float v) const
    {
        const float half = 0.035F + 0.02F * smoothStep(0.03F, 0.0F, v);
        return v < m_form.petiole + 0.03F ? clamped(0.5F + 0.5F * (half - x) / m_pixel) : 0.0F;
    }

    BladeForm m_form;
    float m_pixel;
    float m_hue;
    float m_scale;
};

} // namespace espalier
