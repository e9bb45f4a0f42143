// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/WindowHand.h"

#include <QApplication>
#include <QChar>
#include <QCoreApplication>
#include <QMenu>
#include <QPoint>
#include <QPointer>
#include <QTest>
#include <QTimer>
#include <QWidget>
#include <QWindow>

namespace espalier::test {

namespace {

constexpr int kWatchInterval = 15; ///< ms
constexpr int kMoves = 6;

QPoint inWindow(const QWidget& widget, const QPoint& place)
{
    return widget.mapTo(widget.window(), place);
}

QWindow* handleOf(const QWidget& widget)
{
    return widget.window()->windowHandle();
}

} // namespace

WindowHand::WindowHand() : m_screen(QTest::createTouchDevice())
{
    m_watch.setInterval(kWatchInterval);
    QObject::connect(&m_watch, &QTimer::timeout, &m_watch, [this] { closeWhatOpens(); });
    m_watch.start();
}

void WindowHand::closeWhatOpens()
{
    if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
        ++m_closed;
        menu->close();
    } else if (QWidget* dialog = QApplication::activeModalWidget()) {
        ++m_closed;
        dialog->close();
    }
}

void WindowHand::press(Way way, const QWidget& widget, const QPoint& place)
{
    if (way == Way::Finger) {
        QTest::touchEvent(handleOf(widget), m_screen).press(1, inWindow(widget, place), handleOf(widget));
        return;
    }
    QTest::mouseMove(handleOf(widget), inWindow(widget, place));
    QTest::mousePress(handleOf(widget), Qt::LeftButton, {}, inWindow(widget, place));
}

void WindowHand::move(Way way, const QWidget& widget, const QPoint& place)
{
    if (way == Way::Finger)
        QTest::touchEvent(handleOf(widget), m_screen).move(1, inWindow(widget, place), handleOf(widget));
    else
        QTest::mouseMove(handleOf(widget), inWindow(widget, place));
}

void WindowHand::release(Way way, const QWidget& widget, const QPoint& place)
{
    if (way == Way::Finger)
        QTest::touchEvent(handleOf(widget), m_screen).release(1, inWindow(widget, place), handleOf(widget));
    else
        QTest::mouseRelease(handleOf(widget), Qt::LeftButton, {}, inWindow(widget, place));
}

void WindowHand::tap(Way way, const QWidget& widget, const QPoint& place)
{
    const QPointer<const QWidget> target = &widget;
    press(way, widget, place);
    if (target)
        release(way, widget, place);
    QCoreApplication::processEvents();
}

void WindowHand::drag(Way way, const QWidget& widget, const QPoint& from, const QPoint& to)
{
    press(way, widget, from);
    for (int i = 1; i <= kMoves; ++i)
        move(way, widget, from + (to - from) * i / kMoves);
    release(way, widget, to);
    QCoreApplication::processEvents();
}

void WindowHand::key(const QWidget& widget, int key, Qt::KeyboardModifiers modifiers)
{
    QTest::keyClick(handleOf(widget), static_cast<Qt::Key>(key), modifiers);
    QCoreApplication::processEvents();
}

void WindowHand::type(const QWidget& widget, const QString& text)
{
    for (const QChar letter : text)
        QTest::keyClick(handleOf(widget), letter.toLatin1());
    QCoreApplication::processEvents();
}

} // namespace espalier::test
