// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>
#include <QWidget>

class QAction;
class QLabel;
class QVBoxLayout;

namespace espalier {

/// A translucent, rounded panel that floats over the tree. Pointer events on it end there, so that a press on
/// a panel does not brush.
class Bar : public QWidget {
    Q_OBJECT

public:
    explicit Bar(QWidget* parent = nullptr);

    /// Makes the bar flat: it reaches from edge to edge of the window, and has a line below it.
    void setFlat(bool flat);
    /// Nothing shows through it.
    void setOpaque(bool opaque);

protected:
    bool event(QEvent* event) override;
    /// Enter presses the button that has the focus, as Space does.
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    bool m_flat = false;
    bool m_isOpaque = false;
};

/// A button on a bar, large enough for a finger. It shows an action and follows it.
class BarButton : public QToolButton {
    Q_OBJECT

public:
    enum class Look {
        Icon,          ///< For a row of buttons
        IconAboveText, ///< For a column of tools
        Tab,           ///< Text only, for one of several sheets
    };

    explicit BarButton(Look look, QWidget* parent = nullptr);
    BarButton(Look look, QAction* action, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

private:
    Look m_look;
};

/// A thin line between groups of buttons.
QWidget* barSeparator(Qt::Orientation orientation, QWidget* parent);
/// A heading above controls that belong together.
QLabel* barHeading(const QString& text, QWidget* parent);
/// Adds a column with a heading, @p width px wide, to the row layout of @p content.
QVBoxLayout* addBarColumn(QWidget& content, const QString& title, int width);

} // namespace espalier
