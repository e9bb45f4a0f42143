// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/Delaunay.h"

#include "model/base/Random.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace espalier {

namespace {

using Point = Eigen::Vector2d;

constexpr std::uint32_t kNobody = std::numeric_limits<std::uint32_t>::max();
constexpr double kSamePlace = 1e-18; ///< Squared distance

double turn(const Point& a, const Point& b, const Point& c)
{
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether @p p lies in the circle through the counter-clockwise triangle a b c.
bool inCircle(const Point& a, const Point& b, const Point& c, const Point& p)
{
    const Point d = a - p;
    const Point e = b - p;
    const Point f = c - p;
    const double ap = d.squaredNorm();
    const double bp = e.squaredNorm();
    const double cp = f.squaredNorm();
    return d.x() * (e.y() * cp - bp * f.y()) - d.y() * (e.x() * cp - bp * f.x()) +
               ap * (e.x() * f.y() - e.y() * f.x()) >
           0.0;
}

/// The centre of the circle through three points, against the first.
Point circleCentre(const Point& a, const Point& b, const Point& c)
{
    const Point d = b - a;
    const Point e = c - a;
    const double scale = 0.5 / (d.x() * e.y() - d.y() * e.x());
    const double bl = d.squaredNorm();
    const double cl = e.squaredNorm();
    return {(e.y() * bl - d.y() * cl) * scale, (d.x() * cl - e.x() * bl) * scale};
}

/// Adds points by their distance from a first triangle to a hull that sweeps outward, and flips edges until
/// all circles are empty (Sinclair 2016, the s-hull).
class SweepHull {
public:
    explicit SweepHull(std::vector<Point> points) : m_points(std::move(points)) {}

    std::vector<std::array<std::uint32_t, 3>> triangulate()
    {
        if (m_points.size() < 3 || !chooseSeed())
            return {};
        start();
        Point last = Point::Constant(std::numeric_limits<double>::max());
        for (const std::uint32_t point : m_order) {
            if ((m_points[point] - last).squaredNorm() < kSamePlace)
                continue;
            last = m_points[point];
            if (point != m_seed[0] && point != m_seed[1] && point != m_seed[2])
                add(point);
        }
        std::vector<std::array<std::uint32_t, 3>> result(m_corners.size() / 3);
        for (std::size_t i = 0; i < result.size(); ++i)
            result[i] = {m_corners[3 * i], m_corners[3 * i + 1], m_corners[3 * i + 2]};
        return result;
    }

private:
    bool chooseSeed()
    {
        Point middle = Point::Zero();
        for (const Point& point : m_points)
            middle += point / static_cast<double>(m_points.size());
        const auto nearest = [&](auto&& measure) {
            std::uint32_t best = kNobody;
            double least = std::numeric_limits<double>::infinity();
            for (std::uint32_t i = 0; i < m_points.size(); ++i) {
                if (const double value = measure(i); value < least) {
                    least = value;
                    best = i;
                }
            }
            return best;
        };
        const double never = std::numeric_limits<double>::infinity();
        m_seed[0] = nearest([&](std::uint32_t i) { return (m_points[i] - middle).squaredNorm(); });
        const Point& a = m_points[m_seed[0]];
        m_seed[1] = nearest([&](std::uint32_t i) {
            const double distance = (m_points[i] - a).squaredNorm();
            return distance < kSamePlace ? never : distance;
        });
        if (m_seed[1] == kNobody)
            return false;
        const Point& b = m_points[m_seed[1]];
        m_seed[2] = nearest([&](std::uint32_t i) {
            const double radius = circleCentre(a, b, m_points[i]).squaredNorm();
            return std::isfinite(radius) && std::abs(turn(a, b, m_points[i])) > 1e-9 ? radius : never;
        });
        if (m_seed[2] == kNobody)
            return false;
        if (turn(a, b, m_points[m_seed[2]]) < 0.0)
            std::swap(m_seed[1], m_seed[2]);
        m_centre = a + circleCentre(a, m_points[m_seed[1]], m_points[m_seed[2]]);
        m_order.resize(m_points.size());
        std::iota(m_order.begin(), m_order.end(), 0U);
        std::vector<double> far(m_points.size());
        for (std::size_t i = 0; i < far.size(); ++i)
            far[i] = (m_points[i] - m_centre).squaredNorm();
        std::ranges::sort(m_order, [&](std::uint32_t p, std::uint32_t q) {
            return far[p] != far[q] ? far[p] < far[q] : p < q;
        });
        return true;
    }

    std::size_t hashOf(const Point& point) const
    {
        const Point d = point - m_centre;
        const double share = d.x() / (std::abs(d.x()) + std::abs(d.y()));
        const double angle = (d.y() > 0.0 ? 3.0 - share : 1.0 + share) / 4.0;
        return static_cast<std::size_t>(angle * static_cast<double>(m_hash.size())) % m_hash.size();
    }

    void start()
    {
        const std::size_t count = m_points.size();
        m_hullNext.assign(count, kNobody);
        m_hullBefore.assign(count, kNobody);
        m_hullEdge.assign(count, kNobody);
        m_hash.assign(static_cast<std::size_t>(std::ceil(std::sqrt(static_cast<double>(count)))), kNobody);
        const auto [a, b, c] = m_seed;
        m_hullNext[a] = m_hullBefore[c] = b;
        m_hullNext[b] = m_hullBefore[a] = c;
        m_hullNext[c] = m_hullBefore[b] = a;
        m_hullEdge[a] = 0;
        m_hullEdge[b] = 1;
        m_hullEdge[c] = 2;
        for (const std::uint32_t point : m_seed)
            m_hash[hashOf(m_points[point])] = point;
        m_hullStart = a;
        addTriangle(a, b, c, kNobody, kNobody, kNobody);
    }

    std::uint32_t addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t ab,
                              std::uint32_t bc, std::uint32_t ca)
    {
        const auto first = static_cast<std::uint32_t>(m_corners.size());
        m_corners.insert(m_corners.end(), {a, b, c});
        m_twins.resize(m_corners.size());
        link(first, ab);
        link(first + 1, bc);
        link(first + 2, ca);
        return first;
    }

    void link(std::uint32_t edge, std::uint32_t twin)
    {
        m_twins[edge] = twin;
        if (twin != kNobody)
            m_twins[twin] = edge;
    }

    void add(std::uint32_t point)
    {
        const Point& p = m_points[point];
        // A hull point near it in angle, from which on a visible edge is looked for.
        std::uint32_t start = kNobody;
        const std::size_t key = hashOf(p);
        for (std::size_t i = 0; i < m_hash.size(); ++i) {
            start = m_hash[(key + i) % m_hash.size()];
            if (start != kNobody && m_hullNext[start] != start)
                break;
            start = kNobody;
        }
        if (start == kNobody)
            start = m_hullStart;
        start = m_hullBefore[start];
        std::uint32_t from = start;
        std::uint32_t to = m_hullNext[from];
        // The hull runs counter-clockwise: an edge is visible if the point lies to its right.
        while (turn(m_points[from], m_points[to], p) >= 0.0) {
            from = to;
            if (from == start)
                return; // On the hull itself
            to = m_hullNext[from];
        }
        const std::uint32_t first = addTriangle(from, point, to, kNobody, kNobody, m_hullEdge[from]);
        m_hullEdge[point] = legalise(first + 2);
        m_hullEdge[from] = first;
        std::uint32_t ahead = to;
        for (std::uint32_t next = m_hullNext[ahead]; turn(m_points[ahead], m_points[next], p) < 0.0;
             next = m_hullNext[ahead]) {
            const std::uint32_t t =
                addTriangle(ahead, point, next, m_hullEdge[point], kNobody, m_hullEdge[ahead]);
            m_hullEdge[point] = legalise(t + 2);
            m_hullNext[ahead] = ahead; // No longer on the hull
            ahead = next;
        }
        if (from == start) {
            for (std::uint32_t before = m_hullBefore[from]; turn(m_points[before], m_points[from], p) < 0.0;
                 before = m_hullBefore[from]) {
                const std::uint32_t t =
                    addTriangle(before, point, from, kNobody, m_hullEdge[from], m_hullEdge[before]);
                legalise(t + 2);
                m_hullEdge[before] = t;
                m_hullNext[from] = from;
                from = before;
            }
        }
        m_hullStart = m_hullBefore[point] = from;
        m_hullNext[from] = m_hullBefore[ahead] = point;
        m_hullNext[point] = ahead;
        m_hash[hashOf(p)] = point;
        m_hash[hashOf(m_points[from])] = from;
    }

    static std::uint32_t nextEdge(std::uint32_t edge) { return edge % 3 == 2 ? edge - 2 : edge + 1; }
    static std::uint32_t lastEdge(std::uint32_t edge) { return edge % 3 == 0 ? edge + 2 : edge - 1; }

    /// Flips edges until the circles on both sides are empty. Returns the edge after @p edge on the hull
    /// side.
    std::uint32_t legalise(std::uint32_t edge)
    {
        std::uint32_t result = 0;
        m_stack.clear();
        for (;;) {
            const std::uint32_t twin = m_twins[edge];
            result = lastEdge(edge);
            bool flips = false;
            if (twin != kNobody) {
                const std::uint32_t al = nextEdge(edge);
                const std::uint32_t bl = lastEdge(twin);
                const std::uint32_t p0 = m_corners[result];
                const std::uint32_t pr = m_corners[edge];
                const std::uint32_t pl = m_corners[al];
                const std::uint32_t p1 = m_corners[bl];
                flips = inCircle(m_points[p0], m_points[pr], m_points[pl], m_points[p1]);
                if (flips) {
                    m_corners[edge] = p1;
                    m_corners[twin] = p0;
                    const std::uint32_t outer = m_twins[bl];
                    if (outer == kNobody) { // The edge was on the hull
                        std::uint32_t e = m_hullStart;
                        do {
                            if (m_hullEdge[e] == bl) {
                                m_hullEdge[e] = edge;
                                break;
                            }
                            e = m_hullBefore[e];
                        } while (e != m_hullStart);
                    }
                    link(edge, outer);
                    link(twin, m_twins[result]);
                    link(result, bl);
                    m_stack.push_back(nextEdge(twin));
                }
            }
            if (!flips) {
                if (m_stack.empty())
                    return result;
                edge = m_stack.back();
                m_stack.pop_back();
            }
        }
    }

    std::vector<Point> m_points;
    std::array<std::uint32_t, 3> m_seed{};
    Point m_centre = Point::Zero();
    std::vector<std::uint32_t> m_order;
    std::vector<std::uint32_t>
        m_corners; ///< Three points a triangle; edge e runs from its corner to the next
    std::vector<std::uint32_t> m_twins;
    std::vector<std::uint32_t> m_hullNext;
    std::vector<std::uint32_t> m_hullBefore;
    std::vector<std::uint32_t> m_hullEdge; ///< The triangle edge from a hull point to the next
    std::vector<std::uint32_t> m_hash;     ///< Hull points by angle
    std::uint32_t m_hullStart = 0;
    std::vector<std::uint32_t> m_stack;
};

} // namespace

std::vector<std::array<std::uint32_t, 3>> delaunay(std::span<const Vec2> points, double jitter)
{
    std::vector<Point> moved;
    moved.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint64_t bits = mixedBits(i);
        const Point shift(static_cast<double>(bits >> 40U) * 0x1.0p-24 - 0.5,
                          static_cast<double>((bits >> 8U) & 0xffffffU) * 0x1.0p-24 - 0.5);
        moved.emplace_back(points[i].cast<double>() + 2.0 * jitter * shift);
    }
    return SweepHull(std::move(moved)).triangulate();
}

} // namespace espalier
