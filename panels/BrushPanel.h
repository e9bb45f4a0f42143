// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"
#include "panels/Bar.h"
#include "panels/ParameterEditor.h"

#include <string_view>
#include <vector>

class QVBoxLayout;

namespace espalier {

class ParameterRow;
class PressureCurve;

/// The sheet of the brush: its size, the effect of a pen's pressure, the markers of free space that it
/// spreads, and what shows of it. Parameters of the tree (the markers) are undone; settings of the view are
/// not.
class BrushPanel : public Bar {
    Q_OBJECT

public:
    /// The exponent of the pressure curve stays within @p softest and @p firmest.
    BrushPanel(TreeDocument& document, ViewSettings& settings, double softest, double firmest,
               QWidget* parent = nullptr);

    /// The row of a parameter, or null if this sheet has none.
    ParameterRow* row(std::string_view key) const;
    /// Shows the exponent; no signal.
    void setPressureExponent(double exponent);
    /// Whether the tree's parameters can be changed now; settings of the view can be changed at any time.
    void setParametersEnabled(bool enabled);

Q_SIGNALS:
    /// The user has changed the exponent.
    void pressureExponentEdited(double exponent);

private:
    ParameterEditor m_editor;
    QWidget* m_content;
    PressureCurve* m_curve;
    std::vector<ParameterRow*> m_rows;
};

} // namespace espalier
