// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <span>
#include <vector>

namespace espalier {

/// The arc length of a polyline.
double curveLength(std::span<const Eigen::Vector3d> curve);

/// The ends of the internodes that a drawn curve is divided into, base first: pieces of equal length, about
/// @p pieceLength each, or less where a chord would leave the curve by more than @p tolerance; at most
/// kMostCurvePieces for that reason. The curve has two points or more.
inline constexpr std::size_t kMostCurvePieces = 400;
std::vector<Eigen::Vector3d> curvePieces(std::span<const Eigen::Vector3d> curve, double pieceLength,
                                         double tolerance);

/// The tolerance of the curves of a drawing, as a share of its size: less than a pixel of a thousand.
inline constexpr double kDrawingTolerance = 0.0007;

} // namespace espalier
