// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace espalier {

/// A closed line of vertices of a surface.
struct VertexLoop {
    VertexIndex first = 0; ///< Its vertices follow one another
    std::uint32_t count = 0;
    std::span<const std::uint32_t> strands; ///< For each vertex its strand; empty if it stands for none
};

/// Joins two closed lines, one above the other, by triangles, so that each edge of either belongs to one
/// triangle. Where both lines have vertices of the same strands in the same order, these are joined (Strands
/// 2024 §5.5); between them, and where there are none, triangles follow the shorter diagonals. @p position
/// returns the place of a vertex, m. Triangles face outward if the lines run counter-clockwise in the
/// coordinates of sections, and the second is the upper one.
class LoopStrip {
public:
    template <class Position>
    void join(const VertexLoop& lower, const VertexLoop& upper, Position&& position,
              std::vector<std::array<VertexIndex, 3>>& triangles)
    {
        findAnchors(lower, upper);
        if (m_anchors.empty())
            m_anchors.push_back(nearestPair(lower, upper, position));
        m_rungs.clear();
        for (std::size_t i = 0; i < m_anchors.size(); ++i) {
            const auto [low, up] = m_anchors[i];
            const auto [nextLow, nextUp] = m_anchors[(i + 1) % m_anchors.size()];
            const bool isWhole = m_anchors.size() == 1;
            const std::uint32_t lows = isWhole ? lower.count : (nextLow + lower.count - low) % lower.count;
            const std::uint32_t ups = isWhole ? upper.count : (nextUp + upper.count - up) % upper.count;
            zip(lower, upper, low, lows, up, ups, position, triangles);
        }
    }

private:
    struct Anchor {
        std::uint32_t low;
        std::uint32_t up;
    };

    void findAnchors(const VertexLoop& lower, const VertexLoop& upper);

    template <class Position>
    static Anchor nearestPair(const VertexLoop& lower, const VertexLoop& upper, Position&& position)
    {
        // Against the middles: between distant lines that bend, the nearest vertex says nothing about the
        // angle.
        const auto middleOf = [&](const VertexLoop& loop) {
            Vec3 sum = Vec3::Zero();
            for (std::uint32_t i = 0; i < loop.count; ++i)
                sum += position(loop.first + i);
            return Vec3(sum / static_cast<float>(loop.count));
        };
        const Vec3 offset = middleOf(upper) - middleOf(lower);
        Anchor best{0, 0};
        float least = std::numeric_limits<float>::max();
        for (std::uint32_t up = 0; up < upper.count; ++up) {
            const float distance =
                (position(lower.first) + offset - position(upper.first + up)).squaredNorm();
            if (distance < least) {
                least = distance;
                best.up = up;
            }
        }
        return best;
    }

    template <class Position>
    void zip(const VertexLoop& lower, const VertexLoop& upper, std::uint32_t low, std::uint32_t lows,
             std::uint32_t up, std::uint32_t ups, Position&& position,
             std::vector<std::array<VertexIndex, 3>>& triangles)
    {
        const auto lowAt = [&](std::uint32_t i) { return lower.first + (low + i) % lower.count; };
        const auto upAt = [&](std::uint32_t i) { return upper.first + (up + i) % upper.count; };
        std::uint32_t i = 0;
        std::uint32_t j = 0;
        while (i < lows || j < ups) {
            bool advancesLow = j == ups;
            if (i < lows && j < ups) {
                const float byLow = (position(lowAt(i + 1)) - position(upAt(j))).squaredNorm();
                const float byUp = (position(lowAt(i)) - position(upAt(j + 1))).squaredNorm();
                // Neither side may run away from the other.
                const float ahead = (static_cast<float>(i) + 0.5F) / static_cast<float>(lows) -
                                    (static_cast<float>(j) + 0.5F) / static_cast<float>(ups);
                advancesLow = std::abs(ahead) > 0.34F ? ahead < 0.0F : byLow <= byUp;
                // Around few vertices the first and the last part can come to the same edge from both sides.
                if (m_anchors.size() < 3 &&
                    hasRung(advancesLow ? lowAt(i + 1) : lowAt(i), advancesLow ? upAt(j) : upAt(j + 1)))
                    advancesLow = !advancesLow;
            }
            if (advancesLow) {
                triangles.push_back({lowAt(i), upAt(j), lowAt(i + 1)});
                ++i;
            } else {
                triangles.push_back({lowAt(i), upAt(j), upAt(j + 1)});
                ++j;
            }
            if (m_anchors.size() < 3)
                m_rungs.push_back({lowAt(i), upAt(j)});
        }
    }

    bool hasRung(VertexIndex low, VertexIndex up) const
    {
        return std::ranges::any_of(m_rungs,
                                   [&](const auto& rung) { return rung[0] == low && rung[1] == up; });
    }

    std::vector<std::array<VertexIndex, 2>> m_rungs; ///< Edges between the lines, where two can be the same
    std::vector<Anchor> m_anchors;
    std::vector<Anchor> m_common;
    std::vector<std::uint32_t> m_placeOf; ///< By strand, against the smallest: its place on the upper line
    std::vector<std::uint32_t> m_tails;
    std::vector<std::uint32_t> m_links;
};

} // namespace espalier
