// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BrushPanel.h"

#include "panels/BrushControls.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterTexts.h"
#include "panels/PressureCurve.h"
#include "panels/Sideways.h"
#include "panels/ViewRow.h"

#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace espalier {

namespace {

// px
constexpr int kSizeWidth = 128;
constexpr int kPenWidth = 210;
constexpr int kBrushColumnWidth = 196;
constexpr int kShownWidth = 156;
constexpr int kRadiusHeight = 200;
constexpr int kCurveHeight = 150;

} // namespace

BrushPanel::BrushPanel(TreeDocument& document, ViewSettings& settings, double softest, double firmest,
                       QWidget* parent)
    : Bar(parent),
      m_editor(document),
      m_content(new QWidget),
      m_curve(new PressureCurve(softest, firmest, m_content))
{
    setAccessibleName(tr("Brush"));
    auto* columns = new QHBoxLayout(m_content);
    columns->setContentsMargins(20, 14, 20, 12);
    columns->setSpacing(18);

    QVBoxLayout* size = addBarColumn(*m_content, tr("Size"), kSizeWidth);
    auto* radius = new BrushRadius(document, settings, m_content);
    radius->setMaximumHeight(kRadiusHeight);
    size->addWidget(radius, 1);
    size->addStretch();

    QVBoxLayout* pen = addBarColumn(*m_content, tr("Pen"), kPenWidth);
    pen->addWidget(makeBrushSwitch(BrushSwitch::Pressure, settings, m_content));
    m_curve->setFixedSize(kPenWidth, kCurveHeight);
    m_curve->setToolTip(tr("<b>Pressure curve</b><br>How firmly the pen must press for the full radius. Drag "
                           "the curve, or press here with your pen to try it."));
    pen->addWidget(m_curve);
    pen->addStretch();
    connect(m_curve, &PressureCurve::exponentEdited, this, &BrushPanel::pressureExponentEdited);

    for (const ParameterSection& section : parameterSections()) {
        if (section.sheet != ParameterSheet::Brush)
            continue;
        QVBoxLayout* column = addBarColumn(*m_content, parameterTr(section.title), kBrushColumnWidth);
        for (const ParameterText& text : section.parameters) {
            m_rows.push_back(new ParameterRow(m_editor, text, m_content));
            column->addWidget(m_rows.back());
        }
        column->addStretch();
    }

    QVBoxLayout* depth = addBarColumn(*m_content, tr("Depth"), kShownWidth);
    depth->addWidget(makeBrushPlaneRow(settings, m_content));
    depth->addWidget(makeSymmetryRow(settings, m_content));
    depth->addStretch();

    QVBoxLayout* shown = addBarColumn(*m_content, tr("Shown"), kShownWidth);
    for (const BrushSwitch which : {BrushSwitch::Markers, BrushSwitch::Plane})
        shown->addWidget(makeBrushSwitch(which, settings, m_content));
    shown->addStretch();

    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(1, 1, 1, 1);
    whole->addWidget(new Sideways(m_content, this));
}

ParameterRow* BrushPanel::row(std::string_view key) const
{
    const auto found =
        std::ranges::find_if(m_rows, [&](const ParameterRow* row) { return key == row->key(); });
    return found == m_rows.end() ? nullptr : *found;
}

void BrushPanel::setPressureExponent(double exponent)
{
    m_curve->setExponent(exponent);
}

void BrushPanel::setParametersEnabled(bool enabled)
{
    for (ParameterRow* row : m_rows)
        row->setEnabled(enabled);
}

} // namespace espalier
