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

/// All about the brush: its size, what a pen's pressure does, the room that it spreads for growth, and what
/// is shown of it. What is the tree's (the room) is undone; what is the hand's is not.
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
    /// Whether the tree's parameters may be changed now; what is the hand's may be at any time.
    void setParametersEnabled(bool enabled);

Q_SIGNALS:
    /// By a person's hand.
    void pressureExponentEdited(double exponent);

private:
    ParameterEditor m_editor;
    QWidget* m_content;
    PressureCurve* m_curve;
    std::vector<ParameterRow*> m_rows;
};

} // namespace espalier
