// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/CurvePieces.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

using CurvePoint = Eigen::Vector3d;

/// The ends of @p count pieces of equal length.
std::vector<CurvePoint> endsOfPieces(std::span<const CurvePoint> curve, double length, std::size_t count)
{
    std::vector<CurvePoint> ends{curve.front()};
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
        ends.emplace_back(curve[segment - 1] + share * (curve[segment] - curve[segment - 1]));
    }
    ends.push_back(curve.back());
    return ends;
}

/// The greatest distance of the curve's points from the chord of the piece that they are on.
double farthestFromChords(std::span<const CurvePoint> curve, const std::vector<CurvePoint>& ends,
                          double length)
{
    const double piece = length / static_cast<double>(ends.size() - 1);
    double farthest = 0.0;
    double passed = 0.0;
    for (std::size_t i = 1; i + 1 < curve.size(); ++i) {
        passed += (curve[i] - curve[i - 1]).norm();
        const std::size_t on = std::min(static_cast<std::size_t>(passed / piece), ends.size() - 2);
        const CurvePoint chord = ends[on + 1] - ends[on];
        const double square = chord.squaredNorm();
        const double share =
            square > 0.0 ? std::clamp((curve[i] - ends[on]).dot(chord) / square, 0.0, 1.0) : 0.0;
        farthest = std::max(farthest, (curve[i] - ends[on] - share * chord).norm());
    }
    return farthest;
}

} // namespace

double curveLength(std::span<const Eigen::Vector3d> curve)
{
    double length = 0.0;
    for (std::size_t i = 1; i < curve.size(); ++i)
        length += (curve[i] - curve[i - 1]).norm();
    return length;
}

std::vector<Eigen::Vector3d> curvePieces(std::span<const Eigen::Vector3d> curve, double pieceLength,
                                         double tolerance)
{
    const double length = curveLength(curve);
    auto count = static_cast<std::size_t>(std::max(1.0, std::round(length / pieceLength)));
    for (;;) {
        std::vector<CurvePoint> ends = endsOfPieces(curve, length, count);
        if (count >= kMostCurvePieces || farthestFromChords(curve, ends, length) <= tolerance)
            return ends;
        count = std::min(kMostCurvePieces, count + 1 + count / 4);
    }
}

} // namespace espalier
