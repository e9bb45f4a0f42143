// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Actions.h"

#include <QElapsedTimer>
#include <QWidget>

#include <array>
#include <optional>

namespace espalier {

/// Eight tools in a ring around the pointer, and within it undo, redo and the size of the brush. It opens
/// below the pen or the mouse, so that the hand need not go to the bars. It stays open until something is
/// chosen or the user clicks elsewhere; if it was opened with a key that is held, and the pointer has moved,
/// its place at the key's release chooses.
class RingMenu : public QWidget {
    Q_OBJECT

public:
    /// Radii, px.
    static constexpr double kMiddle = 24.0; ///< Where nothing is chosen
    static constexpr double kInner = 64.0;
    static constexpr double kOuter = 124.0;

    explicit RingMenu(const Actions& actions, QWidget* parent = nullptr);

    /// Opens around @p place, px of the screen. @p key is the key that is held, or 0.
    void openAt(const QPoint& place, int key = 0);
    /// The action at @p place, px of this widget, or null.
    QAction* actionAt(const QPointF& place) const;
    /// The middle of the field of @p id, which is one of those in the ring, px of this widget.
    QPointF placeOf(ActionId id) const;

protected:
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Field {
        ActionId id;
        int ring; ///< 0: the inner one
        int place;
    };

    std::optional<Field> fieldAt(const QPointF& place) const;
    QPointF middleOf(const Field& field) const;
    void choose(const QPointF& place);
    void paintField(QPainter& painter, const Field& field) const;

    const Actions& m_actions;
    int m_key = 0; ///< The key that is held, or 0
    QElapsedTimer m_sinceOpened;
    QPointF m_openedAt; ///< The pointer then, px of this widget: near an edge of the screen not the middle
    QPointF m_pointer;  ///< px of this widget
    bool m_wasPressed = false; ///< The press of the click that chooses was in this widget
};

} // namespace espalier
