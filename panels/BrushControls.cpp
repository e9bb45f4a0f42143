// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BrushControls.h"

#include "model/settings/Lengths.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"
#include "panels/ViewField.h"
#include "panels/ViewRow.h"

#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>
#include <array>

namespace espalier {

namespace {

// In the order of BrushSwitch
constexpr std::array kSwitches{
    viewSwitch<&ViewValues::pressureScales>(
        "view.pressureScales", QT_TRANSLATE_NOOP("Parameters", "Pressure"),
        QT_TRANSLATE_NOOP("Parameters",
                          "A pen's pressure scales the brush: the radius is what a firm hand reaches.")),
    viewSwitch<&ViewValues::markersShown>(
        "view.markersShown", QT_TRANSLATE_NOOP("Parameters", "Markers"),
        QT_TRANSLATE_NOOP(
            "Parameters",
            "Show the points of free space that the brush spreads, and that shoots grow towards.")),
    viewSwitch<&ViewValues::planeShown>(
        "view.planeShown", QT_TRANSLATE_NOOP("Parameters", "Drawing plane"),
        QT_TRANSLATE_NOOP("Parameters",
                          "Show how deep in the tree the brush draws: a faint grid around it.")),
};

/// The radius at the upper end of the slider, in internodes; and the least one, m.
constexpr double kMostInInternodes = 50.0;
constexpr double kLeastRange = 0.2;

constexpr ViewField kBrushPlane{
    {"view.brushPlane", Quantity::Choice, 0, kBrushPlaneCount - 1, "screen trunk spread"},
    {"view.brushPlane", QT_TRANSLATE_NOOP("Parameters", "Plane"), "",
     QT_TRANSLATE_NOOP(
         "Parameters",
         "Where strokes go in depth. Screen: as deep as the branch that they begin at. Trunk: in the "
         "plane through the trunk and the branch that they begin at. Spread: each limb that begins at the "
         "trunk is turned into the widest gap, as long and as steep as you draw it.")},
    [](const ViewValues& values) { return static_cast<double>(values.brushPlane); },
    [](ViewValues& values, double value) {
        values.brushPlane = static_cast<BrushPlane>(static_cast<int>(value));
    }};

constexpr ViewField kBrushSymmetry{
    {"view.brushSymmetry", Quantity::Count, 1, kMostSymmetry},
    {"view.brushSymmetry", QT_TRANSLATE_NOOP("Parameters", "Around"), "",
     QT_TRANSLATE_NOOP("Parameters",
                       "How many strokes are made around the trunk for each one that you draw."),
     ParameterText::Scale::Linear, 0},
    [](const ViewValues& values) { return values.brushSymmetry; },
    [](ViewValues& values, double value) { values.brushSymmetry = value; }};

// The names for choiceNames()
[[maybe_unused]] constexpr const char* kPlaneNames[] = {QT_TRANSLATE_NOOP("Parameters", "screen"),
                                                        QT_TRANSLATE_NOOP("Parameters", "trunk"),
                                                        QT_TRANSLATE_NOOP("Parameters", "spread")};

} // namespace

BrushRadius::BrushRadius(const TreeDocument& document, ViewSettings& settings, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_settings(settings),
      m_number(new QLabel(this)),
      m_meaning(new QLabel(this)),
      m_slider(new RadiusSlider(kMaxBrushRadius, this))
{
    m_number->setAlignment(Qt::AlignCenter);
    m_meaning->setAlignment(Qt::AlignCenter);
    QFont small = m_meaning->font();
    small.setPointSizeF(small.pointSizeF() * 0.88);
    m_meaning->setFont(small);
    theme::setTone(*m_meaning, theme::Tone::Dim);
    m_slider->setToolTip(tr("<b>Brush radius</b> [ ]<br>A large brush grows a crown into the space it "
                            "passes; towards zero it draws a single branch exactly along the stroke."));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_number);
    column->addWidget(m_meaning);
    column->addSpacing(8);
    column->addWidget(m_slider, 1, Qt::AlignHCenter);

    connect(m_slider, &RadiusSlider::radiusEdited, this,
            [this](double metres) { m_settings.set(&ViewValues::brushRadius, metres); });
    connect(&settings, &ViewSettings::changed, this, &BrushRadius::showValues);
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (!change.delta || change.delta->parametersBefore != change.delta->parametersAfter)
            showValues();
    });
    showValues();
}

void BrushRadius::showValues()
{
    const double radius = m_settings.values().brushRadius;
    m_number->setText(lengthText(radius));
    // A small tree needs a fine scale, a large one a large brush.
    const double internode = m_document.parameters().growth.internodeLength;
    m_slider->setMaximumRadius(std::clamp(kMostInInternodes * internode, kLeastRange, kMaxBrushRadius));
    const bool draws = radius < m_document.parameters().growth.internodeLength;
    m_meaning->setText(draws ? tr("draws a branch") : tr("grows a crown"));
    m_slider->setRadius(radius);
}

ViewRow* makeBrushPlaneRow(ViewSettings& settings, QWidget* parent)
{
    return makeViewRow(kBrushPlane, settings, parent);
}

ViewRow* makeSymmetryRow(ViewSettings& settings, QWidget* parent)
{
    return makeViewRow(kBrushSymmetry, settings, parent);
}

ViewRow* makeBrushSwitch(BrushSwitch which, ViewSettings& settings, QWidget* parent)
{
    return makeViewRow(kSwitches[static_cast<std::size_t>(which)], settings, parent);
}

} // namespace espalier
