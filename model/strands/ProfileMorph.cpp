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

ProfileBlend::ProfileBlend(StrandProfile from, StrandProfile to, By by)
    : m_from(std::move(from)), m_to(std::move(to))
{
    if (m_from == m_to)
        return;
    const std::vector<StrandProfile::Loop> parts = outlines(m_from, false);
    const std::vector<StrandProfile::Loop> cavities = outlines(m_from, true);
    std::vector<StrandProfile::Loop> partsTo = outlines(m_to, false);
    std::vector<StrandProfile::Loop> cavitiesTo = outlines(m_to, true);
    if (by == By::Outlines && parts.size() == partsTo.size() && cavities.size() == cavitiesTo.size()) {
        m_pairs = matched(parts, std::move(partsTo));
        for (Pair& pair : matched(cavities, std::move(cavitiesTo)))
            m_pairs.push_back(std::move(pair));
    } else {
        m_distances = distances();
    }
}

std::vector<ProfileBlend::Pair> ProfileBlend::matched(const std::vector<StrandProfile::Loop>& from,
                                                      std::vector<StrandProfile::Loop> to)
{
    std::vector<Pair> pairs;
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
        std::ranges::rotate(*nearest, nearest->begin() + static_cast<std::ptrdiff_t>(best));
        pairs.push_back({loop, std::move(*nearest)});
        to.erase(nearest);
    }
    return pairs;
}

ProfileBlend::Distances ProfileBlend::distances() const
{
    const StrandProfile from = coarse(m_from);
    const StrandProfile to = coarse(m_to);
    Eigen::AlignedBox2f box;
    for (const StrandProfile* profile : {&from, &to}) {
        for (const StrandProfile::Loop& loop : profile->boundaries) {
            for (const Vec2& point : loop)
                box.extend(point);
        }
    }
    Distances result;
    result.spacing = box.sizes().maxCoeff() / static_cast<float>(kMorphGrid);
    result.corner = box.min() - Vec2::Constant(2.0F * result.spacing);
    const auto nodes = [&](int axis) {
        return static_cast<int>(std::ceil(box.sizes()[axis] / result.spacing)) + 5;
    };
    result.from = Grid<float>(nodes(0), nodes(1));
    result.to = Grid<float>(nodes(0), nodes(1));
    for (int y = 0; y < result.from.height(); ++y) {
        for (int x = 0; x < result.from.width(); ++x) {
            const Vec2 place =
                result.corner + result.spacing * Vec2(static_cast<float>(x), static_cast<float>(y));
            result.from(x, y) = signedDistance(from, place);
            result.to(x, y) = signedDistance(to, place);
        }
    }
    return result;
}

StrandProfile ProfileBlend::blended(const Distances& distances, float share)
{
    Grid<float> values(distances.from.width(), distances.from.height());
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x)
            values(x, y) = (1.0F - share) * distances.from(x, y) + share * distances.to(x, y);
    }
    StrandProfile result;
    for (const auto& line : Contours(values, 0.0F).loops()) {
        StrandProfile::Loop loop;
        for (const Eigen::Vector2d& node : line)
            loop.push_back(distances.corner + distances.spacing * node.cast<float>());
        if (loop.size() >= 8)
            result.boundaries.push_back(resampled(loop, std::min(loop.size() / 2, kMorphPoints)));
    }
    return result;
}

StrandProfile ProfileBlend::at(float share) const
{
    if (share <= 0.0F || m_from == m_to)
        return m_from;
    if (share >= 1.0F)
        return m_to;
    StrandProfile result;
    blendAttractors(m_from, m_to, share, result);
    if (!m_distances) {
        for (const Pair& pair : m_pairs) {
            StrandProfile::Loop& loop = result.boundaries.emplace_back();
            for (std::size_t i = 0; i < kMorphPoints; ++i)
                loop.push_back((1.0F - share) * pair.from[i] + share * pair.to[i]);
        }
        if (profileFault(result).isEmpty())
            return result;
    }
    result.boundaries = blended(m_distances ? *m_distances : distances(), share).boundaries;
    return profileFault(result).isEmpty() ? result : share < 0.5F ? m_from : m_to;
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
