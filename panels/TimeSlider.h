// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/FineDrag.h"

#include <QAbstractSlider>

namespace espalier {

/// A slider through a history. Its handle is dragged from where it is held, finely if wanted (FineDrag).
/// Beyond the mark of the present nothing happens until the handle is pulled well past it; then each further
/// bit of the way is a new step. Escape takes a drag back.
class TimeSlider : public QAbstractSlider {
    Q_OBJECT

public:
    explicit TimeSlider(QWidget* parent = nullptr);

    /// Shows the moment @p position of a history of @p length moments; emits no signal. Not during a drag.
    void setHistory(int position, int length);
    /// Ends a drag under way: the handle does not follow the pointer any more.
    void drop();

    /// The middle of the handle, px.
    QPointF handlePlace() const;
    /// The middle of the handle if it was at @p position, px.
    QPointF placeOf(int position) const;

    QSize sizeHint() const override { return {210, 44}; }
    QSize minimumSizeHint() const override { return {150, 44}; }

Q_SIGNALS:
    /// The user has moved the handle to @p position; beyond maximum() are new steps.
    void moved(int position);
    /// A drag has ended, or one step by key or click.
    void letGo();
    /// Escape was pressed during a drag.
    void cancelled();

protected:
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void sliderChange(SliderChange change) override;

private:
    double presentX() const;
    int positionAt(double x) const;
    void step(double x);

    FineDrag m_drag;
    int m_position = 0; ///< What moved() told last
    bool m_hasMoved = false;
};

} // namespace espalier
