// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/FocusKeeper.h"

#include "panels/Bar.h"
#include "panels/library/LibraryPanel.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QApplication>
#include <QFocusEvent>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QTextBrowser>

namespace espalier {

namespace {

bool isField(const QWidget& widget)
{
    return qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QLineEdit*>(&widget);
}

bool isWithin(const QWidget& part, const QWidget& whole)
{
    return &part == &whole || whole.isAncestorOf(&part);
}

/// Whether the widget, or what it lies in, is of the kind.
template <class Kind>
bool isIn(const QWidget& widget)
{
    for (const QWidget* part = &widget; part; part = part->parentWidget()) {
        if (qobject_cast<const Kind*>(part))
            return true;
    }
    return false;
}

/// Whether the user has changed the number and not yet entered it.
bool isBeingTyped(const QAbstractSpinBox& box)
{
    const auto* line = box.findChild<QLineEdit*>();
    return line && line->isModified();
}

} // namespace

FocusKeeper::FocusKeeper(QWidget& window, std::function<QWidget*()> tree)
    : QObject(&window), m_window(window), m_tree(std::move(tree))
{
    qApp->installEventFilter(this);
    // A control that had the keyboard is no more.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, const QWidget* now) {
        if (!now && m_window.isActiveWindow() && !m_window.focusWidget())
            QMetaObject::invokeMethod(
                this,
                [this] {
                    if (m_window.isActiveWindow() && !m_window.focusWidget())
                        giveBack();
                },
                Qt::QueuedConnection);
    });
}

bool FocusKeeper::isControl(const QWidget* widget) const
{
    if (!widget || widget->window() != &m_window || !isIn<Bar>(*widget) || isIn<LibraryPanel>(*widget))
        return false;
    // Words of a page that are selected can be copied.
    const auto* page = qobject_cast<const QTextBrowser*>(widget);
    return !page || !page->textCursor().hasSelection();
}

void FocusKeeper::giveBack()
{
    if (QWidget* tree = m_tree(); tree && tree->isVisible())
        tree->setFocus(Qt::MouseFocusReason);
}

void FocusKeeper::giveBackFrom(QWidget& widget)
{
    QMetaObject::invokeMethod(
        this,
        [this, from = QPointer<QWidget>(&widget)] {
            if (from && m_window.focusWidget() == from)
                giveBack();
        },
        Qt::QueuedConnection);
}

bool FocusKeeper::eventFilter(QObject* watched, QEvent* event)
{
    auto* widget = qobject_cast<QWidget*>(watched);
    if (!widget || m_isPassingOn || widget->window() != &m_window)
        return QObject::eventFilter(watched, event);
    switch (event->type()) {
    case QEvent::FocusIn:
        focusCame(*widget, static_cast<QFocusEvent*>(event)->reason());
        break;
    case QEvent::MouseButtonPress:
    case QEvent::TouchBegin:
    case QEvent::TabletPress:
        pressed(*widget);
        break;
    case QEvent::MouseButtonRelease:
    case QEvent::TouchEnd:
    case QEvent::TabletRelease:
        released();
        break;
    case QEvent::ShortcutOverride:
        if (isKeyTaken(*widget, *static_cast<QKeyEvent*>(event))) {
            // Nothing but the shortcut gets these; Escape comes to keyPressed().
            event->setAccepted(static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape);
            return true;
        }
        break;
    case QEvent::KeyPress:
        if (keyPressed(*widget, *static_cast<QKeyEvent*>(event)))
            return true;
        break;
    default:
        break;
    }
    return QObject::eventFilter(watched, event);
}

void FocusKeeper::focusCame(QWidget& widget, Qt::FocusReason reason)
{
    // A control that vanishes, or is disabled, passes the keyboard on as if Tab had been pressed.
    const bool isLeftOver = m_last && (!m_last->isVisible() || !m_last->isEnabled());
    m_last = &widget;
    switch (reason) {
    case Qt::TabFocusReason:
    case Qt::BacktabFocusReason:
        m_isDeliberate = !isLeftOver;
        break;
    case Qt::ShortcutFocusReason:
        m_isDeliberate = true;
        break;
    case Qt::PopupFocusReason:
    case Qt::ActiveWindowFocusReason:
        break;
    default:
        m_isDeliberate = false;
        break;
    }
    if (auto* box = qobject_cast<QAbstractSpinBox*>(&widget)) {
        if (auto* line = box->findChild<QLineEdit*>(); line && reason != Qt::ActiveWindowFocusReason)
            line->setModified(false);
    }
    const bool isAfterList = reason == Qt::PopupFocusReason && !m_isDeliberate && !isField(widget);
    const bool isPassedOn = isLeftOver && !m_isDeliberate;
    if ((isAfterList || isPassedOn) && isControl(&widget))
        giveBackFrom(widget);
}

/// A press beside the field that has the keyboard ends typing, before the press has its effect.
void FocusKeeper::pressed(const QWidget& widget)
{
    const QWidget* focus = m_window.focusWidget();
    if (!isControl(focus) || !isField(*focus) || !isControl(&widget) ||
        (widget.focusPolicy() & Qt::ClickFocus))
        return;
    // The button in a field, and the symbol before it, belong to the field.
    if (!isWithin(widget, *focus) && !isWithin(*focus, widget))
        giveBack();
}

void FocusKeeper::released()
{
    QWidget* focus = m_window.focusWidget();
    if (m_isDeliberate || QApplication::activePopupWidget() || !isControl(focus) || isField(*focus))
        return;
    giveBackFrom(*focus);
}

/// Whether a key is not offered to the widget.
bool FocusKeeper::isKeyTaken(QWidget& widget, const QKeyEvent& event) const
{
    if (&widget != m_window.focusWidget() || !isControl(&widget))
        return false;
    // The first Escape ends typing alone.
    if (event.key() == Qt::Key_Escape)
        return isField(widget);
    const auto* box = qobject_cast<const QAbstractSpinBox*>(&widget);
    const bool isUndo = event.matches(QKeySequence::Undo) || event.matches(QKeySequence::Redo);
    return box && isUndo && !isBeingTyped(*box);
}

bool FocusKeeper::keyPressed(QWidget& widget, QKeyEvent& event)
{
    const bool isEnter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    const bool isEscape = event.key() == Qt::Key_Escape;
    if ((!isEnter && !isEscape) || &widget != m_window.focusWidget() || !isControl(&widget))
        return false;
    // Enter presses buttons, and opens what is chosen in a list or a page.
    const bool isAnswered = qobject_cast<const QAbstractButton*>(&widget) ||
                            qobject_cast<const QAbstractItemView*>(&widget) ||
                            qobject_cast<const QTextBrowser*>(&widget);
    if (!isField(widget) && (isEscape || isAnswered))
        return false;
    {
        const QScopedValueRollback passing(m_isPassingOn, true);
        QCoreApplication::sendEvent(&widget, &event);
    }
    giveBack();
    event.accept();
    return true;
}

} // namespace espalier
