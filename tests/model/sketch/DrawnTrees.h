// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Random.h"
#include "model/sketch/StrokeFit.h"

#include <cmath>
#include <vector>

namespace espalier::test {

inline SketchStroke openStroke(SketchLine line)
{
    return {.kind = SketchStroke::Kind::Open, .line = std::move(line)};
}

/// A line of @p count points from @p from in the direction @p angle (rad, 0 = right, up = π/2) that turns by
/// @p bend rad in all.
inline SketchLine bentLine(const Eigen::Vector2d& from, double angle, double length, double bend, int count)
{
    SketchLine line{from};
    for (int i = 1; i < count; ++i) {
        const double here = angle + bend * (i - 0.5) / (count - 1);
        line.emplace_back(line.back() +
                          length / (count - 1) * Eigen::Vector2d(std::cos(here), std::sin(here)));
    }
    return line;
}

/// A tree as a person draws it, in metres: a trunk of 5 m, then @p count - 1 strokes, of which every fourth
/// starts at the trunk and the others at limbs, with ends that miss their parent by some centimetres.
inline std::vector<SketchStroke> drawnTree(std::uint64_t seed, int count)
{
    Random random(seed, 0, 0, Purpose::Texture);
    struct Drawn {
        SketchLine line;
        double length = 0.0;
        double angle = 0.0;
    };
    const double up = 0.5 * std::numbers::pi;
    std::vector<Drawn> drawn;
    drawn.push_back({.line = bentLine({0.0, 0.0}, up - 0.15, 5.0, 0.3, 40), .length = 5.0, .angle = up});
    for (int i = 1; i < count; ++i) {
        const bool isLimb = i % 4 == 1;
        const auto others = static_cast<double>(drawn.size());
        const Drawn& parent = drawn[isLimb ? 0 : static_cast<std::size_t>(random.uniform() * others)];
        const double along = isLimb ? random.uniform(0.3, 0.95) : random.uniform(0.3, 0.9);
        const double side = random.uniform() < 0.5 ? -1.0 : 1.0;
        const double angle = parent.angle + side * random.uniform(0.5, 1.1);
        const double length = parent.length * random.uniform(0.3, 0.5) * (1.2 - 0.6 * along);
        Eigen::Vector2d from = pointAlong(parent.line, along);
        from += 0.03 * Eigen::Vector2d(random.normal(), random.normal());
        drawn.push_back({.line = bentLine(from, angle, length, -side * random.uniform(-0.2, 0.8), 24),
                         .length = length,
                         .angle = angle});
    }
    std::vector<SketchStroke> strokes;
    for (const Drawn& branch : drawn)
        strokes.push_back(openStroke(branch.line));
    return strokes;
}

} // namespace espalier::test
