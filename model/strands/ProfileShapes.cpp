// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/ProfileShapes.h"

#include <cmath>
#include <numbers>

namespace espalier {

namespace {

constexpr int kRoundPoints = 40;
constexpr int kFlutes = 7;

/// A closed curve r(φ) around @p centre, x stretched by @p stretch.
template <class Radius>
StrandProfile::Loop curve(const Vec2& centre, float stretch, int points, Radius&& radius)
{
    StrandProfile::Loop loop;
    for (int i = 0; i < points; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / points;
        const auto r = static_cast<float>(radius(angle));
        loop.push_back(centre + r * Vec2(stretch * static_cast<float>(std::cos(angle)),
                                         static_cast<float>(std::sin(angle))));
    }
    return loop;
}

StrandProfile::Loop ellipse(const Vec2& centre, float width, float height, int points = kRoundPoints)
{
    return curve(centre, width / height, points, [height](double) { return height; });
}

/// A bent band of constant width with round ends; its gap faces +X.
StrandProfile::Loop openRing(double middle, double half, double gap)
{
    StrandProfile::Loop loop;
    const auto add = [&](double angle, double radius, const Vec2& offset) {
        loop.push_back(offset + static_cast<float>(radius) * Vec2(static_cast<float>(std::cos(angle)),
                                                                  static_cast<float>(std::sin(angle))));
    };
    constexpr int kArc = 26;
    constexpr int kEnd = 6;
    const double from = gap / 2.0;
    const double to = 2.0 * std::numbers::pi - from;
    const auto centreAt = [&](double angle) {
        return Vec2(static_cast<float>(middle * std::cos(angle)),
                    static_cast<float>(middle * std::sin(angle)));
    };
    for (int i = 0; i <= kArc; ++i)
        add(from + (to - from) * i / kArc, middle + half, Vec2::Zero());
    for (int i = 1; i < kEnd; ++i)
        add(to + std::numbers::pi * i / kEnd, half, centreAt(to));
    for (int i = kArc; i >= 0; --i)
        add(from + (to - from) * i / kArc, middle - half, Vec2::Zero());
    for (int i = 1; i < kEnd; ++i)
        add(from + std::numbers::pi + std::numbers::pi * i / kEnd, half, centreAt(from));
    return loop;
}

} // namespace

StrandProfile profileOf(ProfileShape shape)
{
    switch (shape) {
    case ProfileShape::Round:
        return {{ellipse(Vec2::Zero(), 1.0F, 1.0F)}, {}};
    case ProfileShape::Elongated:
        return {{ellipse(Vec2::Zero(), 1.6F, 0.62F)}, {}};
    case ProfileShape::CShape:
        return {{openRing(1.0, 0.3, 1.5)}, {}};
    case ProfileShape::Ring:
        return {{ellipse(Vec2::Zero(), 1.2F, 1.2F), ellipse(Vec2::Zero(), 0.66F, 0.66F)}, {}};
    case ProfileShape::TwoParts:
        return {{ellipse(Vec2(-0.85F, 0.0F), 0.7F, 0.72F), ellipse(Vec2(0.85F, 0.0F), 0.7F, 0.72F)}, {}};
    case ProfileShape::ThreeParts: {
        StrandProfile profile;
        for (int i = 0; i < 3; ++i) {
            const double angle = 2.0 * std::numbers::pi * (i + 0.75) / 3.0;
            profile.boundaries.push_back(ellipse(
                0.83F * Vec2(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))), 0.58F,
                0.58F, 28));
        }
        return profile;
    }
    case ProfileShape::Fluted:
        return {{curve(Vec2::Zero(), 1.0F, 10 * kFlutes,
                       [](double angle) { return 1.0 + 0.17 * std::cos(kFlutes * angle); })},
                {}};
    }
    return {};
}

} // namespace espalier
