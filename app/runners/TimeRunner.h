// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/TimeGesture.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Moves a document in time as a slider says, or plays its history like a film. Everything from the first
/// moveTo() or play() to release() is one gesture.
class TimeRunner : public QObject {
    Q_OBJECT

public:
    explicit TimeRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Begins a gesture if none is under way, and moves it: see TimeGesture::moveTo(). Stops a film.
    void moveTo(int position);
    /// Ends the gesture or the film at the moment shown; it becomes one undo step.
    void release();
    /// Plays from the moment shown, or from the beginning if that is the present.
    void play();
    /// Returns to the moment before the gesture.
    void cancel();

    bool isRunning() const { return m_gesture != nullptr; }
    bool isPlaying() const { return m_timer.isActive(); }

Q_SIGNALS:
    void runningChanged(bool running);

private:
    void begin();
    void showNext();

    TreeDocument& m_document;
    std::unique_ptr<TimeGesture> m_gesture;
    QTimer m_timer;
    std::size_t m_stride = 1; ///< Deltas per frame
};

} // namespace espalier
