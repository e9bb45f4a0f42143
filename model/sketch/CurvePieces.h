// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <span>
#include <vector>

namespace espalier {

/// The arc length of a polyline.
double curveLength(std::span<const Eigen::Vector3d> curve);

/// What a curve is divided into.
struct CurvePieces {
    std::vector<Eigen::Vector3d> ends; ///< On the curve, base first; one more than pieces
    std::vector<double> shares;        ///< 0...1, ascending: of the arc length, in the same order
};

/// The internodes that a drawn curve is divided into: pieces of equal length, about
/// @p pieceLength each, or less where a chord would leave the curve by more than @p tolerance; at most
/// kMostCurvePieces for that reason. Where those would not be enough, at the corners of a scribble, pieces of
/// that length are divided one by one, the worst first. The curve has two points or more.
inline constexpr std::size_t kMostCurvePieces = 400;
CurvePieces curvePieces(std::span<const Eigen::Vector3d> curve, double pieceLength, double tolerance);

/// The tolerance of the curves of a drawing, as a share of its size: less than a pixel of a thousand.
inline constexpr double kDrawingTolerance = 0.0007;

} // namespace espalier
