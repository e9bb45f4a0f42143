// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "panels/Bar.h"

class QLabel;
class QPushButton;
class QSlider;
class QSpinBox;

namespace espalier {

/// Time (TreeSketch §3.1): a slider back through all that was done and forth again, and beyond the present
/// into growth; a button that plays what was; and growth for as long as a button is held, or for a number of
/// steps. It only asks; see its signals.
class GrowPopOut : public Bar {
    Q_OBJECT

public:
    GrowPopOut(const TreeDocument& document, QWidget* parent = nullptr);

Q_SIGNALS:
    /// The button is down: at least one step, and more until holdEnds().
    void holdBegins();
    void holdEnds();
    void stepsAsked(int steps);
    /// The slider is held: show the moment at which @p position edits and growth steps of the history have
    /// been made; beyond its end, grow as many.
    void timeMoved(int position);
    void timeReleased();
    void playToggled(bool plays);

public:
    /// Whether the history is being played.
    void setPlaying(bool plays);

private:
    void showStep();
    /// Where a handle at @p position leads: a little beyond the present is still the present.
    int detained(int position) const;

    const TreeDocument& m_document;
    QSlider* m_time;
    QPushButton* m_play;
    QLabel* m_step;
    QSpinBox* m_count;
    int m_present = 0; ///< The slider's position at the end of the history
};

} // namespace espalier
