// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/MedialAxis.h"

#include "model/base/Random.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace espalier {

namespace {

using Point = Eigen::Vector2d;

constexpr std::size_t kSamples = 400;
constexpr std::size_t kLeastSamplesOfALoop = 12;
/// Two generating points of a Voronoi edge that are nearer along the boundary than this are on one side of
/// it.
constexpr std::size_t kOneSide = 4;
/// The least angle at which a place of the axis sees its two generating points, rad. A right-angled corner
/// has a branch, at which this angle is 90°.
constexpr double kLeastObjectAngle = 70.0 * std::numbers::pi / 180.0;

struct Sample {
    Point place;
    std::uint32_t loop;
    std::uint32_t number; ///< Along its loop
    std::uint32_t count;  ///< Samples of its loop
};

bool areOnOneSide(const Sample& a, const Sample& b)
{
    if (a.loop != b.loop)
        return false;
    const std::uint32_t steps = a.number > b.number ? a.number - b.number : b.number - a.number;
    return std::min(steps, a.count - steps) < std::min<std::size_t>(kOneSide, a.count / 3);
}

double lengthOf(const StrandProfile::Loop& loop)
{
    double length = 0.0;
    for (std::size_t i = 0, j = loop.size() - 1; i < loop.size(); j = i++)
        length += double{(loop[i] - loop[j]).norm()};
    return length;
}

/// Points at equal distances along the boundaries.
std::vector<Sample> samplesOf(const StrandProfile& profile)
{
    double whole = 0.0;
    for (const StrandProfile::Loop& loop : profile.boundaries)
        whole += lengthOf(loop);
    std::vector<Sample> samples;
    // Points in general position have one Delaunay triangulation. So each point is moved a little.
    auto jitter = [&, number = std::uint64_t{0}]() mutable {
        return 1e-7 * whole * (std::ldexp(static_cast<double>(mixedBits(++number)), -63) - 1.0);
    };
    for (std::uint32_t number = 0; number < profile.boundaries.size(); ++number) {
        const StrandProfile::Loop& loop = profile.boundaries[number];
        const double length = lengthOf(loop);
        const auto count =
            std::max(kLeastSamplesOfALoop, static_cast<std::size_t>(kSamples * length / whole));
        const double step = length / static_cast<double>(count);
        double next = step / 2.0; // Not the corners themselves
        double passed = 0.0;
        std::uint32_t made = 0;
        for (std::size_t i = 0; i < loop.size() && made < count; ++i) {
            const Point from = loop[i].cast<double>();
            const Point to = loop[(i + 1) % loop.size()].cast<double>();
            const double edge = (to - from).norm();
            for (; next <= passed + edge && edge > 0.0 && made < count; next += step) {
                const double x = jitter();
                const Point moved(x, jitter());
                samples.push_back({from + (next - passed) / edge * (to - from) + moved, number, made++,
                                   static_cast<std::uint32_t>(count)});
            }
            passed += edge;
        }
    }
    return samples;
}

struct Triangle {
    std::array<std::uint32_t, 3> corner;
    Point centre; ///< Of its circumscribed circle
    double squaredRadius;
};

/// Delaunay triangulation by Bowyer and Watson. The last three points are the corners of a triangle around
/// all the others.
class Delaunay {
public:
    explicit Delaunay(std::vector<Point> points) : m_points(std::move(points))
    {
        const auto first = static_cast<std::uint32_t>(m_points.size() - 3);
        add(first, first + 1, first + 2);
        for (std::uint32_t i = 0; i < first; ++i)
            insert(i);
    }

    const std::vector<Triangle>& triangles() const { return m_triangles; }

private:
    struct Edge {
        std::uint32_t from;
        std::uint32_t to;
        auto operator<=>(const Edge&) const = default;
    };

    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c)
    {
        const Point u = m_points[b] - m_points[a];
        const Point v = m_points[c] - m_points[a];
        const double cross = 2.0 * (u.x() * v.y() - u.y() * v.x());
        Triangle made{{a, b, c}, m_points[a], std::numeric_limits<double>::infinity()};
        if (cross != 0.0) {
            const Point toCentre((v.y() * u.squaredNorm() - u.y() * v.squaredNorm()) / cross,
                                 (u.x() * v.squaredNorm() - v.x() * u.squaredNorm()) / cross);
            made.centre += toCentre;
            made.squaredRadius = toCentre.squaredNorm();
        }
        m_triangles.push_back(made);
    }

    void insert(std::uint32_t point)
    {
        m_rim.clear();
        std::erase_if(m_triangles, [&](const Triangle& triangle) {
            if ((m_points[point] - triangle.centre).squaredNorm() >= triangle.squaredRadius)
                return false;
            for (std::size_t i = 0; i < 3; ++i) {
                const std::uint32_t a = triangle.corner[i];
                const std::uint32_t b = triangle.corner[(i + 1) % 3];
                m_rim.push_back({std::min(a, b), std::max(a, b)});
            }
            return true;
        });
        // The edges of one removed triangle alone surround the hole.
        std::ranges::sort(m_rim);
        for (std::size_t i = 0; i < m_rim.size(); ++i) {
            const bool isInner =
                (i > 0 && m_rim[i - 1] == m_rim[i]) || (i + 1 < m_rim.size() && m_rim[i + 1] == m_rim[i]);
            if (!isInner)
                add(m_rim[i].from, m_rim[i].to, point);
        }
    }

    std::vector<Point> m_points;
    std::vector<Triangle> m_triangles;
    std::vector<Edge> m_rim;
};

double angleAt(const Point& place, const Point& a, const Point& b)
{
    const Point u = a - place;
    const Point v = b - place;
    return std::abs(std::atan2(u.x() * v.y() - u.y() * v.x(), u.dot(v)));
}

} // namespace

std::vector<MedialSegment> medialAxis(const StrandProfile& profile)
{
    const std::vector<Sample> samples = samplesOf(profile);
    Eigen::AlignedBox2d box;
    std::vector<Point> points;
    for (const Sample& sample : samples) {
        points.push_back(sample.place);
        box.extend(sample.place);
    }
    const double far = 20.0 * box.sizes().norm();
    for (const Point& corner : {Point(-far, -far), Point(far, -far), Point(0.0, far)})
        points.emplace_back(box.center() + corner);
    const Delaunay delaunay(std::move(points));

    // The centres of two triangles with a common edge are the ends of a Voronoi edge.
    struct Side {
        std::uint32_t from;
        std::uint32_t to;
        std::uint32_t triangle;
        auto operator<=>(const Side&) const = default;
    };
    const std::vector<Triangle>& triangles = delaunay.triangles();
    std::vector<Side> sides;
    std::vector<std::int8_t> inside(triangles.size(), -1); // Not known yet
    const auto isIn = [&](std::uint32_t triangle) {
        if (inside[triangle] < 0)
            inside[triangle] = isInside(profile, triangles[triangle].centre.cast<float>()) ? 1 : 0;
        return inside[triangle] == 1;
    };
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            const std::uint32_t a = triangles[i].corner[j];
            const std::uint32_t b = triangles[i].corner[(j + 1) % 3];
            if (std::max(a, b) < samples.size())
                sides.push_back({std::min(a, b), std::max(a, b), i});
        }
    }
    std::ranges::sort(sides);
    std::vector<MedialSegment> axis;
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        const Side& side = sides[i];
        const Side& next = sides[i + 1];
        if (side.from != next.from || side.to != next.to ||
            areOnOneSide(samples[side.from], samples[side.to]))
            continue;
        const Point& a = triangles[side.triangle].centre;
        const Point& b = triangles[next.triangle].centre;
        const Point middle = (a + b) / 2.0;
        if (angleAt(middle, samples[side.from].place, samples[side.to].place) < kLeastObjectAngle ||
            !isIn(side.triangle) || !isIn(next.triangle) || !isInside(profile, middle.cast<float>()))
            continue;
        axis.push_back({a.cast<float>(), b.cast<float>()});
    }
    return axis;
}

} // namespace espalier
