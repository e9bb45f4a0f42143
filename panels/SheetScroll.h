// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QScrollArea>

class QLabel;

namespace espalier {

/// Width of a column of rows on a sheet, px.
inline constexpr int kSheetColumn = 196;

/// The heading of a column.
QLabel* sheetTitle(const QString& text, QWidget* parent);

/// Scrolls a sheet's columns sideways where the window is too narrow, and is exactly as high as what it
/// shows.
class SheetScroll : public QScrollArea {
    Q_OBJECT

public:
    /// Takes @p content over.
    explicit SheetScroll(QWidget* content, QWidget* parent = nullptr);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return {100, sizeHint().height()}; }

protected:
    void wheelEvent(QWheelEvent* event) override;
};

} // namespace espalier
