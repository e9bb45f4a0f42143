// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LoopThinning.h"

#include <algorithm>
#include <numeric>

namespace espalier {

namespace {

constexpr std::size_t kFewestPoints = 5;

float distanceToSegment(const Vec2& point, const Vec2& from, const Vec2& to)
{
    const Vec2 along = to - from;
    const float length = along.squaredNorm();
    const float t = length > 0.0F ? std::clamp((point - from).dot(along) / length, 0.0F, 1.0F) : 0.0F;
    return (point - (from + t * along)).norm();
}

} // namespace

std::vector<std::uint32_t> thinLoop(std::span<const Vec2> points, float tolerance)
{
    const auto count = static_cast<std::uint32_t>(points.size());
    std::vector<std::uint32_t> kept(count);
    std::iota(kept.begin(), kept.end(), 0U);
    if (tolerance <= 0.0F || count <= kFewestPoints)
        return kept;
    // Ends that are kept in any case, evenly around the loop.
    std::vector<bool> isKept(count, false);
    for (std::size_t i = 0; i < kFewestPoints; ++i)
        isKept[i * count / kFewestPoints] = true;
    struct Part {
        std::uint32_t from;
        std::uint32_t to; ///< May be count, which is the first point again
    };
    std::vector<Part> parts;
    for (std::size_t i = 0; i < kFewestPoints; ++i)
        parts.push_back({static_cast<std::uint32_t>(i * count / kFewestPoints),
                         static_cast<std::uint32_t>((i + 1) * count / kFewestPoints)});
    while (!parts.empty()) {
        const Part part = parts.back();
        parts.pop_back();
        float most = tolerance;
        std::uint32_t farthest = part.to;
        for (std::uint32_t i = part.from + 1; i < part.to; ++i) {
            const float distance = distanceToSegment(points[i], points[part.from], points[part.to % count]);
            if (distance > most) {
                most = distance;
                farthest = i;
            }
        }
        if (farthest == part.to)
            continue;
        isKept[farthest] = true;
        parts.push_back({part.from, farthest});
        parts.push_back({farthest, part.to});
    }
    std::erase_if(kept, [&](std::uint32_t i) { return !isKept[i]; });
    return kept;
}

} // namespace espalier
