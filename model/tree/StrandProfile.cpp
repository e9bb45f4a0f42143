// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/StrandProfile.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

struct ProfileText {
    Q_DECLARE_TR_FUNCTIONS(StrandProfile)
};

bool isNear(const Vec2& point)
{
    return point.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= kFarthestProfilePoint;
}

double cross(const Vec2& a, const Vec2& b, const Vec2& c)
{
    const Eigen::Vector2d u = (b - a).cast<double>();
    const Eigen::Vector2d v = (c - a).cast<double>();
    return u.x() * v.y() - u.y() * v.x();
}

/// Whether two segments have a point in common.
bool meet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    for (int axis = 0; axis < 2; ++axis) {
        if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
            std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
            return false;
    }
    const auto oneSide = [](double p, double q) { return (p > 0 && q > 0) || (p < 0 && q < 0); };
    return !oneSide(cross(a, b, c), cross(a, b, d)) && !oneSide(cross(c, d, a), cross(c, d, b));
}

struct Edge {
    Vec2 from;
    Vec2 to;
    std::size_t loop;
    std::size_t place; ///< In its loop
};

bool areNeighbours(const Edge& a, const Edge& b, const StrandProfile& profile)
{
    if (a.loop != b.loop)
        return false;
    const std::size_t count = profile.boundaries[a.loop].size();
    return (a.place + 1) % count == b.place || (b.place + 1) % count == a.place;
}

/// The first two edges that cross, as the loops that they belong to.
bool crosses(const StrandProfile& profile, bool& itself)
{
    std::vector<Edge> edges;
    for (std::size_t loop = 0; loop < profile.boundaries.size(); ++loop) {
        const StrandProfile::Loop& points = profile.boundaries[loop];
        for (std::size_t i = 0; i < points.size(); ++i)
            edges.push_back({points[i], points[(i + 1) % points.size()], loop, i});
    }
    // By their left ends, so that only edges whose ranges overlap are compared.
    const auto left = [](const Edge& edge) { return std::min(edge.from.x(), edge.to.x()); };
    std::ranges::sort(edges, {}, left);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const float right = std::max(edges[i].from.x(), edges[i].to.x());
        for (std::size_t j = i + 1; j < edges.size() && left(edges[j]) <= right; ++j) {
            if (!areNeighbours(edges[i], edges[j], profile) &&
                meet(edges[i].from, edges[i].to, edges[j].from, edges[j].to)) {
                itself = edges[i].loop == edges[j].loop;
                return true;
            }
        }
    }
    return false;
}

bool contains(const StrandProfile::Loop& loop, const Vec2& point)
{
    bool inside = false;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++) {
        const Vec2& a = loop[i];
        const Vec2& b = loop[j];
        if ((a.y() > point.y()) != (b.y() > point.y()) &&
            point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
            inside = !inside;
    }
    return inside;
}

} // namespace

std::size_t StrandProfile::bytes() const
{
    std::size_t sum = attractors.capacity() * sizeof(Attractor) + boundaries.capacity() * sizeof(Loop);
    for (const Loop& loop : boundaries)
        sum += loop.capacity() * sizeof(Vec2);
    return sum;
}

bool isInside(const StrandProfile& profile, const Vec2& point)
{
    bool inside = false;
    for (const StrandProfile::Loop& loop : profile.boundaries)
        inside = inside != contains(loop, point);
    return inside;
}

float signedAreaOf(const StrandProfile::Loop& loop)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
        twice += cross(Vec2::Zero(), loop[i], loop[(i + 1) % loop.size()]);
    return static_cast<float>(twice / 2.0);
}

float areaOf(const StrandProfile& profile)
{
    // Loops do not cross, so each counts by the number of loops around it.
    float area = 0.0F;
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        bool isCavity = false;
        for (const StrandProfile::Loop& other : profile.boundaries) {
            if (&other != &loop)
                isCavity = isCavity != contains(other, loop.front());
        }
        area += (isCavity ? -1.0F : 1.0F) * std::abs(signedAreaOf(loop));
    }
    return area;
}

QString profileFault(const StrandProfile& profile)
{
    std::size_t points = 0;
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        points += loop.size();
        if (loop.size() < 3)
            return ProfileText::tr("an outline needs at least three points");
        if (!std::ranges::all_of(loop, isNear))
            return ProfileText::tr("an outline reaches too far");
    }
    if (profile.boundaries.empty())
        return ProfileText::tr("it has no outline");
    if (profile.boundaries.size() > kMostProfileLoops || points > kMostProfilePoints)
        return ProfileText::tr("it has more than %1 outlines or %2 points")
            .arg(kMostProfileLoops)
            .arg(kMostProfilePoints);
    if (profile.attractors.size() > kMostAttractors)
        return ProfileText::tr("it has more than %1 attractors").arg(kMostAttractors);
    for (const StrandProfile::Attractor& attractor : profile.attractors) {
        if (!isNear(attractor.from) || !isNear(attractor.to))
            return ProfileText::tr("an attractor lies too far away");
    }
    if (bool itself = false; crosses(profile, itself))
        return itself ? ProfileText::tr("its outline crosses itself")
                      : ProfileText::tr("its outlines cross each other");
    if (!(areaOf(profile) >= kLeastProfileArea))
        return ProfileText::tr("its outline has no area");
    return {};
}

} // namespace espalier
