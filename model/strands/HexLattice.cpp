// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/HexLattice.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Axial coordinates: the point 2 (q + r / 2, r √3 / 2).
struct Axial {
    int q;
    int r;
    /// A quarter of the squared distance from the origin.
    std::int64_t norm() const { return std::int64_t{q} * q + std::int64_t{q} * r + std::int64_t{r} * r; }
};

Vec2 positionOf(const Axial& axial)
{
    return {static_cast<float>(2 * axial.q + axial.r), static_cast<float>(axial.r * std::numbers::sqrt3)};
}

constexpr std::array<Axial, 6> kAround{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};

} // namespace

HexLattice::HexLattice(std::uint32_t slots)
{
    // A disc of radius R holds π R² / (2 √3) points of a lattice with distance 2; some more for its rim.
    const double wanted = std::sqrt((slots + 8.0) * 2.0 * std::numbers::sqrt3 / std::numbers::pi) + 3.0;
    const auto most = static_cast<std::int64_t>(wanted * wanted / 4.0);
    const auto edge = static_cast<int>(wanted / std::numbers::sqrt3) + 2;
    struct Entry {
        std::int64_t norm;
        double angle; ///< Of this slot or of the opposite one, 0...π
        bool isOpposite;
        Axial axial;
    };
    std::vector<Entry> entries;
    for (int r = -edge; r <= edge; ++r) {
        for (int q = -2 * edge; q <= 2 * edge; ++q) {
            const Axial axial{q, r};
            if (axial.norm() > most)
                continue;
            const bool isOpposite = r < 0 || (r == 0 && q < 0);
            const Vec2 position = positionOf(isOpposite ? Axial{-q, -r} : axial);
            entries.push_back(
                {axial.norm(), std::atan2(double{position.y()}, double{position.x()}), isOpposite, axial});
        }
    }
    std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
        if (a.norm != b.norm)
            return a.norm < b.norm;
        return a.angle != b.angle ? a.angle < b.angle : a.isOpposite < b.isOpposite;
    });

    const int side = 4 * edge + 3;
    std::vector<std::uint32_t> slotAt(static_cast<std::size_t>(side) * static_cast<std::size_t>(side), kNone);
    const auto place = [&](const Axial& axial) {
        return static_cast<std::size_t>(axial.r + 2 * edge + 1) * static_cast<std::size_t>(side) +
               static_cast<std::size_t>(axial.q + 2 * edge + 1);
    };
    m_positions.reserve(entries.size());
    m_sums.reserve(entries.size() + 1);
    m_sums.emplace_back(Eigen::Vector2d::Zero());
    for (const Entry& entry : entries) {
        slotAt[place(entry.axial)] = size();
        m_positions.push_back(positionOf(entry.axial));
        m_sums.emplace_back(m_sums.back() + m_positions.back().cast<double>());
    }
    m_neighbours.resize(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i) {
        for (std::size_t j = 0; j < kAround.size(); ++j) {
            const Axial& axial = entries[i].axial;
            m_neighbours[i][j] = slotAt[place({axial.q + kAround[j].q, axial.r + kAround[j].r})];
        }
    }
}

} // namespace espalier
