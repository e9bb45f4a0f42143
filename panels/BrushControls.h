// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"

#include <QWidget>

class QLabel;

namespace espalier {

class RadiusSlider;
class ViewRow;

// Controls that the brush's pop-out and its sheet share.

/// The controls for the brush's radius: its number, a text about the effect of that size, and the slider.
class BrushRadius : public QWidget {
    Q_OBJECT

public:
    BrushRadius(const TreeDocument& document, ViewSettings& settings, QWidget* parent = nullptr);

private:
    void showValues();

    const TreeDocument& m_document;
    ViewSettings& m_settings;
    QLabel* m_number;
    QLabel* m_meaning;
    RadiusSlider* m_slider;
};

enum class BrushSwitch {
    Pressure, ///< A pen's pressure scales the radius
    Markers,  ///< The markers of free space that the brush spreads are shown
    Plane,    ///< Hints of the drawing plane are shown
};

/// The choice of the plane that the brush moves in, and the number of strokes around the trunk.
ViewRow* makeBrushPlaneRow(ViewSettings& settings, QWidget* parent);
ViewRow* makeSymmetryRow(ViewSettings& settings, QWidget* parent);

ViewRow* makeBrushSwitch(BrushSwitch which, ViewSettings& settings, QWidget* parent);

} // namespace espalier
