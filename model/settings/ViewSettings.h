// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/scene/SceneLook.h"

#include <QObject>

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

/// Limits of the wood that the eraser and the thinning brush take, as a share of the trunk's diameter, and of
/// the share of the twigs that thinning takes.
inline constexpr double kLeastThickest = 0.01;
inline constexpr double kLeastThinShare = 0.05;

/// Most copies of a stroke around the trunk, with the stroke itself.
inline constexpr double kMostSymmetry = 12;

/// What the tool for pruning does.
enum class PruneMode : int {
    Cut,       ///< Takes off the branches that are tapped or crossed
    KeepClear, ///< Keeps the lower part of a trunk or a branch clear of shoots
    Erase,     ///< Takes twigs and leaves under a brush
    Thin,      ///< Takes a share of the twigs under a brush
};
inline constexpr int kPruneModeCount = 4;

/// The plane that the brush moves in.
enum class BrushPlane : int {
    Screen, ///< Parallel to the screen, through the place where the stroke begins
    Trunk,  ///< Through the axis of the trunk and that place
    Spread, ///< Parallel to the screen; a limb that begins at the trunk is then turned to the widest gap
};
inline constexpr int kBrushPlaneCount = 3;

/// The next larger (@p notches > 0) or smaller radius, for the wheel and the keys [ and ]: a notch changes it
/// by a tenth, down to the radius 0 of a single axis and up again from it.
double steppedBrushRadius(double radius, double notches);

/// How the tree is shown and how the brush is set. Apart from the look of the scene, which is the document's,
/// this belongs to the user; none of it is undone.
struct ViewValues : SceneLook {
    double brushRadius = 0.5;   ///< m, 0...kMaxBrushRadius; 0 draws a single axis
    bool pressureScales = true; ///< A pen's pressure scales the radius of the brush
    bool markersShown = true;   ///< Markers of free space show while brushing
    bool envelopeShown = true;  ///< The envelopes of lassos show while the lasso is the current tool
    bool planeShown = true;     ///< Hints of the drawing plane show
    BrushPlane brushPlane = BrushPlane::Screen;
    double brushSymmetry = 1; ///< Strokes around the trunk for each one drawn, whole, 1...kMostSymmetry
    PruneMode pruneMode = PruneMode::Cut;
    bool prunesThrough = true; ///< Strokes of pruning reach the far side of the trunk as well
    /// Thickest wood that the eraser and thinning take, a share of the trunk's diameter, kLeastThickest...1.
    double eraserThickest = 0.15;
    double thinShare = 0.3; ///< Of the twigs, kLeastThinShare...1
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
    bool personShown = true;      ///< A person beside the tree, and a scale
    bool secondViewShown = false; ///< A second view, from the side
    bool fibresShown = false;     ///< Wood of strands shows as lines, one for each strand
    bool isThemeLight = false;    ///< Whether the theme is light; Backdrop::Studio follows it

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
    /// Shows the scene with this look, which comes from elsewhere: another document's. Emits lookReplaced()
    /// and changed() if it differs from the one in force.
    void setLook(const SceneLook& look);

    /// Sets one value: set(&ViewValues::brushRadius, 0.2).
    template <class T>
    void set(T ViewValues::*field, const std::type_identity_t<T>& value)
    {
        ViewValues values = m_values;
        values.*field = value;
        setValues(values);
    }
    template <class T>
    void set(T SceneLook::*field, const std::type_identity_t<T>& value)
    {
        set(static_cast<T ViewValues::*>(field), value);
    }

Q_SIGNALS:
    void changed();
    /// setLook() has put another look in force; changed() follows.
    void lookReplaced();

private:
    ViewValues m_values;
};

} // namespace espalier
