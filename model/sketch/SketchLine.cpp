// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/SketchLine.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Walks along a line by arc length; the lengths asked for ascend.
class LineWalk {
public:
    explicit LineWalk(const SketchLine& line) : m_line(line) {}

    /// The point at @p length from the line's start; its end if the line is shorter.
    Eigen::Vector2d at(double length)
    {
        while (m_segment + 1 < m_line.size()) {
            const Eigen::Vector2d step = m_line[m_segment + 1] - m_line[m_segment];
            const double here = step.norm();
            if (m_passed + here >= length && here > 0.0) {
                const double share = std::clamp((length - m_passed) / here, 0.0, 1.0);
                return m_line[m_segment] + share * step;
            }
            m_passed += here;
            ++m_segment;
        }
        return m_line.back();
    }

    /// The number of points that lie before the last place asked for.
    std::size_t pointsBefore() const { return std::min(m_segment + 1, m_line.size()); }

private:
    const SketchLine& m_line;
    std::size_t m_segment = 0;
    double m_passed = 0.0; ///< The length up to the segment
};

} // namespace

double lengthOf(const SketchLine& line)
{
    double length = 0.0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

std::vector<double> arcShares(const SketchLine& line)
{
    std::vector<double> shares(line.size(), 0.0);
    for (std::size_t i = 1; i < line.size(); ++i)
        shares[i] = shares[i - 1] + (line[i] - line[i - 1]).norm();
    const double length = shares.empty() ? 0.0 : shares.back();
    if (length > 0.0) {
        for (double& share : shares)
            share /= length;
    }
    return shares;
}

Eigen::Vector2d pointAlong(const SketchLine& line, double along)
{
    if (along >= 1.0)
        return line.back();
    return LineWalk(line).at(std::max(along, 0.0) * lengthOf(line));
}

SketchLine evenLine(const SketchLine& line, std::size_t count)
{
    SketchLine even;
    even.reserve(count);
    LineWalk walk(line);
    const double step = lengthOf(line) / static_cast<double>(count - 1);
    even.push_back(line.front());
    for (std::size_t i = 1; i + 1 < count; ++i)
        even.push_back(walk.at(static_cast<double>(i) * step));
    even.push_back(line.back());
    return even;
}

PlaceOnLine nearestPlace(const SketchLine& line, const Eigen::Vector2d& point)
{
    PlaceOnLine best{.along = 0.0, .point = line.front(), .distance = (point - line.front()).norm()};
    double length = 0.0; // So far
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Eigen::Vector2d step = line[i] - line[i - 1];
        const double square = step.squaredNorm();
        if (square == 0.0)
            continue;
        const double share = std::clamp((point - line[i - 1]).dot(step) / square, 0.0, 1.0);
        const Eigen::Vector2d place = line[i - 1] + share * step;
        const double distance = (point - place).norm();
        const double here = std::sqrt(square);
        if (distance < best.distance)
            best = {.along = length + share * here, .point = place, .distance = distance};
        length += here;
    }
    best.along = length > 0.0 ? std::min(best.along / length, 1.0) : 0.0;
    return best;
}

} // namespace espalier
