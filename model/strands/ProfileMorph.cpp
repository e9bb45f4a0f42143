// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/ProfileMorph.h"

#include "model/envelope/Contours.h"
#include "model/envelope/LassoLoop.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

/// Points of an outline that is blended.
constexpr std::size_t kMorphPoints = 64;
/// Nodes of the grid of distances along its longer side.
constexpr int kMorphGrid = 112;
/// A hand-drawn line is smoothed at so many points, in so many rounds.
constexpr std::size_t kSketchPoints = 96;
constexpr int kSketchRounds = 12;
/// Of the size of an outline: what simplifying it may move.
constexpr double kSketchTolerance = 1.0 / 256.0;

/// @p count points at equal distances along a closed line.
StrandProfile::Loop resampled(const StrandProfile::Loop& loop, std::size_t count)
{
    double whole = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        whole += double{(loop[(i + 1) % loop.size()] - loop[i]).norm()};
    StrandProfile::Loop points;
    const double step = whole / static_cast<double>(count);
    double passed = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec2 edge = loop[(i + 1) % loop.size()] - loop[i];
        const auto length = double{edge.norm()};
        while (points.size() < count && static_cast<double>(points.size()) * step < passed + length) {
            const double along = (static_cast<double>(points.size()) * step - passed) / length;
            points.push_back(loop[i] + static_cast<float>(along) * edge);
        }
        passed += length;
    }
    while (points.size() < count)
        points.push_back(loop.back());
    return points;
}

Vec2 middleOf(const StrandProfile::Loop& loop)
{
    Vec2 sum = Vec2::Zero();
    for (const Vec2& point : loop)
        sum += point / static_cast<float>(loop.size());
    return sum;
}

/// The outlines around parts, or those around cavities, resampled and counter-clockwise.
std::vector<StrandProfile::Loop> outlines(const StrandProfile& profile, bool ofCavities)
{
    std::vector<StrandProfile::Loop> found;
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        bool isCavity = false;
        for (const StrandProfile::Loop& other : profile.boundaries)
            isCavity = isCavity != (&other != &loop && isInside({{other}, {}}, loop.front()));
        if (isCavity != ofCavities)
            continue;
        found.push_back(resampled(loop, kMorphPoints));
        if (signedAreaOf(found.back()) < 0.0F)
            std::ranges::reverse(found.back());
    }
    return found;
}

/// Adds each outline of @p from, blended with the nearest one of @p to that is left.
void blendOutlines(const std::vector<StrandProfile::Loop>& from, std::vector<StrandProfile::Loop> to,
                   float share, StrandProfile& result)
{
    for (const StrandProfile::Loop& loop : from) {
        const Vec2 middle = middleOf(loop);
        const auto nearest = std::ranges::min_element(to, {}, [&](const StrandProfile::Loop& other) {
            return (middleOf(other) - middle).squaredNorm();
        });
        const Vec2 shift = middleOf(*nearest) - middle;
        // The place on the other outline that the first point goes to.
        std::size_t best = 0;
        float least = std::numeric_limits<float>::max();
        for (std::size_t offset = 0; offset < kMorphPoints; ++offset) {
            float sum = 0.0F;
            for (std::size_t i = 0; i < kMorphPoints; ++i)
                sum += ((*nearest)[(i + offset) % kMorphPoints] - loop[i] - shift).squaredNorm();
            if (sum < least) {
                least = sum;
                best = offset;
            }
        }
        StrandProfile::Loop& blended = result.boundaries.emplace_back();
        for (std::size_t i = 0; i < kMorphPoints; ++i)
            blended.push_back((1.0F - share) * loop[i] + share * (*nearest)[(i + best) % kMorphPoints]);
        to.erase(nearest);
    }
}

/// The distance of @p point from the boundary, positive inside.
float signedDistance(const StrandProfile& profile, const Vec2& point)
{
    float nearest = std::numeric_limits<float>::max();
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
            const Vec2 edge = loop[i] - loop[j];
            const float length = edge.squaredNorm();
            const float t =
                length > 0.0F ? std::clamp((point - loop[j]).dot(edge) / length, 0.0F, 1.0F) : 0.0F;
            nearest = std::min(nearest, (point - loop[j] - t * edge).squaredNorm());
        }
    }
    return std::sqrt(nearest) * (isInside(profile, point) ? 1.0F : -1.0F);
}

StrandProfile coarse(StrandProfile profile)
{
    for (StrandProfile::Loop& loop : profile.boundaries)
        loop = resampled(loop, std::min(loop.size(), kMorphPoints));
    return profile;
}

StrandProfile blendDistances(const StrandProfile& from, const StrandProfile& to, float share)
{
    const StrandProfile a = coarse(from);
    const StrandProfile b = coarse(to);
    Eigen::AlignedBox2f box;
    for (const StrandProfile* profile : {&a, &b}) {
        for (const StrandProfile::Loop& loop : profile->boundaries) {
            for (const Vec2& point : loop)
                box.extend(point);
        }
    }
    const float spacing = box.sizes().maxCoeff() / static_cast<float>(kMorphGrid);
    const Vec2 corner = box.min() - Vec2::Constant(2.0F * spacing);
    const auto nodes = [&](int axis) { return static_cast<int>(std::ceil(box.sizes()[axis] / spacing)) + 5; };
    Grid<float> values(nodes(0), nodes(1));
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            const Vec2 place = corner + spacing * Vec2(static_cast<float>(x), static_cast<float>(y));
            values(x, y) = (1.0F - share) * signedDistance(a, place) + share * signedDistance(b, place);
        }
    }
    StrandProfile result;
    for (const auto& line : Contours(values, 0.0F).loops()) {
        StrandProfile::Loop loop;
        for (const Eigen::Vector2d& node : line)
            loop.push_back(corner + spacing * node.cast<float>());
        if (loop.size() >= 8)
            result.boundaries.push_back(resampled(loop, std::min(loop.size() / 2, kMorphPoints)));
    }
    return result;
}

void blendAttractors(const StrandProfile& from, const StrandProfile& to, float share, StrandProfile& result)
{
    const std::size_t both = std::min(from.attractors.size(), to.attractors.size());
    for (std::size_t i = 0; i < both; ++i) {
        const StrandProfile::Attractor& a = from.attractors[i];
        const StrandProfile::Attractor& b = to.attractors[i];
        result.attractors.push_back(
            {(1.0F - share) * a.from + share * b.from, (1.0F - share) * a.to + share * b.to});
    }
    const StrandProfile& nearer = share < 0.5F ? from : to;
    for (std::size_t i = both; i < nearer.attractors.size(); ++i)
        result.attractors.push_back(nearer.attractors[i]);
}

} // namespace

StrandProfile blendedProfile(const StrandProfile& from, const StrandProfile& to, float share)
{
    if (share <= 0.0F || from == to)
        return from;
    if (share >= 1.0F)
        return to;
    StrandProfile result;
    blendAttractors(from, to, share, result);
    const std::vector<StrandProfile::Loop> parts = outlines(from, false);
    const std::vector<StrandProfile::Loop> cavities = outlines(from, true);
    std::vector<StrandProfile::Loop> partsTo = outlines(to, false);
    std::vector<StrandProfile::Loop> cavitiesTo = outlines(to, true);
    if (parts.size() == partsTo.size() && cavities.size() == cavitiesTo.size()) {
        blendOutlines(parts, std::move(partsTo), share, result);
        blendOutlines(cavities, std::move(cavitiesTo), share, result);
        if (profileFault(result).isEmpty())
            return result;
    }
    result.boundaries = blendDistances(from, to, share).boundaries;
    return profileFault(result).isEmpty() ? result : share < 0.5F ? from : to;
}

StrandProfile::Loop sketchedLoop(std::span<const Vec2> stroke, float least)
{
    Eigen::AlignedBox2f box;
    for (const Vec2& point : stroke) {
        if (!point.allFinite())
            return {};
        box.extend(point);
    }
    if (stroke.size() < 3 || box.sizes().maxCoeff() < least)
        return {};
    const StrandProfile::Loop closed = closedLoop(simplified({stroke.begin(), stroke.end()}));
    if (closed.size() < 3)
        return {};
    StrandProfile::Loop loop = resampled(closed, kSketchPoints);
    StrandProfile::Loop before;
    // A round outward follows each round inward, so that the outline does not shrink (Taubin).
    for (int round = 0; round < 2 * kSketchRounds; ++round) {
        before = loop;
        const float weight = round % 2 == 0 ? 0.5F : -0.51F;
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Vec2& last = before[(i + loop.size() - 1) % loop.size()];
            const Vec2& next = before[(i + 1) % loop.size()];
            loop[i] = before[i] + weight * ((last + next) / 2.0F - before[i]);
        }
    }
    // The two halves keep their ends, which are far from each other.
    const auto half = loop.begin() + static_cast<std::ptrdiff_t>(loop.size() / 2);
    std::vector<Vec2> first = simplified(std::vector<Vec2>(loop.begin(), half + 1), kSketchTolerance);
    std::vector<Vec2> second(half, loop.end());
    second.push_back(loop.front());
    second = simplified(second, kSketchTolerance);
    first.pop_back();
    second.pop_back();
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

} // namespace espalier
