// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/Contours.h"

#include <algorithm>
#include <limits>

namespace espalier {

namespace {

double squaredDistanceToSegment(const Eigen::Vector2d& point, const Eigen::Vector2d& from,
                                const Eigen::Vector2d& to)
{
    const Eigen::Vector2d along = to - from;
    const double length = along.squaredNorm();
    const double place = length > 0.0 ? std::clamp((point - from).dot(along) / length, 0.0, 1.0) : 0.0;
    return (from + place * along - point).squaredNorm();
}

} // namespace

std::array<std::array<int, 2>, 2> crossedSides(const std::array<bool, 4>& inside, bool centreInside)
{
    std::array<std::array<int, 2>, 2> pairs{{{-1, -1}, {-1, -1}}};
    std::size_t count = 0;
    for (int side = 0; side < 4; ++side) {
        const auto corner = [&](int number) { return inside[static_cast<std::size_t>(number % 4)]; };
        if (!corner(side) || corner(side + 1))
            continue;
        // The line has the inside on its left, so it enters the square at a side where the walk around the
        // square leaves the inside. It ends at the next side where the walk enters; of two such sides, at the
        // first if the corners are joined across the centre.
        int end = side + 1;
        while (corner(end) || !corner(end + 1))
            ++end;
        const bool saddle = inside[0] == inside[2] && inside[1] == inside[3];
        if (saddle && !centreInside)
            end += 2;
        pairs[count++] = {side, end % 4};
    }
    return pairs;
}

Contours::Contours(const Grid<float>& values, float level) : m_begin(values.width(), values.height() + 1)
{
    const auto crossing = [&](int x, int y, int nextX, int nextY) {
        const auto from = double{values(x, y)};
        const auto to = double{values(nextX, nextY)};
        const double place = (double{level} - from) / (to - from);
        return Eigen::Vector2d(x + place * (nextX - x), y + place * (nextY - y));
    };
    for (int y = 0; y < values.height(); ++y) {
        for (int x = 0; x < values.width(); ++x) {
            m_begin(x, y) = static_cast<int>(m_segments.size());
            if (x + 1 == values.width() || y + 1 == values.height())
                continue;
            const std::array<float, 4> corners{values(x, y), values(x + 1, y), values(x + 1, y + 1),
                                               values(x, y + 1)};
            const std::array<bool, 4> inside{corners[0] > level, corners[1] > level, corners[2] > level,
                                             corners[3] > level};
            if (inside[0] == inside[1] && inside[1] == inside[2] && inside[2] == inside[3])
                continue;
            const float centre = 0.25F * (corners[0] + corners[1] + corners[2] + corners[3]);
            const int node = static_cast<int>(values.index(x, y));
            const std::array<int, 4> edges{2 * node, 2 * (node + 1) + 1, 2 * (node + values.width()),
                                           2 * node + 1};
            const auto point = [&](int side) {
                switch (side) {
                case 0:
                    return crossing(x, y, x + 1, y);
                case 1:
                    return crossing(x + 1, y, x + 1, y + 1);
                case 2:
                    return crossing(x, y + 1, x + 1, y + 1);
                default:
                    return crossing(x, y, x, y + 1);
                }
            };
            for (const auto& [from, to] : crossedSides(inside, centre > level))
                if (from >= 0)
                    m_segments.push_back({point(from), point(to), edges[static_cast<std::size_t>(from)],
                                          edges[static_cast<std::size_t>(to)]});
        }
    }
    for (int x = 0; x < values.width(); ++x)
        m_begin(x, values.height()) = static_cast<int>(m_segments.size());
}

std::vector<Loop> Contours::loops() const
{
    // Each crossed edge begins one segment and ends one.
    std::vector<int> beginning(2 * m_begin.size(), -1);
    for (std::size_t i = 0; i < m_segments.size(); ++i)
        beginning[static_cast<std::size_t>(m_segments[i].fromEdge)] = static_cast<int>(i);
    std::vector<bool> done(m_segments.size(), false);
    std::vector<Loop> loops;
    for (std::size_t first = 0; first < m_segments.size(); ++first) {
        if (done[first])
            continue;
        Loop& loop = loops.emplace_back();
        for (std::size_t i = first; !done[i];) {
            done[i] = true;
            loop.push_back(m_segments[i].from);
            i = static_cast<std::size_t>(beginning[static_cast<std::size_t>(m_segments[i].toEdge)]);
        }
    }
    return loops;
}

double Contours::squaredDistance(const Eigen::Vector2d& point, int x, int y, int reach) const
{
    double least = std::numeric_limits<double>::infinity();
    for (int squareY = std::max(0, y - reach); squareY <= std::min(m_begin.height() - 2, y + reach);
         ++squareY) {
        for (int squareX = std::max(0, x - reach); squareX <= std::min(m_begin.width() - 1, x + reach);
             ++squareX) {
            const std::size_t square = m_begin.index(squareX, squareY);
            for (int i = m_begin[square]; i < m_begin[square + 1]; ++i) {
                const Segment& segment = m_segments[static_cast<std::size_t>(i)];
                least = std::min(least, squaredDistanceToSegment(point, segment.from, segment.to));
            }
        }
    }
    return least;
}

} // namespace espalier
