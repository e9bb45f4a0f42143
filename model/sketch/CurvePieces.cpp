// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CurvePieces.h"

#include <queue>

#include <algorithm>
#include <cmath>
#include <map>

namespace espalier {

namespace {

using CurvePoint = Eigen::Vector3d;

/// @p count pieces of equal length.
CurvePieces equalPieces(std::span<const CurvePoint> curve, double length, std::size_t count)
{
    CurvePieces pieces{.ends = {curve.front()}, .shares = {0.0}};
    double passed = 0.0;
    std::size_t segment = 1;
    for (std::size_t i = 1; i < count; ++i) {
        const double place = length * static_cast<double>(i) / static_cast<double>(count);
        double here = (curve[segment] - curve[segment - 1]).norm();
        while (segment + 1 < curve.size() && passed + here < place) {
            passed += here;
            ++segment;
            here = (curve[segment] - curve[segment - 1]).norm();
        }
        const double share = here > 0.0 ? std::clamp((place - passed) / here, 0.0, 1.0) : 0.0;
        pieces.ends.emplace_back(curve[segment - 1] + share * (curve[segment] - curve[segment - 1]));
        pieces.shares.push_back(static_cast<double>(i) / static_cast<double>(count));
    }
    pieces.ends.push_back(curve.back());
    pieces.shares.push_back(1.0);
    return pieces;
}

double distanceFromChord(const CurvePoint& from, const CurvePoint& to, const CurvePoint& point)
{
    const CurvePoint chord = to - from;
    const double square = chord.squaredNorm();
    const double share = square > 0.0 ? std::clamp((point - from).dot(chord) / square, 0.0, 1.0) : 0.0;
    return (point - from - share * chord).norm();
}

/// The greatest distance of the curve's points from the chord of the equal piece that they are on.
double farthestFromChords(std::span<const CurvePoint> curve, const std::vector<CurvePoint>& ends,
                          double length)
{
    const double piece = length / static_cast<double>(ends.size() - 1);
    double farthest = 0.0;
    double passed = 0.0;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
        passed += (curve[i] - curve[i - 1]).norm();
        const std::size_t on = std::min(static_cast<std::size_t>(passed / piece), ends.size() - 2);
        farthest = std::max(farthest, distanceFromChord(ends[on], ends[on + 1], curve[i]));
    }
    return farthest;
}

/// A piece of a curve with what its chord leaves out.
struct ChordedPiece {
    double from = 0.0; ///< Shares of the curve's arc length
    double to = 0.0;
    CurvePoint base = CurvePoint::Zero();
    CurvePoint tip = CurvePoint::Zero();
    double farthest = 0.0;         ///< Distance of the curve's farthest point from the chord, m
    std::size_t farthestPoint = 0; ///< That point's index

    bool operator<(const ChordedPiece& other) const { return farthest < other.farthest; }
};

/// Divides pieces: the one that the curve is farthest from at the farthest point, and so on, until the
/// tolerance holds or there are kMostCurvePieces.
CurvePieces dividedPieces(std::span<const CurvePoint> curve, double length, const CurvePieces& whole,
                          double tolerance)
{
    std::vector<double> shares{0.0}; // By point of the curve
    for (std::size_t i = 1; i < curve.size(); ++i)
        shares.push_back(shares.back() + (curve[i] - curve[i - 1]).norm() / length);
    const auto chorded = [&](ChordedPiece piece) {
        const auto next = std::ranges::upper_bound(shares, piece.from) - shares.begin();
        for (auto i = static_cast<std::size_t>(next); i < curve.size() && shares[i] < piece.to; ++i) {
            const double distance = distanceFromChord(piece.base, piece.tip, curve[i]);
            if (distance > piece.farthest) {
                piece.farthest = distance;
                piece.farthestPoint = i;
            }
        }
        return piece;
    };
    std::priority_queue<ChordedPiece> parts;
    for (std::size_t i = 1; i < whole.ends.size(); ++i) {
        parts.push(chorded({.from = whole.shares[i - 1],
                            .to = whole.shares[i],
                            .base = whole.ends[i - 1],
                            .tip = whole.ends[i]}));
    }
    while (parts.top().farthest > tolerance && parts.size() < kMostCurvePieces) {
        const ChordedPiece worst = parts.top();
        parts.pop();
        const double at = shares[worst.farthestPoint];
        const CurvePoint& point = curve[worst.farthestPoint];
        parts.push(chorded({.from = worst.from, .to = at, .base = worst.base, .tip = point}));
        parts.push(chorded({.from = at, .to = worst.to, .base = point, .tip = worst.tip}));
    }
    std::map<double, CurvePoint> tips; // By share
    for (; !parts.empty(); parts.pop())
        tips.emplace(parts.top().to, parts.top().tip);
    CurvePieces pieces{.ends = {curve.front()}, .shares = {0.0}};
    for (const auto& [share, tip] : tips) {
        pieces.shares.push_back(share);
        pieces.ends.push_back(tip);
    }
    return pieces;
}

} // namespace

double curveLength(std::span<const Eigen::Vector3d> curve)
{
    double length = 0.0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (curve[i] - curve[i - 1]).norm();
    return length;
}

CurvePieces curvePieces(std::span<const Eigen::Vector3d> curve, double pieceLength, double tolerance)
{
    const double length = curveLength(curve);
    const auto least = static_cast<std::size_t>(std::max(1.0, std::round(length / pieceLength)));
    for (std::size_t count = least;; count = std::min(kMostCurvePieces, count + 1 + count / 4)) {
        CurvePieces pieces = equalPieces(curve, length, count);
        if (farthestFromChords(curve, pieces.ends, length) <= tolerance)
            return pieces;
        if (count >= kMostCurvePieces)
            return dividedPieces(curve, length, equalPieces(curve, length, least), tolerance);
    }
}

} // namespace espalier
