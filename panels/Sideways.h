// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

namespace espalier {

/// Scrolls sideways where the window is too narrow, and is exactly as high as its contents. Pointer drags
/// that the contents do not use scroll them.
class Sideways : public QScrollArea {
    Q_OBJECT

public:
    explicit Sideways(QWidget* content, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

protected:
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    double m_pressX = 0.0; ///< px
    int m_pressPlace = 0;  ///< Value of the scroll bar at the press
};

} // namespace espalier
