// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPoint>
#include <QPointer>
#include <QTimer>
#include <QWidget>

class QPointingDevice;

namespace espalier::test {

enum class Way { Mouse, Finger, Keys };

/// The user at a window: events enter where the system's events do, so that the topmost widget gets them.
class WindowHand {
public:
    WindowHand();

    /// Clicks or taps at @p place of @p widget.
    void tap(Way way, const QWidget& widget, const QPoint& place);
    void tap(Way way, const QWidget& widget) { tap(way, widget, widget.rect().center()); }
    /// Drags in steps.
    void drag(Way way, const QWidget& widget, const QPoint& from, const QPoint& to);
    /// Presses a key in the window of @p widget.
    static void key(const QWidget& widget, int key, Qt::KeyboardModifiers modifiers = {});
    /// Types plain letters and digits.
    static void type(const QWidget& widget, const QString& text);

    /// Number of dialogs and menus that have opened so far; each is closed at once.
    int closedCount() const { return m_closed; }

private:
    void press(Way way, const QWidget& widget, const QPoint& place);
    void move(Way way, const QWidget& widget, const QPoint& place);
    void release(Way way, const QWidget& widget, const QPoint& place);
    void closeWhatOpens();

    QPointingDevice* m_screen;
    QTimer m_watch;
    int m_closed = 0;
};

} // namespace espalier::test
