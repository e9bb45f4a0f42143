// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BendPopOut.h"

#include "model/settings/Lengths.h"
#include "panels/FineSlider.h"
#include "panels/Theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <cmath>

namespace espalier {

namespace {

/// Steps of a slider from its middle to either end.
constexpr int kWeightSteps = 100;
constexpr int kWidth = 132;

double weightAt(int position)
{
    return std::pow(kMostBendWeight, static_cast<double>(position) / kWeightSteps);
}

int positionOf(double weight)
{
    return static_cast<int>(std::lround(kWeightSteps * std::log(weight) / std::log(kMostBendWeight)));
}

static_assert(kLeastBendWeight * kMostBendWeight == 1.0, "the middle of a slider is 1");

} // namespace

BendPopOut::BendPopOut(ViewSettings& settings, QWidget* parent) : Bar(parent), m_settings(settings)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(14, 12, 14, 10);
    column->setSpacing(2);
    m_bending =
        addSlider(QStringLiteral("bendingWeight"), tr("Stiffness"),
                  tr("<b>Stiffness</b><br>How much a branch resists being bent: a stiff one bends in a "
                     "wide curve and is stretched sooner."),
                  &ViewValues::bendingWeight);
    m_stretching = addSlider(QStringLiteral("stretchingWeight"), tr("Holds length"),
                             tr("<b>Holds length</b><br>How much a branch resists being stretched: at low "
                                "values it follows the hand further."),
                             &ViewValues::stretchingWeight);
    connect(&settings, &ViewSettings::changed, this, &BendPopOut::showValues);
    showValues();
}

QSlider* BendPopOut::addSlider(const QString& name, const QString& label, const QString& toolTip,
                               double ViewValues::*weight)
{
    auto* text = new QLabel(label, this);
    auto* value = new QLabel(this);
    theme::setTone(*value, theme::Tone::Dim);
    value->setObjectName(name + QStringLiteral("Value"));
    auto* slider = new FineSlider(this);
    for (QLabel* words : {text, value})
        words->setToolTip(toolTip);
    slider->setObjectName(name);
    slider->setRange(-kWeightSteps, kWeightSteps);
    slider->setSingleStep(kWeightSteps / 20);
    slider->setPageStep(kWeightSteps / 4);
    slider->setFixedWidth(kWidth);
    slider->setMinimumHeight(theme::kTarget);
    slider->setFocusPolicy(Qt::TabFocus);
    slider->setAccessibleName(label);
    slider->setToolTip(toolTip);
    auto* line = new QHBoxLayout;
    line->addWidget(text, 1);
    line->addWidget(value);
    static_cast<QVBoxLayout*>(layout())->addLayout(line);
    layout()->addWidget(slider);
    const auto showValue = [this, value, weight] {
        value->setText(tr("× %1").arg(numberText(m_settings.values().*weight, 2)));
    };
    connect(&m_settings, &ViewSettings::changed, value, showValue);
    showValue();
    connect(slider, &QSlider::valueChanged, this,
            [this, weight](int position) { m_settings.set(weight, weightAt(position)); });
    return slider;
}

void BendPopOut::showValues()
{
    const ViewValues& values = m_settings.values();
    const QSignalBlocker quietBending(m_bending);
    const QSignalBlocker quietStretching(m_stretching);
    m_bending->setValue(positionOf(values.bendingWeight));
    m_stretching->setValue(positionOf(values.stretchingWeight));
}

} // namespace espalier
