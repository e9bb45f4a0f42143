// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandDynamics.h"

#include "model/strands/DiscGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace espalier {

namespace {

constexpr float kTimeStep = 0.002F;
constexpr float kPull = 40'000.0F;
constexpr float kDamping = 0.02F;
constexpr float kGreatestSpeed = 60.0F;
constexpr float kSoftness = 0.1F;
constexpr std::size_t kStepsPerDisc = 5;

Vec2 nearestOn(const Vec2& point, const Vec2& from, const Vec2& to)
{
    const Vec2 edge = to - from;
    const float length = edge.squaredNorm();
    const float t = length > 0.0F ? std::clamp((point - from).dot(edge) / length, 0.0F, 1.0F) : 0.0F;
    return from + t * edge;
}

/// What a disc at @p place is pulled toward.
Vec2 goalOf(const Vec2& place, const StrandProfile* profile, float scale)
{
    if (profile == nullptr)
        return Vec2::Zero();
    const Vec2 point = place / scale;
    Vec2 goal = Vec2::Zero();
    float best = std::numeric_limits<float>::max();
    const auto consider = [&](const Vec2& from, const Vec2& to) {
        const Vec2 nearest = nearestOn(point, from, to);
        if (const float distance = (nearest - point).squaredNorm(); distance < best) {
            best = distance;
            goal = nearest;
        }
    };
    if (isInside(*profile, point)) {
        if (profile->attractors.empty())
            return place;
        for (const auto& [from, to] : profile->attractors)
            consider(from, to);
    } else {
        for (const StrandProfile::Loop& loop : profile->boundaries) {
            for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
                consider(loop[j], loop[i]);
        }
    }
    return scale * goal;
}

} // namespace

void packByDynamics(std::span<Vec2> places, int steps, const StrandProfile* profile, float scale)
{
    const std::size_t count = places.size();
    std::vector<Vec2> before(places.begin(), places.end());
    std::vector<Vec2> push(count);
    DiscGrid grid;
    const std::size_t most = std::min(static_cast<std::size_t>(steps), kStepsPerDisc * count);
    for (std::size_t step = 0; step < most; ++step) {
        grid.sort(places);
        std::ranges::fill(push, Vec2(Vec2::Zero()));
        grid.forEachPair(places, 2.0F, [&](std::uint32_t a, std::uint32_t b) {
            const Vec2 between = places[b] - places[a];
            const float distance = between.norm();
            // Discs at the same place part along a direction that their numbers decide.
            const float angle = 2.399963F * static_cast<float>(a % 4096);
            const Vec2 direction =
                distance > 1e-6F ? Vec2(between / distance) : Vec2(std::cos(angle), std::sin(angle));
            const Vec2 move = (1.0F - kSoftness) * 0.5F * (2.0F - distance) * direction;
            push[a] -= move;
            push[b] += move;
        });
        for (std::size_t i = 0; i < count; ++i) {
            const Vec2 place = places[i] + push[i];
            const Vec2 toGoal = goalOf(place, profile, scale) - place;
            const float far = toGoal.norm();
            Vec2 move = (1.0F - kDamping) * (place - before[i]);
            if (far > 1e-6F)
                move += kTimeStep * kTimeStep * kPull * toGoal / far;
            if (const float length = move.norm(); length > kTimeStep * kGreatestSpeed)
                move *= kTimeStep * kGreatestSpeed / length;
            before[i] = place;
            places[i] = place + move;
        }
    }
}

} // namespace espalier
