// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/SlotAssignment.h"

#include <algorithm>
#include <numeric>

namespace espalier {

namespace {

struct Halving {
    std::span<const Vec2> points;
    std::span<const Vec2> slots;
    std::span<std::uint32_t> chosen;

    void assign(std::span<std::uint32_t> ofPoints, std::span<std::uint32_t> ofSlots) const
    {
        if (ofPoints.size() == 1) {
            chosen[ofPoints.front()] = ofSlots.front();
            return;
        }
        Eigen::AlignedBox2f box;
        for (const std::uint32_t slot : ofSlots)
            box.extend(slots[slot]);
        const int axis = box.sizes().x() >= box.sizes().y() ? 0 : 1;
        const std::size_t half = ofPoints.size() / 2;
        divide(ofPoints, points, axis, half);
        divide(ofSlots, slots, axis, half);
        assign(ofPoints.first(half), ofSlots.first(half));
        assign(ofPoints.subspan(half), ofSlots.subspan(half));
    }

    static void divide(std::span<std::uint32_t> ids, std::span<const Vec2> places, int axis, std::size_t half)
    {
        // Rows of a lattice have equal coordinates: the other axis and the index decide.
        std::ranges::nth_element(ids, ids.begin() + static_cast<std::ptrdiff_t>(half),
                                 [&](std::uint32_t a, std::uint32_t b) {
                                     const Vec2& p = places[a];
                                     const Vec2& q = places[b];
                                     if (p[axis] != q[axis])
                                         return p[axis] < q[axis];
                                     return p[1 - axis] != q[1 - axis] ? p[1 - axis] < q[1 - axis] : a < b;
                                 });
    }
};

} // namespace

void assignSlots(std::span<const Vec2> points, std::span<const Vec2> slots, std::span<std::uint32_t> chosen)
{
    if (points.empty())
        return;
    std::vector<std::uint32_t> ofPoints(points.size());
    std::iota(ofPoints.begin(), ofPoints.end(), 0U);
    std::vector<std::uint32_t> ofSlots = ofPoints;
    Halving{points, slots, chosen}.assign(ofPoints, ofSlots);
}

} // namespace espalier
