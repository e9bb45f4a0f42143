// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

class QLabel;
class QPushButton;

namespace espalier {

/// A card of the tour: a few words over the workspace, and a line to a ring around what they are about.
/// Whoever wants to do that can: nothing but the card itself is covered.
class TourCard : public Bar {
    Q_OBJECT

public:
    explicit TourCard(QWidget* parent);

    /// @p number counts from 1 to @p count.
    void setWords(const QString& title, const QString& text, int number, int count);
    /// Stands beside @p target, px of the parent, without covering it; an empty one is not pointed at.
    void pointAt(const QRect& target);

Q_SIGNALS:
    void nextAsked();
    void skipAsked();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QPoint placeBeside(const QRect& target) const;

    class Ring;
    Ring* m_ring; ///< The parent's
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_number;
    QPushButton* m_skip;
    QPushButton* m_next;
};

} // namespace espalier
