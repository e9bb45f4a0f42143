// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/texture/LeafPaint.h"

#include <vector>

namespace espalier {

/// Needles, drawn one by one, as a texture.
class NeedleSpray {
public:
    enum class Kind {
        Twig,     ///< A twig with needles all around, as on a spruce
        Fascicle, ///< A tuft of long needles from one place, as on a pine
    };
    NeedleSpray(Kind kind, int size, double hue);

    const LeafPoint& operator()(float u, float v) const
    {
        const auto column = static_cast<int>(u * static_cast<float>(m_size));
        const auto row = static_cast<int>(v * static_cast<float>(m_size));
        return m_points[static_cast<std::size_t>(row * m_size + column)];
    }

private:
    void drawTwig();
    void drawFascicle();
    /// Draws a round, bent needle from @p a by @p b to @p c, with half-widths @p from and @p to, at the
    /// height @p level.
    void draw(const Vec2& a, const Vec2& b, const Vec2& c, float from, float to, const Colour& colour,
              float level);

    int m_size;
    float m_hue;
    std::vector<LeafPoint> m_points; ///< Rows from below
};

} // namespace espalier
