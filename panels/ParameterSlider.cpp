// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterSlider.h"

#include "panels/AccessibleParameter.h"

#include <QSignalBlocker>
#include <QWheelEvent>

#include <cmath>

namespace espalier {

namespace {

constexpr int kSteps = 1000;

QAccessibleInterface* makeAccessibleSlider(const QString&, QObject* object)
{
    auto* slider = qobject_cast<ParameterSlider*>(object);
    if (!slider)
        return nullptr;
    return new AccessibleParameter(slider, {slider->scale(), [slider] { return slider->parameter(); },
                                            [slider](double value) { Q_EMIT slider->edited(value); },
                                            [slider] { return slider->scale().shown(slider->parameter()); }});
}

} // namespace

ParameterSlider::ParameterSlider(const ParameterScale& scale, QWidget* parent)
    : FineSlider(parent), m_scale(scale)
{
    [[maybe_unused]] static const bool isKnown = [] {
        QAccessible::installFactory(makeAccessibleSlider);
        return true;
    }();
    setRange(0, kSteps);
    setPageStep(kSteps / 10);
    setSingleStep(kSteps / 50);
    setAccessibleName(parameterTr(scale.text().label));
    setAccessibleDescription(parameterTr(scale.text().tip));
    connect(this, &QSlider::valueChanged, this, [this](int position) {
        m_shown = m_scale.at(position / static_cast<double>(kSteps));
        Q_EMIT edited(m_shown);
    });
}

double ParameterSlider::parameter() const
{
    return m_shown;
}

void ParameterSlider::show(double value)
{
    const QSignalBlocker quiet(this);
    if (m_scale.at(QSlider::value() / static_cast<double>(kSteps)) != value)
        setValue(static_cast<int>(std::lround(m_scale.placeOf(value) * kSteps)));
    m_shown = value;
}

void ParameterSlider::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        FineSlider::wheelEvent(event);
    else
        event->ignore();
}

} // namespace espalier
