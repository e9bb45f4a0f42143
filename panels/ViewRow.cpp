// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ViewRow.h"

#include "panels/ParameterNumber.h"
#include "panels/ParameterSlider.h"
#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr int kViewRowHeight = theme::kTarget;

QLabel* makeLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    theme::setTone(*label, theme::Tone::Dim);
    return label;
}

} // namespace

ViewRow::ViewRow(const ParameterScale& scale, QWidget* parent) : QWidget(parent), m_scale(scale)
{
    const QString label = parameterTr(scale.text().label);
    setObjectName(QString::fromLatin1(key()));
    setAccessibleName(label);
    setToolTip(QStringLiteral("<b>%1</b><br>%2")
                   .arg(label.toHtmlEscaped(), parameterTr(scale.text().tip).toHtmlEscaped()));
    setFixedHeight(kViewRowHeight);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    column->addLayout(line);
    switch (scale.info().quantity) {
    case Quantity::Switch:
        m_switch = new Toggle(label, this);
        line->addWidget(m_switch);
        connect(m_switch, &QCheckBox::toggled, this, [this](bool on) { edit(on ? 1.0 : 0.0); });
        break;
    case Quantity::Choice:
        m_choice = new QComboBox(this);
        m_choice->addItems(choiceNames(scale.info().choices));
        m_choice->setAccessibleName(label);
        line->addWidget(makeLabel(label, this), 1);
        m_choice->setFixedHeight(kViewRowHeight);
        line->addWidget(m_choice);
        connect(m_choice, &QComboBox::activated, this, [this](int index) { edit(index); });
        break;
    default:
        m_number = new ParameterNumber(scale, this);
        m_slider = new ParameterSlider(scale, this);
        m_slider->setFixedHeight(20);
        // A key changes a number of things by one at least.
        if (scale.info().quantity == Quantity::Count)
            m_slider->setSingleStep(std::max(
                m_slider->singleStep(), static_cast<int>(std::ceil(scale.placeOf(scale.info().minimum + 1.0) *
                                                                   m_slider->maximum()))));
        line->addWidget(makeLabel(label, this), 1);
        line->addWidget(m_number);
        column->addWidget(m_slider);
        m_slider->installEventFilter(this);
        connect(m_slider, &ParameterSlider::edited, this, &ViewRow::edit);
        connect(m_number, &ParameterNumber::edited, this, &ViewRow::edit);
    }
}

bool ViewRow::eventFilter(QObject* watched, QEvent* event)
{
    const bool isDelete =
        event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Delete;
    if (m_usual && (isDelete || event->type() == QEvent::MouseButtonDblClick)) {
        m_isTakenBack = !isDelete;
        edit(*m_usual);
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress)
        m_isTakenBack = false;
    return (event->type() == QEvent::MouseMove && m_isTakenBack) || QWidget::eventFilter(watched, event);
}

void ViewRow::edit(double value)
{
    setValue(value);
    Q_EMIT edited(value);
}

void ViewRow::setValue(double value)
{
    m_value = value;
    if (m_slider) {
        m_slider->show(value);
        m_number->show(value);
    } else if (m_switch) {
        const QSignalBlocker quiet(m_switch);
        m_switch->setChecked(value != 0.0);
    } else {
        m_choice->setCurrentIndex(static_cast<int>(value));
    }
}

} // namespace espalier
