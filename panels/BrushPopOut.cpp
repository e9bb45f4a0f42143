// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BrushPopOut.h"

#include "model/document/Lengths.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QLabel>
#include <QVBoxLayout>

namespace espalier {

BrushPopOut::BrushPopOut(const TreeDocument& document, ViewSettings& settings, QWidget* parent)
    : Bar(parent),
      m_document(document),
      m_settings(settings),
      m_number(new QLabel(this)),
      m_meaning(new QLabel(this)),
      m_slider(new RadiusSlider(kMaxBrushRadius, this)),
      m_pressure(new Toggle(tr("Pressure"), this)),
      m_markers(new Toggle(tr("Markers"), this))
{
    m_number->setAlignment(Qt::AlignCenter);
    m_meaning->setAlignment(Qt::AlignCenter);
    QFont small = m_meaning->font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    m_meaning->setFont(small);
    theme::setTone(*m_meaning, theme::Tone::Dim);
    m_slider->setToolTip(
        tr("<b>Brush radius</b> [ ]<br>A large brush grows a crown into the space it passes; toward zero it "
           "draws a single branch exactly along the stroke."));
    m_pressure->setToolTip(tr("A pen's pressure scales the brush."));
    m_markers->setToolTip(tr("Show the points of free space that the brush spreads and shoots grow toward."));

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 14, 14, 8);
    column->setSpacing(2);
    column->addWidget(m_number);
    column->addWidget(m_meaning);
    column->addSpacing(8);
    column->addWidget(m_slider, 1, Qt::AlignHCenter);
    column->addSpacing(8);
    column->addWidget(m_pressure);
    column->addWidget(m_markers);

    connect(m_slider, &RadiusSlider::radiusEdited, this,
            [this](double metres) { m_settings.set(&ViewValues::brushRadius, metres); });
    connect(m_pressure, &QCheckBox::toggled, this,
            [this](bool on) { m_settings.set(&ViewValues::pressureScales, on); });
    connect(m_markers, &QCheckBox::toggled, this,
            [this](bool on) { m_settings.set(&ViewValues::markersShown, on); });
    connect(&settings, &ViewSettings::changed, this, &BrushPopOut::showValues);
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (!change.delta || change.delta->parametersBefore != change.delta->parametersAfter)
            showValues();
    });
    showValues();
}

void BrushPopOut::showValues()
{
    const ViewValues& values = m_settings.values();
    m_number->setText(lengthText(values.brushRadius));
    const bool draws = values.brushRadius < m_document.parameters().growth.internodeLength;
    m_meaning->setText(draws ? tr("draws a branch") : tr("grows a crown"));
    m_slider->setRadius(values.brushRadius);
    m_pressure->setChecked(values.pressureScales);
    m_markers->setChecked(values.markersShown);
}

} // namespace espalier
