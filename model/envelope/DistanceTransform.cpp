// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/DistanceTransform.h"

#include "model/envelope/GridLines.h"

#include <algorithm>

namespace espalier {

namespace {

/// The lower envelope of parabolas along one line of nodes.
class Parabolas {
public:
    explicit Parabolas(int length)
        : m_cost(static_cast<std::size_t>(length)),
          m_centre(static_cast<std::size_t>(length)),
          m_from(static_cast<std::size_t>(length))
    {
    }

    double& cost(int node) { return m_cost[static_cast<std::size_t>(node)]; }

    /// Calls @p take(node, value, centre) for each node; without any parabola, centre is -1 and value is
    /// infinite.
    template <class Take>
    void each(Take&& take)
    {
        const int length = static_cast<int>(m_cost.size());
        std::size_t count = 0;
        for (int node = 0; node < length; ++node) {
            if (cost(node) == kNoSite)
                continue;
            double from = -kNoSite;
            while (count > 0) {
                from = meeting(m_centre[count - 1], node);
                if (from > m_from[count - 1])
                    break;
                --count;
                from = -kNoSite;
            }
            m_centre[count] = node;
            m_from[count] = from;
            ++count;
        }
        std::size_t current = 0;
        for (int node = 0; node < length; ++node) {
            if (count == 0) {
                take(node, kNoSite, -1);
                continue;
            }
            while (current + 1 < count && m_from[current + 1] <= node)
                ++current;
            const int centre = m_centre[current];
            const double apart = node - centre;
            take(node, apart * apart + cost(centre), centre);
        }
    }

private:
    /// The place from which on the parabola of the later node @p right lies below that of @p left.
    double meeting(int left, int right)
    {
        const double difference = cost(right) - cost(left);
        return 0.5 * (difference / (right - left) + right + left);
    }

    std::vector<double> m_cost;
    std::vector<int> m_centre;
    std::vector<double> m_from;
};

} // namespace

DistanceTransform distanceTransform(const Grid<double>& cost)
{
    const int width = cost.width();
    const int height = cost.height();
    DistanceTransform result{Grid<double>(width, height), Grid<int>(width, height)};
    Grid<double> value(width, height);
    Grid<int> row(width, height);

    forLines(width, [&](int begin, int end) {
        Parabolas column(height);
        for (int x = begin; x < end; ++x) {
            for (int y = 0; y < height; ++y)
                column.cost(y) = cost(x, y);
            column.each([&](int y, double least, int centre) {
                value(x, y) = least;
                row(x, y) = centre;
            });
        }
    });
    forLines(height, [&](int begin, int end) {
        Parabolas line(width);
        for (int y = begin; y < end; ++y) {
            for (int x = 0; x < width; ++x)
                line.cost(x) = value(x, y);
            line.each([&](int x, double least, int centre) {
                result.value(x, y) = least;
                result.site(x, y) = centre < 0 ? -1 : static_cast<int>(cost.index(centre, row(centre, y)));
            });
        }
    });
    return result;
}

} // namespace espalier
