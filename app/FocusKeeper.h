// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include <functional>

class QKeyEvent;
class QWidget;

namespace espalier {

/// Gives the keyboard back to the tree when a control of the window has done with it, so that a key always
/// means the same: after Enter or Escape in a field, after a press beside the field, and after a click or a
/// drag of a control that takes no text. A control that the user reached with Tab or F6 keeps the keyboard,
/// and so does the library while it covers the tree. In a number that is not being changed, Undo and Redo are
/// those of the tree. The object filters the application's events from its construction on.
class FocusKeeper : public QObject {
    Q_OBJECT

public:
    /// @p tree returns the widget that shows the tree in @p window, or null while there is none.
    FocusKeeper(QWidget& window, std::function<QWidget*()> tree);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void focusCame(QWidget& widget, Qt::FocusReason reason);
    void pressed(const QWidget& widget);
    void released();
    bool isKeyTaken(QWidget& widget, const QKeyEvent& event) const;
    bool keyPressed(QWidget& widget, QKeyEvent& event);
    /// Whether the keyboard may be taken from the widget.
    bool isControl(const QWidget* widget) const;
    void giveBack();
    /// Gives the keyboard back later, if @p widget has it then.
    void giveBackFrom(QWidget& widget);

    QWidget& m_window;
    std::function<QWidget*()> m_tree;
    QPointer<QWidget> m_last;    ///< The widget of the window that got the keyboard last
    bool m_isDeliberate = false; ///< The user reached it with a key
    bool m_isPassingOn = false;
};

} // namespace espalier
