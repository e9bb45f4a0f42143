// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QColor>
#include <QObject>
#include <QString>

#include <type_traits>

namespace espalier {

/// Largest radius of the brush, m.
inline constexpr double kMaxBrushRadius = 5.0;

/// Limits of the weights of bending and stretching.
inline constexpr double kLeastBendWeight = 0.01;
inline constexpr double kMostBendWeight = 100.0;

/// Limits of the adventitious buds that a tap adds: their number, and the distance between them, m.
inline constexpr double kLeastNewBuds = 3;
inline constexpr double kMostNewBuds = 8;
inline constexpr double kMostBudSpacing = 0.3;

/// Limits of the factors by which a drawing's depth may exceed it.
inline constexpr double kLeastDepthFactor = 0.5;
inline constexpr double kMostDepthFactor = 3.0;

/// Limits of a tree's variations: how strong the weakest is, of 1, and their number.
inline constexpr double kLeastVariation = 0.05;
inline constexpr double kMostVariations = 100;

/// The next larger (@p notches > 0) or smaller radius, for the wheel and the keys [ and ]: a notch changes it
/// by a tenth, down to the radius 0 of a single axis and up again from it.
double steppedBrushRadius(double radius, double notches);

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

/// A picture behind the tree to draw after. It stands upright at the seedling, parallel to the screen, so
/// that it keeps its place beside the tree when the view is moved or magnified.
struct TracingImage {
    static constexpr double kMaxHeight = 100.0; ///< m
    static constexpr double kMaxOffset = 100.0; ///< m

    QString file{}; ///< Empty for none
    /// Distance of its middle from the seedling to the right, m, −kMaxOffset...kMaxOffset.
    double right = 0.0;
    double up = 1.5;      ///< Height of its middle above the seedling, m, −kMaxOffset...kMaxOffset
    double height = 3.0;  ///< m, 0.01...kMaxHeight; its width follows from the file
    double opacity = 0.5; ///< 0...1

    bool operator==(const TracingImage&) const = default;
};

/// How the tree is shown and how the brush is set. This belongs to the user, not to the tree: it is not part
/// of the document and not undone.
struct ViewValues {
    double brushRadius = 0.5;   ///< m, 0...kMaxBrushRadius; 0 draws a single axis
    bool pressureScales = true; ///< A pen's pressure scales the radius of the brush
    bool markersShown = true;   ///< Markers of free space show while brushing
    bool envelopeShown = true;  ///< The envelopes of lassos show while the lasso is the current tool
    bool planeShown = true;     ///< Hints of the drawing plane show
    double bendingWeight =
        1.0; ///< Resistance of branches against bending, kLeastBendWeight...kMostBendWeight
    /// Resistance of branches against stretching, kLeastBendWeight...kMostBendWeight.
    double stretchingWeight = 1.0;
    bool twistsSubtree = false; ///< A twist reaches all that a branch carries, not only the branch itself
    double newBuds = 5;         ///< Buds that a tap adds, a whole number, kLeastNewBuds...kMostNewBuds
    bool sketchCuts = false;    ///< Strokes of the pencil take branches away
    bool sketchSides = true;    ///< Two strokes of the pencil side by side are the two sides of one branch
    bool sketchMirror = false;  ///< Strokes of the pencil are drawn on the other side of the trunk as well
    /// A tap of Multiply passes on what a branch carries, instead of adding to it: only to branches of its
    /// order, scaled with them, in place of what they carried.
    bool passesOn = false;
    bool passesOnInOrder = false;
    bool passesOnScaled = true;
    bool passesOnAnew = false;
    double variation = 0.3;     ///< VaryOperation::amount, kLeastVariation...1
    double variationNumber = 1; ///< The seed of a variation, a whole number, 1...kMostVariations
    bool secondTree = true;     ///< Depth is given to the drawing twice, the second time turned by 90°
    /// DepthOptions::hullMagnification, lengthMagnification and angleMagnification,
    /// kLeastDepthFactor...kMostDepthFactor.
    double depthHull = 1.41;
    double depthLength = 1.2;
    double depthAngle = 1.2;
    double budSpacing = 0.03; ///< Distance along the branch between them, m, 0...kMostBudSpacing
    bool leavesShown = true;
    bool personShown = true;  ///< A person beside the tree, and a scale
    bool fibresShown = false; ///< Wood of strands shows as lines, one for each strand
    bool groundShown = true;
    bool shadowsShown = true;
    bool gridShown = false; ///< Lines on the ground, a metre apart
    Backdrop backdrop = Backdrop::Studio;
    bool isThemeLight = false;            ///< Whether the theme is light; Backdrop::Studio follows it
    QColor backgroundColour{92, 98, 104}; ///< Colour of Plain; of Gradient at the lower edge
    QColor backgroundTop{188, 202, 214};  ///< Colour of Gradient at the upper edge
    TracingImage tracing{};
    /// rad from +Z (front) toward +X (right); of a pinned sun, rad from the camera toward its right.
    double sunAzimuth = radians(58);
    double sunElevation = radians(48); ///< rad above the horizon, kLeastSunElevation...90°
    bool sunPinned = false;            ///< The sun stays at its place on the screen when the tree is turned
    bool sunShown = true;              ///< The sun shows as a ball that can be dragged

    bool operator==(const ViewValues&) const = default;
};

/// The backdrop that is shown: Backdrop::Studio becomes the dark or the light studio.
Backdrop shownBackdrop(const ViewValues& values);
/// Whether the backdrop's lower edge is so light that words over it must be dark.
bool isBackdropLight(const ViewValues& values);

/// The ViewValues in force, shared by the views and the panels.
class ViewSettings : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const ViewValues& values() const { return m_values; }
    /// Values out of range are set to the nearest limit. Emits changed() if a value has changed.
    void setValues(const ViewValues& values);

    /// Sets one value: set(&ViewValues::brushRadius, 0.2).
    template <class T>
    void set(T ViewValues::*field, const std::type_identity_t<T>& value)
    {
        ViewValues values = m_values;
        values.*field = value;
        setValues(values);
    }

Q_SIGNALS:
    void changed();

private:
    ViewValues m_values;
};

} // namespace espalier
