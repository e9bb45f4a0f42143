// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <QObject>

#include <type_traits>

namespace espalier {

/// Largest radius of the brush, m.
inline constexpr double kMaxBrushRadius = 5.0;

/// Limits of the weights of bending and stretching.
inline constexpr double kLeastBendWeight = 0.01;
inline constexpr double kMostBendWeight = 100.0;

/// The next larger (@p notches > 0) or smaller radius, as a wheel or the keys [ and ] step through them: by
/// a tenth a notch, down to an axis and up again from it.
double steppedBrushRadius(double radius, double notches);

/// What stands behind the tree.
enum class Backdrop : int {
    Studio,  ///< Dark, lighter behind the tree
    Horizon, ///< An overcast sky over a light ground
};

/// How the tree is shown and what the hand holds; belongs to the person who works, not to the tree, so it
/// is no part of the document and nothing of it is undone.
struct ViewValues {
    double brushRadius = 0.5;   ///< m, 0...kMaxBrushRadius; 0 draws a single axis
    bool pressureScales = true; ///< A pen's pressure scales the radius of the brush
    bool markersShown = true;   ///< Markers of free space while brushing
    bool envelopeShown = true;  ///< What lassos enclose, while the lasso is in hand
    bool planeShown = true;     ///< Hints of where the drawing plane is
    double bendingWeight =
        1.0; ///< Resistance of branches against bending, kLeastBendWeight...kMostBendWeight
    double stretchingWeight = 1.0; ///< Likewise, against stretching
    bool leavesShown = true;
    bool groundShown = true;
    bool shadowsShown = true;
    Backdrop backdrop = Backdrop::Studio;
    double sunAzimuth = radians(58);   ///< rad from +Z (front) toward +X (right)
    double sunElevation = radians(48); ///< rad above the horizon, 5°...90°

    bool operator==(const ViewValues&) const = default;
};

/// The ViewValues in force, shared by the views and the panels.
class ViewSettings : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    const ViewValues& values() const { return m_values; }
    /// Values out of range are moved to its nearest end. Emits changed() if anything differs.
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
