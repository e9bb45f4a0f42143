// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/FineDrag.h"

#include <QSlider>

namespace espalier {

/// A level slider that can be dragged finely (FineDrag).
class FineSlider : public QSlider {
    Q_OBJECT

public:
    explicit FineSlider(QWidget* parent = nullptr) : QSlider(Qt::Horizontal, parent) {}

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    FineDrag m_drag;
};

} // namespace espalier
