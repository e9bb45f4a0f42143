// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/ProfileSlots.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace espalier {

namespace {

/// By how much the area of a profile with attractors exceeds the least one.
constexpr float kRoomForAttractors = 1.25F;
/// A profile in which strands find no room grows by these factors a trial, by more if more of them lack room.
constexpr float kLeastGrowth = 1.01F;
constexpr float kGreatestGrowth = 1.5F;

/// The points of a hexagonal lattice with distance 2 inside the profile times @p scale, row by row.
std::vector<Vec2> latticeIn(const StrandProfile& profile, float scale)
{
    const auto rise = static_cast<float>(std::numbers::sqrt3);
    struct Crossing {
        std::int32_t row;
        float x;
        auto operator<=>(const Crossing&) const = default;
    };
    std::vector<Crossing> crossings;
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 a = scale * loop[i];
            const Vec2 b = scale * loop[j];
            const auto firstRow = static_cast<std::int32_t>(std::floor(std::min(a.y(), b.y()) / rise));
            const auto lastRow = static_cast<std::int32_t>(std::ceil(std::max(a.y(), b.y()) / rise));
            for (std::int32_t row = firstRow; row <= lastRow; ++row) {
                const float y = rise * static_cast<float>(row);
                if ((a.y() > y) != (b.y() > y))
                    crossings.push_back({row, a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y())});
            }
        }
    }
    std::ranges::sort(crossings);
    std::vector<Vec2> inside;
    // A row has an even number of crossings.
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
        const auto& [row, from] = crossings[i];
        const float shift = row % 2 == 0 ? 0.0F : 1.0F;
        for (float x = 2.0F * std::ceil((from - shift) / 2.0F) + shift; x < crossings[i + 1].x; x += 2.0F)
            inside.emplace_back(x, rise * static_cast<float>(row));
    }
    return inside;
}

float distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to)
{
    const Vec2 edge = to - from;
    const float length = edge.squaredNorm();
    const float t = length > 0.0F ? std::clamp((point - from).dot(edge) / length, 0.0F, 1.0F) : 0.0F;
    return (point - from - t * edge).norm();
}

/// How much a place is to be avoided: its distance from the attractors, or its nearness to the boundary.
float reluctance(const StrandProfile& profile, float scale, const Vec2& place)
{
    const Vec2 point = place / scale;
    float nearest = std::numeric_limits<float>::max();
    if (!profile.attractors.empty()) {
        for (const auto& [from, to] : profile.attractors)
            nearest = std::min(nearest, distanceToSegment(point, from, to));
        return nearest;
    }
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
            nearest = std::min(nearest, distanceToSegment(point, loop[j], loop[i]));
    }
    return -nearest;
}

} // namespace

ProfileSlots profileSlots(const StrandProfile& profile, std::uint32_t strands)
{
    ProfileSlots result;
    const float area = areaOf(profile);
    const float room = profile.attractors.empty() ? 1.0F : kRoomForAttractors;
    const float each = 2.0F * static_cast<float>(std::numbers::sqrt3);
    result.scale = std::sqrt(room * each * static_cast<float>(strands) / area);
    for (;;) {
        result.places = latticeIn(profile, result.scale);
        if (result.places.size() >= strands)
            break;
        const float lacking = static_cast<float>(strands) / static_cast<float>(result.places.size() + 1);
        result.scale *= std::clamp(std::sqrt(lacking), kLeastGrowth, kGreatestGrowth);
    }
    if (result.places.size() > strands) {
        std::vector<std::pair<float, std::uint32_t>> order;
        for (std::uint32_t i = 0; i < result.places.size(); ++i)
            order.emplace_back(reluctance(profile, result.scale, result.places[i]), i);
        std::ranges::nth_element(order, order.begin() + strands);
        order.resize(strands);
        std::ranges::sort(order, {}, &std::pair<float, std::uint32_t>::second);
        std::vector<Vec2> kept;
        for (const auto& [_, place] : order)
            kept.push_back(result.places[place]);
        result.places = std::move(kept);
    }
    return result;
}

} // namespace espalier
