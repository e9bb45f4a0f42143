// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/texture/LeafPaint.h"

#include <vector>

namespace espalier {

/// One blade of a compound leaf. Lengths are shares of the leaf's length; the petiole is at the origin, y
/// points to the tip.
struct Leaflet {
    Vec2 base;
    Vec2 tip;
    float width;     ///< Share of the leaflet's length
    float baseCurve; ///< Half the width is t^baseCurve (1 − t)^tipCurve, scaled to a maximum of 1
    float tipCurve;
    int teeth = 0; ///< Along one side
    float toothDepth = 0.0F;
};

/// A straight stalk that carries leaflets.
struct LeafStalk {
    Vec2 from;
    Vec2 to;
    float halfWidth;
};

/// The drawing of a leaf with several blades, grown together (palmate) or separate (pinnate).
struct CompoundForm {
    float aspect; ///< Width / length that the drawing is made for
    std::vector<Leaflet> leaflets;
    std::vector<LeafStalk> stalks;
    int veins;      ///< On one side of a leaflet
    float veinRise; ///< Height of a vein at the margin above its height at the midrib
    float veinStrength;
};

/// Five or seven blades that spread from the petiole and have grown together, as on a maple.
CompoundForm palmateForm();
/// Leaflets in pairs along a stalk, and one at its end, as on an ash.
CompoundForm pinnateForm();
/// Many narrow leaflets along a stalk, as on a palm.
CompoundForm frondForm();

/// A compound leaf as a texture.
class CompoundLeaf {
public:
    CompoundLeaf(CompoundForm form, int size, double hue);

    LeafPoint operator()(float u, float v) const;

private:
    /// A place in a leaflet.
    struct InLeaflet {
        float along = 0.0F;  ///< 0...1, base to tip
        float across = 0.0F; ///< From the midrib, in half widths
        float inside = 0.0F; ///< Distance from the margin inward, in lengths of the leaf; negative outside
        float length = 1.0F; ///< Length of the leaflet
    };
    InLeaflet placeIn(std::size_t leaflet, const Vec2& place) const;

    CompoundForm m_form;
    float m_pixel;
    float m_hue;
    std::vector<float> m_scales; ///< Of the leaflets' outlines
};

} // namespace espalier
