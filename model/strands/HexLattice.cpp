// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/HexLattice.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// The origin against a point of the lattice. Around it, points come one by one and not in shells, so each
/// number of them lies in a small circle. This one gives the densest of the loosest bundles of 50 and more.
constexpr double kOriginX = 0.8667;
constexpr double kOriginY = 0.2310;

/// Axial coordinates: the point 2 (q + r / 2, r √3 / 2).
struct Axial {
    int q;
    int r;
    Eigen::Vector2d position() const { return {2.0 * q + r - kOriginX, r * std::numbers::sqrt3 - kOriginY}; }
};

constexpr std::array<Axial, 6> kAround{{{1, 0}, {0, 1}, {-1, 1}, {-1, 0}, {0, -1}, {1, -1}}};

} // namespace

HexLattice::HexLattice(std::uint32_t slots)
{
    // A disc of radius R holds π R² / (2 √3) points of a lattice with distance 2; some more for its rim.
    const double wanted = std::sqrt((slots + 8.0) * 2.0 * std::numbers::sqrt3 / std::numbers::pi) + 3.0;
    const auto edge = static_cast<int>(wanted / std::numbers::sqrt3) + 2;
    struct Entry {
        double distance; ///< Squared, from the origin
        Axial axial;
    };
    std::vector<Entry> entries;
    for (int r = -edge; r <= edge; ++r) {
        for (int q = -2 * edge; q <= 2 * edge; ++q) {
            const Axial axial{q, r};
            if (const double distance = axial.position().squaredNorm(); distance <= wanted * wanted)
                entries.push_back({distance, axial});
        }
    }
    std::ranges::sort(entries, {}, &Entry::distance);

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
        m_positions.emplace_back(entry.axial.position().cast<float>());
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
