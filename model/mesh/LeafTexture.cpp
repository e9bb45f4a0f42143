// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Random.h"
#include "model/mesh/TextureShading.h"
#include "model/mesh/Textures.h"
#include "model/mesh/TileNoise.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace espalier {

namespace {

/// Beyond this distance from the margin, in half widths, a pixel is wholly in or out.
constexpr float kEdgeBand = 0.15F;
constexpr float kBladeEnd = 0.98F;
/// Heights of 1 are this share of the image's edge: veins, and needles.
constexpr float kRelief = 0.012F;
constexpr float kNeedleRelief = 0.03F;

struct LeafPoint : TexturePoint {
    float alpha = 0.0F;
};

/// A colour of the given hue (rad), saturation and value (0...1).
Colour fromHsv(float hue, float saturation, float value)
{
    const auto channel = [&](float offset) {
        const float turn = std::fmod(hue * (3.0F / std::numbers::pi_v<float>)+offset + 12.0F, 6.0F);
        return value - value * saturation * clamped(std::min(turn, 4.0F - turn));
    };
    return {channel(5.0F), channel(3.0F), channel(1.0F)};
}

/// The outline and the veins of a broad leaf. Heights t go from 0 at the blade's base to 1 at its tip.
struct BladeForm {
    float baseCurve; ///< Half the width is t^baseCurve (1 − t)^tipCurve, scaled to a maximum of 1
    float tipCurve;
    float petiole;    ///< Share of the image below the blade
    int teeth;        ///< Along one side
    float toothDepth; ///< Share of the width
    int lobes;        ///< On one side; 0 for an entire leaf
    float lobeDepth;  ///< Share of the width
    float veinStrength;
    int veins;      ///< On one side
    float veinRise; ///< How much higher a vein meets the margin than it leaves the midrib, in t
};

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

        LeafPoint point;
        point.alpha = std::max(coverage(u, v, inside), petioleCoverage(x, v));

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
        const float rib = 1.0F - smoothStep(0.45F * ribWidth, ribWidth, x);
        const float net = 1.0F - smoothStep(0.0F, 0.12F, std::abs(m_noise(4.0F * u, 5.0F * v)));
        const float mottle = m_noise(u + 0.2F, v);
        const float fine = m_noise(8.0F * u, 8.0F * v);
        const float margin = 1.0F - smoothStep(0.0F, 0.1F, inside);

        const float pale = std::max(rib, 0.75F * vein);
        const float hue = m_hue - 0.06F * mottle - 0.10F * pale - 0.05F * margin;
        const float saturation = 0.66F - 0.16F * pale - 0.05F * net + 0.05F * mottle;
        const float value = 0.47F + 0.13F * pale + 0.03F * net + 0.06F * mottle + 0.03F * fine -
                            0.05F * margin - 0.05F * (1.0F - smoothStep(0.0F, 0.5F, t));
        point.colour = fromHsv(hue, saturation, value);
        if (t < 0.0F)
            point.colour = fromHsv(m_hue - 0.3F, 0.5F, 0.46F);

        // The blade bulges between the veins.
        const float bulge = smoothStep(0.0F, 0.5F / steps, off) * (0.5F + 0.5F * fading);
        point.height = 0.6F * m_form.veinStrength * bulge * smoothStep(0.0F, 0.25F, x) + 0.08F * fine -
                       0.12F * net - 0.5F * rib - 0.25F * vein;
        return point;
    }

private:
    /// Of the blade; it ends just below the image's edge.
    float bladeHeight(float v) const { return (v - m_form.petiole) / (kBladeEnd - m_form.petiole); }

    /// The height at which the vein through a place left the midrib.
    float veinHeight(float x, float t) const { return t - m_form.veinRise * x * (1.0F + 0.35F * x); }

    /// How far inside of the margin, in half widths; negative outside.
    float blade(float x, float t) const
    {
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
            // The last sinus stays shallow, or the tip would come off.
            const float depth = m_form.lobeDepth * (1.0F - smoothStep(0.75F, 1.0F, t));
            width *= 1.0F - depth * (1.0F - round);
        }
        return width - x;
    }

    /// Coverage of a pixel by what is where @p inside > 0, by the slope of @p inside.
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

    const TileNoise& m_noise = TileNoise::shared();
    BladeForm m_form;
    float m_pixel;
    float m_hue;
    float m_scale;
};

/// A twig full of needles, drawn needle by needle.
class NeedleSpray {
public:
    NeedleSpray(int size, double hue)
        : m_size(size),
          m_hue(static_cast<float>(hue)),
          m_points(static_cast<std::size_t>(size) * static_cast<std::size_t>(size))
    {
        for (LeafPoint& point : m_points)
            point.colour = fromHsv(m_hue, 0.55F, 0.4F);
        Random random(0, 0, 0, Purpose::Texture);
        const auto between = [&random](double from, double to) {
            return static_cast<float>(random.uniform(from, to));
        };
        // From below to above, so that the younger needles lie on the older ones.
        draw({0.5F, 0.0F}, {0.5F, 0.45F}, {0.505F, 0.8F}, 0.011F, 0.006F, {0.35F, 0.27F, 0.19F}, 0.2F);
        for (int i = 0; i < kNeedles; ++i) {
            const float share = static_cast<float>(i) / static_cast<float>(kNeedles - 1);
            const float side = i % 2 == 0 ? 1.0F : -1.0F;
            const Vec2 root(0.5F + 0.005F * side, 0.02F + 0.78F * share + between(-0.012, 0.012));
            const bool front = between(0.0, 1.0) < 0.3F;
            // Needles in front look at the viewer and seem shorter; those at the tip stand together like a
            // brush.
            const float angle =
                side * (front ? between(0.05, 0.7) : between(0.65, 1.05)) * (1.0F - 0.55F * share * share);
            const float length =
                (front ? between(0.15, 0.26) : between(0.3, 0.4)) * (1.0F - 0.35F * share * share);
            const Vec2 direction(std::sin(angle), std::cos(angle));
            const Vec2 tip = root + length * direction + Vec2(0.0F, between(0.0, 0.05));
            const Vec2 middle = root + 0.5F * length * direction + Vec2(between(-0.015, 0.015), -0.02F);
            const float light = front ? 1.18F : 0.9F;
            const Colour colour =
                fromHsv(m_hue + between(-0.1, 0.1), between(0.5, 0.66), light * between(0.42, 0.56));
            draw(root, middle, tip.cwiseMax(Vec2(0.01F, 0.0F)).cwiseMin(Vec2(0.99F, 0.99F)), 0.0085F, 0.003F,
                 colour, front ? 0.7F : 0.35F);
        }
    }

    const LeafPoint& operator()(float u, float v) const
    {
        const auto column = static_cast<int>(u * static_cast<float>(m_size));
        const auto row = static_cast<int>(v * static_cast<float>(m_size));
        return m_points[static_cast<std::size_t>(row * m_size + column)];
    }

private:
    static constexpr int kNeedles = 150;
    static constexpr int kPieces = 6;

    /// A bent needle from @p a by @p b to @p c, of half-widths @p from and @p to; round, and @p level high.
    void draw(const Vec2& a, const Vec2& b, const Vec2& c, float from, float to, const Colour& colour,
              float level)
    {
        const float size = static_cast<float>(m_size);
        Vec2 lower = a;
        for (int piece = 1; piece <= kPieces; ++piece) {
            const float t = static_cast<float>(piece) / kPieces;
            const Vec2 upper = (1.0F - t) * (1.0F - t) * a + 2.0F * t * (1.0F - t) * b + t * t * c;
            const Vec2 span = upper - lower;
            const float first = static_cast<float>(piece - 1) / kPieces;
            const Vec2 least = (lower.cwiseMin(upper).array() - from - 1.5F / size) * size;
            const Vec2 most = (lower.cwiseMax(upper).array() + from + 1.5F / size) * size;
            const int left = std::max(0, static_cast<int>(least.x()));
            const int right = std::min(m_size - 1, static_cast<int>(most.x()));
            const int bottom = std::max(0, static_cast<int>(least.y()));
            const int top = std::min(m_size - 1, static_cast<int>(most.y()));
            for (int row = bottom; row <= top; ++row) {
                for (int column = left; column <= right; ++column) {
                    const Vec2 place((static_cast<float>(column) + 0.5F) / size,
                                     (static_cast<float>(row) + 0.5F) / size);
                    const float projection = (place - lower).dot(span) / span.squaredNorm();
                    if ((projection < 0.0F && piece > 1) || (projection > 1.0F && piece < kPieces))
                        continue; // the next piece's
                    const float share = clamped(projection);
                    const float along = first + share / kPieces;
                    const float half = from + (to - from) * along * along;
                    const float distance = (place - lower - share * span).norm();
                    const float cover = clamped(0.5F + (half - distance) * size);
                    if (cover <= 0.0F)
                        continue;
                    const float profile = std::sqrt(clamped(1.0F - distance * distance / (half * half)));
                    LeafPoint& point = m_points[static_cast<std::size_t>(row * m_size + column)];
                    const float shade = (0.72F + 0.28F * profile) * (0.82F + 0.18F * along);
                    point.colour = mix(point.colour, colour * shade, cover);
                    point.alpha = std::max(point.alpha, cover);
                    point.height = point.height + cover * (level + 0.3F * profile - point.height);
                }
            }
            lower = upper;
        }
    }

    int m_size;
    float m_hue;
    std::vector<LeafPoint> m_points; ///< Rows from below
};

template <class Leaf>
QImage paintLeaf(int size, const Leaf& leaf)
{
    return paintPixels(size, QImage::Format_RGBA8888, [&](float u, float v, uchar*& out) {
        const LeafPoint point = leaf(u, v);
        writeColour(point.colour, out);
        *out++ = toByte(point.alpha);
    });
}

const BladeForm& formOf(LeafShape shape)
{
    switch (shape) {
    case LeafShape::Lanceolate:
        return kLanceolate;
    case LeafShape::Lobed:
        return kLobed;
    case LeafShape::Ovate:
    case LeafShape::Needles:
        break;
    }
    return kOvate;
}

} // namespace

QImage leafAlbedo(LeafShape shape, int size, double hue)
{
    if (shape == LeafShape::Needles)
        return paintLeaf(size, NeedleSpray(size, hue));
    return paintLeaf(size, BroadLeaf(formOf(shape), size, hue));
}

QImage leafNormal(LeafShape shape, int size)
{
    if (shape == LeafShape::Needles)
        return paintNormals(size, NeedleSpray(size, kLeafTextureHue), kNeedleRelief, false);
    return paintNormals(size, BroadLeaf(formOf(shape), size, kLeafTextureHue), kRelief, false);
}

} // namespace espalier
