// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <span>
#include <vector>

namespace espalier {

/// The arc length of a polyline.
double curveLength(std::span<const Eigen::Vector3d> curve);

/// The ends of the internodes that a drawn curve is divided into, base first: pieces of equal length, about
/// @p pieceLength each, or less where a chord would leave the curve by more than a two-thousandth of its
/// length; at most kMostCurvePieces for that reason. The curve has two points or more.
inline constexpr std::size_t kMostCurvePieces = 400;
std::vector<Eigen::Vector3d> curvePieces(std::span<const Eigen::Vector3d> curve, double pieceLength);

} // namespace espalier
