// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/texture/NeedleSpray.h"

#include "model/base/Random.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kNeedles = 150;
constexpr int kFascicleNeedles = 64;
constexpr int kPieces = 6;

/// Uniform random numbers of a drawing.
class Chance {
public:
    explicit Chance(std::uint32_t drawing) : m_random(0, 0, drawing, Purpose::Texture) {}
    float operator()(double from, double to) { return static_cast<float>(m_random.uniform(from, to)); }

private:
    Random m_random;
};

} // namespace

NeedleSpray::NeedleSpray(Kind kind, int size, double hue)
    : m_size(size),
      m_hue(static_cast<float>(hue)),
      m_points(static_cast<std::size_t>(size) * static_cast<std::size_t>(size))
{
    for (LeafPoint& point : m_points)
        point.colour = fromHsv(m_hue, 0.55F, 0.4F);
    if (kind == Kind::Twig)
        drawTwig();
    else
        drawFascicle();
}

void NeedleSpray::drawTwig()
{
    Chance between(0);
    // Drawn from the bottom up, so that younger needles lie on older ones.
    draw({0.5F, 0.0F}, {0.5F, 0.45F}, {0.505F, 0.8F}, 0.011F, 0.006F, {0.35F, 0.27F, 0.19F}, 0.2F);
    for (int i = 0; i < kNeedles; ++i) {
        const float share = static_cast<float>(i) / static_cast<float>(kNeedles - 1);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        const Vec2 root(0.5F + 0.005F * side, 0.02F + 0.78F * share + between(-0.012, 0.012));
        const bool front = between(0.0, 1.0) < 0.3F;
        // Needles in front point to the viewer and seem shorter; needles at the tip stand together like a
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

void NeedleSpray::drawFascicle()
{
    Chance between(1);
    for (int i = 0; i < kFascicleNeedles; ++i) {
        // Outer needles are drawn first, so that the inner ones, which point to the viewer, lie on them.
        const float share = static_cast<float>(i) / static_cast<float>(kFascicleNeedles - 1);
        const float side = i % 2 == 0 ? 1.0F : -1.0F;
        const float angle = side * (1.0F - share) * 0.62F + between(-0.12, 0.12);
        const float length = (0.97F - 0.2F * (1.0F - share)) * between(0.72, 1.0);
        const Vec2 root(0.5F + 0.02F * side * (1.0F - share), between(0.0, 0.03));
        const Vec2 direction(std::sin(angle), std::cos(angle));
        const Vec2 tip = root + length * direction - Vec2(0.0F, 0.07F * std::abs(direction.x()));
        const Vec2 middle = root + 0.5F * length * direction + Vec2(0.0F, 0.04F * std::abs(direction.x()));
        const Colour colour = fromHsv(m_hue + between(-0.1, 0.1), between(0.48, 0.64),
                                      (0.85F + 0.3F * share) * between(0.42, 0.56));
        draw(root, middle, tip.cwiseMax(Vec2(0.01F, 0.0F)).cwiseMin(Vec2(0.99F, 0.98F)), 0.011F, 0.004F,
             colour, 0.2F + 0.6F * share);
    }
}

void NeedleSpray::draw(const Vec2& a, const Vec2& b, const Vec2& c, float from, float to,
                       const Colour& colour, float level)
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
                    continue; // belongs to the next piece
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
                point.roughness += cover * (0.15F * (1.0F - profile) - point.roughness);
            }
        }
        lower = upper;
    }
}

} // namespace espalier
