// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/envelope/Thinning.h"

#include <algorithm>
#include <array>

namespace espalier {

namespace {

struct GridStep {
    int x;
    int y;
};

/// The neighbours P2...P9 of the paper: north, then clockwise. Neighbour k is bit k of a neighbourhood.
constexpr std::array<GridStep, 8> kNeighbours{
    {{0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}}};

/// Whether the first or second subiteration deletes a node with these neighbours.
constexpr bool isDeletable(unsigned neighbours, bool second)
{
    const auto p = [&](unsigned number) { return ((neighbours >> (number - 2)) & 1U) != 0; };
    const auto both = [](bool a, bool b) { return a && b ? 1 : 0; };
    const auto either = [](bool a, bool b) { return a || b ? 1 : 0; };

    const int components = both(!p(2), p(3) || p(4)) + both(!p(4), p(5) || p(6)) + both(!p(6), p(7) || p(8)) +
                           both(!p(8), p(9) || p(2));
    const int one = either(p(9), p(2)) + either(p(3), p(4)) + either(p(5), p(6)) + either(p(7), p(8));
    const int other = either(p(2), p(3)) + either(p(4), p(5)) + either(p(6), p(7)) + either(p(8), p(9));
    const int fewest = std::min(one, other);
    const bool side = second ? (p(2) || p(3) || !p(5)) && p(4) : (p(6) || p(7) || !p(9)) && p(8);
    return components == 1 && fewest >= 2 && fewest <= 3 && !side;
}

constexpr std::array<std::array<bool, 256>, 2> kDeletable = [] {
    std::array<std::array<bool, 256>, 2> table{};
    for (unsigned neighbours = 0; neighbours < 256; ++neighbours) {
        table[0][neighbours] = isDeletable(neighbours, false);
        table[1][neighbours] = isDeletable(neighbours, true);
    }
    return table;
}();

} // namespace

Mask thinned(const Mask& mask)
{
    return thinned(mask, Mask(mask.width(), mask.height()));
}

Mask thinned(const Mask& mask, const Mask& kept)
{
    // A frame of one node makes tests for the edge unnecessary.
    Mask result(mask.width() + 2, mask.height() + 2);
    Mask listed(result.width(), result.height());
    for (int y = 0; y < mask.height(); ++y) {
        for (int x = 0; x < mask.width(); ++x) {
            result(x + 1, y + 1) = mask(x, y) != 0;
            listed(x + 1, y + 1) = kept(x, y) != 0;
        }
    }
    std::array<std::ptrdiff_t, 8> offset{};
    for (std::size_t k = 0; k < 8; ++k)
        offset[k] = std::ptrdiff_t{kNeighbours[k].y} * result.width() + kNeighbours[k].x;
    const auto neighbour = [&](std::size_t node, std::size_t k) {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(node) + offset[k]);
    };
    const auto neighbours = [&](std::size_t node) {
        unsigned bits = 0;
        for (std::size_t k = 0; k < 8; ++k)
            bits |= static_cast<unsigned>(result[neighbour(node, k)]) << k;
        return bits;
    };

    // Only nodes at the border can be deleted, so only those are tested: each deletion adds its neighbours to
    // the list. Kept nodes are marked as listed from the start, so they are never added.
    std::vector<std::size_t> border;
    for (std::size_t node = 0; node < result.size(); ++node) {
        if (result[node] != 0 && listed[node] == 0 && neighbours(node) != 255) {
            border.push_back(node);
            listed[node] = 1;
        }
    }
    std::vector<std::size_t> doomed;
    for (int unchanged = 0, pass = 0; unchanged < 2; pass = 1 - pass) {
        const std::array<bool, 256>& deletable = kDeletable[static_cast<std::size_t>(pass)];
        doomed.clear();
        for (const std::size_t node : border)
            if (deletable[neighbours(node)])
                doomed.push_back(node);
        unchanged = doomed.empty() ? unchanged + 1 : 0;
        for (const std::size_t node : doomed)
            result[node] = 0;
        std::erase_if(border, [&](std::size_t node) { return result[node] == 0; });
        for (const std::size_t node : doomed) {
            for (std::size_t k = 0; k < 8; ++k) {
                const std::size_t next = neighbour(node, k);
                if (result[next] != 0 && listed[next] == 0) {
                    listed[next] = 1;
                    border.push_back(next);
                }
            }
        }
    }

    Mask axes(mask.width(), mask.height());
    for (int y = 0; y < mask.height(); ++y)
        for (int x = 0; x < mask.width(); ++x)
            axes(x, y) = result(x + 1, y + 1);
    return axes;
}

} // namespace espalier
