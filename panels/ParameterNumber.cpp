// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterNumber.h"

#include "model/settings/Lengths.h"

#include <QKeyEvent>
#include <QSignalBlocker>
#include <QTimer>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {
/// Decimals of a length: a value that was typed in another unit keeps its exact value.
constexpr int kKeptDecimals = 9;
} // namespace

ParameterNumber::ParameterNumber(const ParameterScale& scale, QWidget* parent)
    : QDoubleSpinBox(parent), m_scale(scale), m_factor(scale.text().factor)
{
    const ParameterText& text = scale.text();
    setProperty("bare", true);
    setButtonSymbols(QAbstractSpinBox::NoButtons);
    setFrame(false);
    setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    setDecimals(scale.info().quantity == Quantity::Metres ? kKeptDecimals : text.decimals);
    setRange(scale.info().minimum * m_factor, scale.info().maximum * m_factor);
    setSingleStep(std::pow(10.0, -text.decimals));
    setStepType(text.scale == ParameterText::Scale::Linear ? QAbstractSpinBox::DefaultStepType
                                                           : QAbstractSpinBox::AdaptiveDecimalStepType);
    setSpecialValueText(*text.least == '\0' ? QString() : parameterTr(text.least));
    setSuffix(scale.suffix());
    setKeyboardTracking(false);
    setAccessibleName(parameterTr(text.label));
    int widest = fontMetrics().horizontalAdvance(specialValueText());
    for (const double limit : {minimum(), maximum()})
        widest = std::max(widest, fontMetrics().horizontalAdvance(textFromValue(limit) + suffix()));
    setFixedWidth(widest + 6);
    connect(this, &QDoubleSpinBox::valueChanged, this,
            [this](double shown) { Q_EMIT edited(shown / m_factor); });
}

void ParameterNumber::show(double value)
{
    const QSignalBlocker quiet(this);
    setValue(value * m_factor);
}

QString ParameterNumber::textFromValue(double value) const
{
    return numberText(value, m_scale.text().decimals);
}

double ParameterNumber::valueFromText(const QString& text) const
{
    // The shown number has fewer digits than the value.
    if (text == textFromValue(value()) + suffix() || text == specialValueText())
        return value();
    const std::optional<double> typed = m_scale.typed(text);
    return typed ? *typed * m_factor : value();
}

QValidator::State ParameterNumber::validate(QString& text, int&) const
{
    return m_scale.typed(text) ? QValidator::Acceptable : QValidator::Intermediate;
}

void ParameterNumber::stepBy(int steps)
{
    if (m_scale.info().quantity != Quantity::Metres) {
        QDoubleSpinBox::stepBy(steps);
        return;
    }
    double stepped = value() / m_factor;
    for (int i = 0; i < std::abs(steps); ++i)
        stepped = m_scale.stepped(stepped, steps, ParameterScale::Stride::Normal);
    setValue(stepped * m_factor);
    selectAll();
}

void ParameterNumber::focusInEvent(QFocusEvent* event)
{
    QDoubleSpinBox::focusInEvent(event);
    // Later, because the press that gave the focus also moves the cursor.
    QTimer::singleShot(0, this, &QDoubleSpinBox::selectAll);
}

bool ParameterNumber::event(QEvent* event)
{
    // Escape restores the number, before it has any other meaning.
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape &&
        text() != textFromValue(value()) + suffix()) {
        event->accept();
        return true;
    }
    return QDoubleSpinBox::event(event);
}

void ParameterNumber::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        show(value() / m_factor);
        selectAll();
        return;
    }
    QDoubleSpinBox::keyPressEvent(event);
}

void ParameterNumber::wheelEvent(QWheelEvent* event)
{
    if (hasFocus())
        QDoubleSpinBox::wheelEvent(event);
    else
        event->ignore();
}

} // namespace espalier
