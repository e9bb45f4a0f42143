// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "panels/Bar.h"

class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace espalier {

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
    void playToggled(bool plays);

public:
    /// Whether the history is being played.
    void setPlaying(bool plays);

private:
    void showStep();
    /// The position that a handle at @p position stands for: a little beyond the present counts as the
    /// present.
    int detained(int position) const;

    const TreeDocument& m_document;
    QSlider* m_time;
    QPushButton* m_play;
    QLabel* m_step;
    QSpinBox* m_count;
    int m_present = 0; ///< The slider's position at the end of the history
};

} // namespace espalier
