// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/LatinKeyFilter.h"

#include <QApplication>
#include <QKeyEvent>
#include <QScopedValueRollback>
#include <QWidget>

QT_BEGIN_NAMESPACE
// Offers a key to shortcuts, as the platform's events are. Qt exports it for QtTest, whose headers declare it
// like this; there is no other way to the shortcuts for an event that a program makes.
Q_GUI_EXPORT bool qt_sendShortcutOverrideEvent(QObject* o, ulong timestamp, int k, Qt::KeyboardModifiers mods,
                                               const QString& text = QString(), bool autorep = false,
                                               ushort count = 1);
QT_END_NAMESPACE

namespace espalier {

namespace {

bool isUsLetter(int key)
{
    return key >= Qt::Key_A && key <= Qt::Key_Z;
}

/// Whether the user can type text into the object.
bool takesText(const QObject* object)
{
    const auto* widget = qobject_cast<const QWidget*>(object);
    return widget && widget->testAttribute(Qt::WA_InputMethodEnabled);
}

} // namespace

LatinKeyFilter::LatinKeyFilter(QObject* parent)
    : QObject(parent), m_codes(keyCodesOf(QGuiApplication::platformName()))
{
    qApp->installEventFilter(this);
}

/// The Qt::Key for the place of the event's key; 0 if the layout's meaning counts.
int LatinKeyFilter::meantKey(const QKeyEvent& event)
{
    const quint32 code = m_codes == KeyCodes::Mac ? event.nativeVirtualKey() : event.nativeScanCode();
    // A key means the same from its press to its release, though the layout may change between them.
    if (event.type() == QEvent::KeyRelease && m_held.contains(code))
        return event.isAutoRepeat() ? m_held.value(code) : m_held.take(code);
    const KeyScript script = scriptOf(event);
    if (script != KeyScript::None)
        m_isLayoutForeign = script == KeyScript::Foreign;
    int key = script != KeyScript::Latin && m_isLayoutForeign ? keyOfUsLayout(event, m_codes) : 0;
    if (script == KeyScript::None && !isUsLetter(key))
        key = 0;
    const bool isCodeKnown = m_codes == KeyCodes::Mac || code != 0;
    if (event.type() == QEvent::KeyPress && key != 0 && isCodeKnown)
        m_held.insert(code, key);
    return key;
}

bool LatinKeyFilter::eventFilter(QObject* watched, QEvent* event)
{
    // A key event comes to the window first, once, and from there to the widget with the focus.
    const bool isKey = event->type() == QEvent::KeyPress || event->type() == QEvent::KeyRelease;
    // Events that this filter sends itself tell nothing about the layout.
    if (!isKey || m_isSending || !watched->isWindowType())
        return QObject::eventFilter(watched, event);
    const auto& key = static_cast<const QKeyEvent&>(*event);
    const int meant = meantKey(key);
    QObject* focus = QGuiApplication::focusObject();
    const bool isCommand =
        (key.modifiers() & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier)) != Qt::NoModifier;
    if (meant == 0 || meant == key.key() || (takesText(focus) && !isCommand))
        return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::KeyPress && !QApplication::activePopupWidget() &&
        qt_sendShortcutOverrideEvent(focus ? focus : watched, static_cast<ulong>(key.timestamp()), meant,
                                     key.modifiers(), key.text(), key.isAutoRepeat(),
                                     static_cast<ushort>(key.count()))) {
        event->accept();
        return true;
    }
    QKeyEvent same(event->type(), meant, key.modifiers(), key.nativeScanCode(), key.nativeVirtualKey(),
                   key.nativeModifiers(), key.text(), key.isAutoRepeat(), static_cast<quint16>(key.count()));
    same.setTimestamp(key.timestamp());
    const QScopedValueRollback sending(m_isSending, true);
    QCoreApplication::sendEvent(watched, &same);
    event->setAccepted(same.isAccepted());
    return true;
}

} // namespace espalier
