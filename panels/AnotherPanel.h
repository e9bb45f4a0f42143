// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

#include <QImage>

#include <array>

class QLabel;

namespace espalier {

/// Trees that are like the user's own, as pictures: a click takes one.
class AnotherPanel : public Bar {
    Q_OBJECT

public:
    static constexpr int kCount = 6;
    /// Edge of a picture in a window of that size, px.
    static int pictureIn(const QSize& window);

    explicit AnotherPanel(QWidget* parent = nullptr);

    /// Takes all pictures away, and says that the trees are growing.
    void clear();
    /// Shows the picture of the tree number @p number, 0...kCount - 1; a null one says that there is none.
    void setPicture(int number, const QImage& picture);
    /// Sets the edge of the pictures, px.
    void setPictureSize(int edge);
    /// Gives the first tree the keyboard focus.
    void takeFocus();

Q_SIGNALS:
    void chosen(int number);
    void moreAsked();
    void closeAsked();

private:
    std::array<QToolButton*, kCount> m_buttons{};
    QLabel* m_state;
    int m_missing = kCount;
};

} // namespace espalier
