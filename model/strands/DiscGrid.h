// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace espalier {

/// Discs of radius 1 sorted into square cells of edge 2, to find those that touch.
class DiscGrid {
public:
    void sort(std::span<const Vec2> places)
    {
        Eigen::AlignedBox2f box;
        for (const Vec2& place : places)
            box.extend(place);
        m_corner = box.min();
        const Vec2 size = places.empty() ? Vec2(Vec2::Zero()) : Vec2(box.sizes());
        // Discs that are far apart must not need more cells than there are discs.
        const double cells = 4.0 * static_cast<double>(places.size()) + 16.0;
        const double area = (double{size.x()} + kEdge) * (double{size.y()} + kEdge);
        m_edge = std::max(kEdge, static_cast<float>(std::sqrt(area / cells)));
        m_columns = static_cast<std::int64_t>(size.x() / m_edge) + 1;
        m_rows = static_cast<std::int64_t>(size.y() / m_edge) + 1;
        m_first.assign(static_cast<std::size_t>(m_columns * m_rows) + 1, 0);
        m_cell.resize(places.size());
        for (std::size_t i = 0; i < places.size(); ++i) {
            m_cell[i] = cellOf(places[i]);
            ++m_first[m_cell[i] + 1];
        }
        std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
        m_discs.resize(places.size());
        std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
        for (std::uint32_t i = 0; i < places.size(); ++i)
            m_discs[next[m_cell[i]]++] = i;
    }

    /// Calls @p visit(a, b) once for each pair of discs whose centres are nearer than @p reach, at most 2.
    template <class Visit>
    void forEachPair(std::span<const Vec2> places, float reach, Visit&& visit) const
    {
        for (std::int64_t row = 0; row < m_rows; ++row) {
            for (std::int64_t column = 0; column < m_columns; ++column) {
                const auto own = discsOf(row * m_columns + column);
                for (std::size_t i = 0; i < own.size(); ++i) {
                    const auto look = [&](std::span<const std::uint32_t> others) {
                        for (const std::uint32_t other : others) {
                            if ((places[own[i]] - places[other]).squaredNorm() < reach * reach)
                                visit(own[i], other);
                        }
                    };
                    look(own.subspan(i + 1));
                    if (column + 1 < m_columns)
                        look(discsOf(row * m_columns + column + 1));
                    if (row + 1 == m_rows)
                        continue;
                    const std::int64_t above = (row + 1) * m_columns;
                    for (std::int64_t c = std::max<std::int64_t>(column - 1, 0);
                         c <= std::min(column + 1, m_columns - 1); ++c)
                        look(discsOf(above + c));
                }
            }
        }
    }

private:
    static constexpr float kEdge = 2.0F;

    std::uint32_t cellOf(const Vec2& place) const
    {
        const Vec2 cell = (place - m_corner) / m_edge;
        const auto column = std::clamp<std::int64_t>(static_cast<std::int64_t>(cell.x()), 0, m_columns - 1);
        const auto row = std::clamp<std::int64_t>(static_cast<std::int64_t>(cell.y()), 0, m_rows - 1);
        return static_cast<std::uint32_t>(row * m_columns + column);
    }
    std::span<const std::uint32_t> discsOf(std::int64_t cell) const
    {
        const auto i = static_cast<std::size_t>(cell);
        return std::span(m_discs).subspan(m_first[i], m_first[i + 1] - m_first[i]);
    }

    Vec2 m_corner = Vec2::Zero();
    float m_edge = kEdge;
    std::int64_t m_columns = 1;
    std::int64_t m_rows = 1;
    std::vector<std::uint32_t> m_first;
    std::vector<std::uint32_t> m_cell;
    std::vector<std::uint32_t> m_discs;
};

} // namespace espalier
