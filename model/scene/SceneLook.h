// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/tree/ImageAsset.h"

#include <QColor>

namespace espalier {

/// The least elevation of the sun above the horizon, rad.
inline constexpr double kLeastSunElevation = radians(5);

/// What stands behind the tree.
enum class Backdrop : int {
    Studio,      ///< The dark one or the light one, as the program's theme is
    Horizon,     ///< An overcast sky over a light ground
    Plain,       ///< One colour
    Gradient,    ///< From one colour at the lower edge to another at the upper one
    DarkStudio,  ///< Dark, lighter behind the tree
    LightStudio, ///< A bright sweep of paper without an edge
};
inline constexpr int kBackdropCount = 6;
/// The names of the backdrops, in their order, as in files and for ParameterInfo::choices.
inline constexpr const char* kBackdropNames = "studio horizon plain gradient dark_studio light_studio";

/// A picture behind the tree to draw after. It stands upright at the seedling, parallel to the screen, so
/// that it keeps its place beside the tree when the view is moved or magnified.
struct TracingImage {
    static constexpr double kMaxHeight = 100.0; ///< m
    static constexpr double kMinHeight = 0.01;  ///< m
    static constexpr double kMaxOffset = 100.0; ///< m

    ImageAsset image{}; ///< Null for none
    /// Distance of its middle from the seedling to the right, m, −kMaxOffset...kMaxOffset.
    double right = 0.0;
    double up = 1.5;      ///< Height of its middle above the seedling, m, −kMaxOffset...kMaxOffset
    double height = 3.0;  ///< m, kMinHeight...kMaxHeight; its width follows from the image
    double opacity = 0.5; ///< 0...1

    bool operator==(const TracingImage&) const = default;
};

/// The surroundings of a tree: what stands behind it, what it stands on, and its light. They belong to the
/// document and are saved with it, but they are not part of the tree, so changes of them are not undone.
struct SceneLook {
    bool groundShown = true;
    bool shadowsShown = true;
    bool gridShown = false; ///< Lines on the ground, a metre apart
    Backdrop backdrop = Backdrop::Studio;
    QColor backgroundColour{92, 98, 104}; ///< Colour of Plain; of Gradient at the lower edge; opaque
    QColor backgroundTop{188, 202, 214};  ///< Colour of Gradient at the upper edge; opaque
    TracingImage tracing{};
    /// rad from +Z (front) toward +X (right), −π...π; of a pinned sun, rad from the camera toward its right.
    double sunAzimuth = radians(58);
    double sunElevation = radians(48); ///< rad above the horizon, kLeastSunElevation...90°
    bool sunPinned = false;            ///< The sun stays at its place on the screen when the tree is turned
    bool sunShown = true;              ///< The sun shows as a ball that can be dragged

    bool operator==(const SceneLook&) const = default;
};

/// Moves values that are out of range to the nearest limit.
void keepWithinLimits(SceneLook& look);
/// The look without what belongs to one tree alone: the picture to draw after.
SceneLook withoutPicture(SceneLook look);

} // namespace espalier
