// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "panels/Bar.h"

class QLabel;
class QPushButton;

namespace espalier {

/// A card of the tour: a few words over the workspace, and a line to a ring around the thing that they
/// explain. The card is opaque and keeps clear of that thing and of the bars, so the user can try all of
/// them.
class TourCard : public Bar {
    Q_OBJECT

public:
    explicit TourCard(QWidget* parent);

    /// @p number counts from 1 to @p count. @p canBeWatched: a button plays what the words tell of.
    void setWords(const QString& title, const QString& text, int number, int count, bool canBeWatched);
    /// Puts the card beside @p target, px of the parent; with an empty one the card points at nothing. It
    /// keeps clear of the target, of all bars, and as far as there is room of @p canvas.
    void pointAt(const QRect& target, const QRect& canvas = {});
    /// Until the next pointAt().
    void hideRing();

Q_SIGNALS:
    void nextAsked();
    void skipAsked();
    void watchAsked();

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QPoint placeBeside(const QRect& target, const QRect& canvas) const;

    class Ring;
    Ring* m_ring; ///< Child of the same parent
    QLabel* m_title;
    QLabel* m_text;
    QLabel* m_number;
    QPushButton* m_watch;
    QPushButton* m_skip;
    QPushButton* m_next;
};

} // namespace espalier
