// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/LassoLoop.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace espalier {

namespace {

using Point = Eigen::Vector2d;

/// The largest error of the simplified line of a scribble, as a share of its side.
constexpr double kLargestTolerance = 0.01;

double cross(const Point& a, const Point& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

std::vector<Vec2> withoutNonsense(const std::vector<Vec2>& points)
{
    std::vector<Vec2> kept;
    kept.reserve(points.size());
    for (const Vec2& point : points) {
        const bool sane = point.allFinite() && point.cwiseAbs().maxCoeff() <= kFarthestLassoPoint;
        if (sane && (kept.empty() || kept.back() != point))
            kept.push_back(point);
    }
    return kept;
}

/// The directions of lines from an anchor that pass all points since then within the tolerance.
class Sector {
public:
    /// Whether a line from the anchor to @p point passes all points so far within the tolerance; if so, adds
    /// the point.
    bool admit(const Point& anchor, const Point& point, double tolerance)
    {
        const Point offset = point - anchor;
        const double distance = offset.norm();
        if (distance < m_farthest - tolerance)
            return false; // the stroke turns back
        if (distance <= tolerance)
            return m_farthest == 0.0;
        if (m_farthest > 0.0 && (cross(m_right, offset) < 0.0 || cross(m_left, offset) > 0.0))
            return false;
        const double sine = tolerance / distance;
        const double cosine = std::sqrt(1.0 - sine * sine);
        const Point right(cosine * offset.x() + sine * offset.y(), cosine * offset.y() - sine * offset.x());
        const Point left(cosine * offset.x() - sine * offset.y(), cosine * offset.y() + sine * offset.x());
        if (m_farthest == 0.0 || cross(m_right, right) > 0.0)
            m_right = right;
        if (m_farthest == 0.0 || cross(m_left, left) < 0.0)
            m_left = left;
        m_farthest = std::max(m_farthest, distance);
        return true;
    }

private:
    double m_farthest = 0.0; ///< 0 as long as all points are within the tolerance of the anchor
    Point m_right = Point::Zero();
    Point m_left = Point::Zero();
};

/// The length of a line up to each of its points.
std::vector<double> lengthsAlong(const std::vector<Vec2>& points)
{
    std::vector<double> along(points.size(), 0.0);
    for (std::size_t i = 1; i < points.size(); ++i)
        along[i] = along[i - 1] + (points[i] - points[i - 1]).cast<double>().norm();
    return along;
}

std::vector<Vec2> simplifiedWithin(const std::vector<Vec2>& points, double tolerance)
{
    std::vector<Vec2> kept{points.front()};
    Sector sector;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (sector.admit(kept.back().cast<double>(), points[i].cast<double>(), tolerance))
            continue;
        kept.push_back(points[i - 1]);
        sector = {};
        sector.admit(kept.back().cast<double>(), points[i].cast<double>(), tolerance);
    }
    kept.push_back(points.back());
    return kept;
}

/// Points at equal distances along a line, including its ends.
std::vector<Vec2> evenlySpaced(const std::vector<Vec2>& points, std::size_t count)
{
    const std::vector<double> along = lengthsAlong(points);
    std::vector<Vec2> result{points.front()};
    std::size_t next = 1;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double length = along.back() * static_cast<double>(i) / static_cast<double>(count - 1);
        while (next + 1 < points.size() && along[next] < length)
            ++next;
        const double part = (length - along[next - 1]) / (along[next] - along[next - 1]);
        result.emplace_back(points[next - 1] + static_cast<float>(part) * (points[next] - points[next - 1]));
    }
    result.push_back(points.back());
    return result;
}

/// The places along a and along b (0...1) at which the segments a and b cross.
std::optional<std::pair<double, double>> crossing(const Point& a0, const Point& a1, const Point& b0,
                                                  const Point& b1)
{
    const Point a = a1 - a0;
    const Point b = b1 - b0;
    const double determinant = cross(a, b);
    if (determinant == 0.0)
        return {};
    const double alongA = cross(b0 - a0, b) / determinant;
    const double alongB = cross(b0 - a0, a) / determinant;
    if (!(alongA >= 0.0 && alongA <= 1.0 && alongB >= 0.0 && alongB <= 1.0))
        return {};
    return std::pair(alongA, alongB);
}

} // namespace

std::vector<Vec2> simplified(const std::vector<Vec2>& points, double tolerance)
{
    std::vector<Vec2> sane = withoutNonsense(points);
    if (sane.size() <= 2)
        return sane;
    Eigen::AlignedBox2d box;
    for (const Vec2& point : sane)
        box.extend(point.cast<double>());
    const double side = box.sizes().maxCoeff();
    std::vector<Vec2> kept = simplifiedWithin(sane, std::max(tolerance, 0.0) * side);
    for (double share = std::max(tolerance, 1e-6);
         kept.size() > kMostLassoPoints && share < kLargestTolerance;) {
        share = std::min(2.0 * share, kLargestTolerance);
        kept = simplifiedWithin(sane, share * side);
    }
    return kept.size() <= kMostLassoPoints ? kept : evenlySpaced(kept, kMostLassoPoints);
}

std::vector<Vec2> closedLoop(const std::vector<Vec2>& points, double longestTails)
{
    if (points.size() < 4)
        return points;
    const std::vector<double> along = lengthsAlong(points);

    // The pair of segments, one in each tail, that cross with the least to cut off.
    const double length = along.back();
    double least = longestTails * length;
    std::optional<std::pair<std::size_t, std::size_t>> cut;
    Point where = Point::Zero();
    for (std::size_t i = 0; i + 1 < points.size() && along[i] < least; ++i) {
        for (std::size_t j = points.size() - 2; j > i + 1 && along[i] + length - along[j + 1] < least; --j) {
            const Point first = points[i].cast<double>();
            const Point second = points[i + 1].cast<double>();
            const auto found =
                crossing(first, second, points[j].cast<double>(), points[j + 1].cast<double>());
            if (!found)
                continue;
            const double tails = std::lerp(along[i], along[i + 1], found->first) + length -
                                 std::lerp(along[j], along[j + 1], found->second);
            if (tails < least) {
                least = tails;
                cut = std::pair(i, j);
                where = first + found->first * (second - first);
            }
        }
    }
    if (!cut)
        return points;
    std::vector<Vec2> loop{where.cast<float>()};
    loop.insert(loop.end(), points.begin() + static_cast<std::ptrdiff_t>(cut->first) + 1,
                points.begin() + static_cast<std::ptrdiff_t>(cut->second) + 1);
    return loop;
}

bool coplanar(const LassoStroke& first, const LassoStroke& second)
{
    const Vec3 normal = first.right.cross(first.up);
    if (!(normal.dot(second.right.cross(second.up)) > 1.0F - 1e-6F))
        return false;
    const Vec3 apart = second.origin - first.origin;
    const float scale = std::max({1.0F, first.origin.norm(), second.origin.norm()});
    return std::abs(normal.dot(apart)) <= 1e-5F * scale;
}

LassoStroke turnedToTheSide(LassoStroke stroke)
{
    const auto turned = [](const Vec3& v) { return Vec3(v.z(), v.y(), -v.x()); };
    stroke.right = turned(stroke.right);
    stroke.up = turned(stroke.up);
    return stroke;
}

} // namespace espalier
