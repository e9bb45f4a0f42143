// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterRow.h"

#include "panels/LookChoice.h"
#include "panels/ParameterEditor.h"
#include "panels/ParameterNumber.h"
#include "panels/ParameterSlider.h"
#include "panels/Theme.h"
#include "panels/Toggle.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <cstring>
#include <utility>

namespace espalier {

namespace {

constexpr int kRowHeight = theme::kTarget;

/// Uses the wheel only while it has the focus, so that the wheel scrolls the panel.
class PatientChoice : public QComboBox {
public:
    using QComboBox::QComboBox;

protected:
    void wheelEvent(QWheelEvent* event) override
    {
        if (hasFocus())
            QComboBox::wheelEvent(event);
        else
            event->ignore();
    }
};

/// Whether existing wood shows a change of that parameter at once.
bool showsAtOnce(const char* key)
{
    return std::strncmp(key, "growth.", 7) != 0;
}

} // namespace

ParameterRow::ParameterRow(ParameterEditor& editor, const ParameterText& text, QWidget* parent)
    : QWidget(parent), m_editor(editor), m_scale(ParameterScale::of(text.key))
{
    setObjectName(QString::fromLatin1(text.key));
    setAccessibleName(parameterTr(text.label));
    setAccessibleDescription(parameterTr(text.tip));
    setToolTip(explanation(text));
    setWhatsThis(toolTip());
    switch (m_scale.info().quantity) {
    case Quantity::Switch:
        makeSwitch();
        break;
    case Quantity::Choice:
        makeChoice();
        break;
    default:
        makeSlider();
    }
    m_value = m_editor.value(text.key);
    present();
    connect(&editor, &ParameterEditor::shownChanged, this, &ParameterRow::follow);
    connect(&editor, &ParameterEditor::overtaken, this,
            [this] { m_isTakenBack = std::exchange(m_isDragging, false); });
}

QLabel* ParameterRow::makeLabel()
{
    auto* label = new QLabel(richLabel(m_scale.text()), this);
    label->setTextFormat(Qt::RichText);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
    theme::setTone(*label, theme::Tone::Dim);
    return label;
}

bool ParameterRow::event(QEvent* event)
{
    // The whole row drags the slider, because its handle is small for a finger.
    switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::MouseButtonRelease:
        // Events that the slider does not use come back here.
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
    m_number = new ParameterNumber(m_scale, this);

    m_slider = new ParameterSlider(m_scale, this);
    m_slider->setFixedHeight(20);
    m_slider->installEventFilter(this);

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

    connect(m_slider, &ParameterSlider::edited, this, &ParameterRow::edit);
    connect(m_slider, &QSlider::sliderReleased, this, [this] {
        if (std::exchange(m_isDragging, false))
            m_editor.finish(undoText(m_value));
    });
    connect(m_number, &ParameterNumber::edited, this, &ParameterRow::edit);
}

void ParameterRow::makeSwitch()
{
    m_switch = new Toggle(parameterTr(m_scale.text().label), this);
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(m_switch);
    setFixedHeight(kRowHeight);
    connect(m_switch, &QCheckBox::toggled, this, [this](bool on) { choose(on ? 1.0 : 0.0); });
}

void ParameterRow::makeChoice()
{
    QLabel* label = makeLabel();
    const QStringList names = choiceNames(m_scale.info().choices);
    if (const std::optional<LookKind> kind = LookChoice::kindOf(key())) {
        m_choice = m_look = new LookChoice(*kind, names, this);
        connect(m_look, &LookChoice::drawnChosen, this, &ParameterRow::chooseDrawn);
    } else {
        m_choice = new PatientChoice(this);
        m_choice->addItems(names);
        connect(m_choice, &QComboBox::activated, this, [this](int index) { choose(index); });
    }
    m_choice->setAccessibleName(parameterTr(m_scale.text().label));
    auto* line = new QHBoxLayout(this);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(label, 1);
    m_choice->setFixedHeight(kRowHeight);
    line->addWidget(m_choice);
    setFixedHeight(kRowHeight);
}

void ParameterRow::follow()
{
    const double value = m_editor.value(key());
    if (value == m_value && !m_look)
        return;
    m_value = value;
    present();
}

void ParameterRow::present()
{
    if (m_slider) {
        m_slider->show(m_value);
        m_number->show(m_value);
    } else if (m_switch) {
        const QSignalBlocker quiet(m_switch);
        m_switch->setChecked(m_value != 0.0);
    } else if (m_look) {
        m_look->present(static_cast<int>(m_value),
                        LookChoice::imageOf(m_editor.shown(), *LookChoice::kindOf(key())));
    } else {
        m_choice->setCurrentIndex(static_cast<int>(m_value));
    }
}

void ParameterRow::edit(double value)
{
    if (value == m_value)
        return;
    m_value = value;
    present();
    if (!m_isDragging) {
        m_editor.nudge(this, key(), value, undoText(value));
        return;
    }
    m_editor.show(key(), value);
    if (showsAtOnce(key()))
        m_editor.putInForce(undoText(value));
}

void ParameterRow::choose(double value)
{
    m_value = value;
    m_editor.begin();
    m_editor.show(key(), value);
    m_editor.finish(undoText(value));
}

/// What the undo step is called that gives the parameter @p value.
QString ParameterRow::undoText(double value) const
{
    switch (m_scale.info().quantity) {
    case Quantity::Switch:
        return accessibleName();
    case Quantity::Choice:
        return tr("%1: %2").arg(accessibleName(),
                                choiceNames(m_scale.info().choices).value(static_cast<int>(value)));
    default:
        return tr("%1: %2").arg(accessibleName(), m_scale.shown(value));
    }
}

void ParameterRow::hideLabel()
{
    for (QLabel* label : findChildren<QLabel*>())
        label->hide();
    if (m_choice)
        m_choice->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
}

void ParameterRow::chooseDrawn(int drawn)
{
    m_editor.begin();
    TreeParameters parameters = m_editor.shown();
    LookChoice::takeImagesAway(parameters, *LookChoice::kindOf(key()));
    setParameter(parameters, key(), drawn);
    m_editor.show(parameters);
    m_editor.finish(undoText(drawn));
}

void ParameterRow::reset()
{
    const char* const keys[] = {key()};
    m_editor.reset(keys, accessibleName());
}

bool ParameterRow::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::MouseButtonDblClick:
        m_isTakenBack = true;
        reset();
        return true;
    case QEvent::MouseMove:
        return m_isTakenBack;
    case QEvent::MouseButtonPress:
        // The slider jumps to the pointer before it says that it is pressed.
        if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
            m_isTakenBack = false;
            m_isDragging = true;
            m_editor.begin();
        }
        break;
    case QEvent::EnabledChange:
        // Another edit of the document begins.
        if (!m_slider->isEnabled() && std::exchange(m_isDragging, false)) {
            m_editor.begin();
            m_editor.show(m_editor.inForce());
        }
        break;
    case QEvent::ShortcutOverride:
        if (m_isDragging && static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
            event->accept();
            return true;
        }
        break;
    case QEvent::KeyPress:
        if (keyPressed(*static_cast<QKeyEvent*>(event)))
            return true;
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

bool ParameterRow::keyPressed(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Escape && m_isDragging) {
        m_isDragging = false;
        m_isTakenBack = true;
        m_editor.cancel();
        return true;
    }
    if (event.key() == Qt::Key_Delete) {
        m_editor.begin();
        reset();
        return true;
    }
    const std::optional<double> value = m_scale.keyed(m_value, event.key(), event.modifiers());
    if (value)
        edit(*value);
    return value.has_value();
}

} // namespace espalier
