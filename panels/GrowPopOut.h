// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "panels/Bar.h"

class QLabel;
class QPushButton;
class QSpinBox;

namespace espalier {

class TimeSlider;

/// Controls for time (TreeSketch §3.1): a slider through the history, back and forth, and beyond the present
/// into growth; a button that plays the history; a button that grows the tree while it is held; and growth
/// for a number of steps. The widget only emits signals.
class GrowPopOut : public Bar {
    Q_OBJECT

public:
    GrowPopOut(const TreeDocument& document, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The button is down: at least one step, and more until holdEnds().
    void holdBegins();
    void holdEnds();
    void stepsAsked(int steps);
    /// The slider was moved: show the moment after the first @p position edits and growth steps of the
    /// history; for a position beyond the history's end, grow the difference.
    void timeMoved(int position);
    void timeReleased();
    /// The user takes the drag back: show the moment where it began.
    void timeCancelled();
    void playToggled(bool plays);

public:
    /// Whether the history is being played.
    void setPlaying(bool plays);
    /// Ends a drag of the slider: the travel that it led has ended.
    void stopDrag();

private:
    void showStep();
    /// What the user did last up to the moment shown.
    QString titleOfMoment();

    const TreeDocument& m_document;
    TimeSlider* m_time;
    QPushButton* m_play;
    QLabel* m_step;
    QLabel* m_title;
    QSpinBox* m_count;
};

} // namespace espalier
