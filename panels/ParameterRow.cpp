// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterRow.h"

#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <cmath>

namespace espalier {

namespace {

constexpr int kSliderSteps = 1000;
constexpr int kRowHeight = 42;

/// Takes the wheel only while it has the focus: a panel is scrolled past it.
template <class Base>
class Patient : public Base {
public:
    using Base::Base;

protected:
    void wheelEvent(QWheelEvent* event) override
    {
        if (this->hasFocus())
            Base::wheelEvent(event);
        else
            event->ignore();
    }
};

} // namespace

ParameterRow::ParameterRow(const ParameterInfo& info, const ParameterText& text, QWidget* parent)
    : QWidget(parent), m_info(info), m_text(text)
{
    setObjectName(QString::fromLatin1(info.key));
    setAccessibleName(parameterTr(text.label));
    m_rest.setSingleShot(true);
    m_rest.setInterval(600);
    connect(&m_rest, &QTimer::timeout, this, &ParameterRow::gestureEnded);
    switch (info.quantity) {
    case Quantity::Switch:
        makeSwitch();
        break;
    case Quantity::Choice:
        makeChoice();
        break;
    default:
        makeSlider();
    }
    setToolTip(toolTipText());
}

QString ParameterRow::labelText() const
{
    QString symbol = QString::fromUtf8(m_text.symbol);
    if (const auto underscore = symbol.indexOf(QLatin1Char('_')); underscore > 0)
        symbol = QStringLiteral("%1<sub>%2</sub>").arg(symbol.left(underscore), symbol.mid(underscore + 1));
    const QString label = parameterTr(m_text.label).toHtmlEscaped();
    if (symbol.isEmpty())
        return label;
    return QStringLiteral("%1 <span style='color:%2'>%3</span>").arg(label, theme::kFaintText.name(), symbol);
}

QString ParameterRow::toolTipText() const
{
    // Rich text wraps.
    return QStringLiteral("<b>%1</b><br>%2").arg(labelText(), parameterTr(m_text.tip).toHtmlEscaped());
}

QLabel* ParameterRow::makeLabel()
{
    auto* label = new QLabel(labelText(), this);
    label->setTextFormat(Qt::RichText);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    QPalette dim = label->palette();
    // Rich text is drawn in the colour of Text while the label is disabled; it shall not flicker when a panel
    // rests during a stroke.
    for (const QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text})
        dim.setColor(role, theme::kDimText);
    label->setPalette(dim);
    return label;
}

bool ParameterRow::event(QEvent* event)
{
    // The whole row drags the slider: its handle alone is small for a finger.
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        // What the slider does not want comes back here.
        if (m_slider && !m_isPassingOn) {
            const QScopedValueRollback passing(m_isPassingOn, true);
            const auto* mouse = static_cast<QMouseEvent*>(event);
            const QPointF place(mouse->position().x() - m_slider->x(), m_slider->height() / 2.0);
            QMouseEvent passedOn(mouse->type(), place, mouse->globalPosition(), mouse->button(),
                                 mouse->buttons(), mouse->modifiers());
            QCoreApplication::sendEvent(m_slider, &passedOn);
            event->accept();
            return true;
        }
        break;
    default:
        break;
    }
    return QWidget::event(event);
}

void ParameterRow::makeSlider()
{
    QLabel* label = makeLabel();

    m_number = new Patient<QDoubleSpinBox>(this);
    m_number->setProperty("bare", true);
    m_number->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_number->setFrame(false);
    m_number->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_number->setDecimals(m_text.decimals);
    m_number->setRange(m_info.minimum * m_text.factor, m_info.maximum * m_text.factor);
    m_number->setSingleStep(std::pow(10.0, -m_text.decimals));
    m_number->setStepType(m_text.scale == ParameterText::Scale::Linear
                              ? QAbstractSpinBox::DefaultStepType
                              : QAbstractSpinBox::AdaptiveDecimalStepType);
    const QString unit = QString::fromUtf8(m_text.unit);
    m_number->setSpecialValueText(*m_text.least == '\0' ? QString() : parameterTr(m_text.least));
    m_number->setSuffix(unit == QStringLiteral("°") || unit.isEmpty() ? unit : QLatin1Char(' ') + unit);
    m_number->setKeyboardTracking(false);
    m_number->setAccessibleName(parameterTr(m_text.label));
    m_number->setFixedWidth(m_number->fontMetrics().horizontalAdvance(QStringLiteral("00000.0 cm")));

    m_slider = new Patient<QSlider>(Qt::Horizontal, this);
    m_slider->setRange(0, kSliderSteps);
    m_slider->setPageStep(kSliderSteps / 20);
    m_slider->setSingleStep(kSliderSteps / 200);
    m_slider->setAccessibleName(parameterTr(m_text.label));
    m_slider->setFixedHeight(20);

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    line->addWidget(label, 1);
    line->addWidget(m_number);
    column->addLayout(line);
    column->addWidget(m_slider);
    setFixedHeight(kRowHeight);

    connect(m_slider, &QSlider::sliderPressed, this, [this] { m_dragging = true; });
    connect(m_slider, &QSlider::valueChanged, this, [this](int position) { edit(valueAt(position)); });
    connect(m_slider, &QSlider::sliderReleased, this, [this] {
        m_dragging = false;
        m_rest.stop();
        Q_EMIT gestureEnded();
    });
    connect(m_number, &QDoubleSpinBox::valueChanged, this,
            [this](double shown) { edit(shown / m_text.factor); });
}

void ParameterRow::makeSwitch()
{
    m_switch = new Toggle(parameterTr(m_text.label), this);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_switch);
    setFixedHeight(kRowHeight);
    connect(m_switch, &QCheckBox::toggled, this, [this](bool on) {
        m_value = on ? 1.0 : 0.0;
        Q_EMIT edited(m_value);
        Q_EMIT gestureEnded();
    });
}

void ParameterRow::makeChoice()
{
    QLabel* label = makeLabel();
    m_choice = new Patient<QComboBox>(this);
    m_choice->addItems(choiceNames(m_info.choices));
    m_choice->setAccessibleName(parameterTr(m_text.label));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(label, 1);
    line->addWidget(m_choice);
    setFixedHeight(kRowHeight);
    connect(m_choice, &QComboBox::activated, this, [this](int index) {
        m_value = index;
        Q_EMIT edited(m_value);
        Q_EMIT gestureEnded();
    });
}

void ParameterRow::setValue(double value)
{
    m_rest.stop();
    m_value = value;
    present(value);
}

void ParameterRow::present(double value)
{
    if (m_slider) {
        const QSignalBlocker quietSlider(m_slider);
        const QSignalBlocker quietNumber(m_number);
        if (valueAt(m_slider->value()) != value)
            m_slider->setValue(positionOf(value));
        m_number->setValue(value * m_text.factor);
    } else if (m_switch) {
        const QSignalBlocker quiet(m_switch);
        m_switch->setChecked(value != 0.0);
    } else {
        m_choice->setCurrentIndex(static_cast<int>(value));
    }
}

void ParameterRow::edit(double value)
{
    if (value == m_value)
        return;
    m_value = value;
    present(value);
    Q_EMIT edited(value);
    if (!m_dragging)
        m_rest.start();
}

double ParameterRow::valueAt(int position) const
{
    using enum ParameterText::Scale;
    const double t = position / static_cast<double>(kSliderSteps);
    const double low = m_info.minimum;
    const double high = m_info.maximum;
    double value = low + t * (high - low);
    if (m_text.scale == Logarithmic)
        value = low * std::pow(high / low, t);
    else if (m_text.scale == Cubic)
        value = low + t * t * t * (high - low);
    // What is shown is what is meant: no digits beyond those.
    const double grain = std::pow(10.0, m_text.decimals) * m_text.factor;
    return std::clamp(std::round(value * grain) / grain, low, high);
}

int ParameterRow::positionOf(double value) const
{
    using enum ParameterText::Scale;
    const double low = m_info.minimum;
    const double high = m_info.maximum;
    double t = (value - low) / (high - low);
    if (m_text.scale == Logarithmic)
        t = std::log(value / low) / std::log(high / low);
    else if (m_text.scale == Cubic)
        t = std::cbrt(t);
    return static_cast<int>(std::lround(std::clamp(t, 0.0, 1.0) * kSliderSteps));
}

} // namespace espalier
