// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/TimeGesture.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Turns a document's time as a slider asks, or plays its history like a film. What happens between the first
/// moveTo() and release() is one gesture.
class TimeRunner : public QObject {
    Q_OBJECT

public:
    explicit TimeRunner(TreeDocument& document, QObject* parent = nullptr);

    void moveTo(int position);
    void release();
    /// From the moment shown, or from the beginning if that is the present.
    void play();
    /// Stops where it is.
    void stop();
    /// Back to the moment before.
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
    std::size_t m_stride = 1; ///< Deltas a frame
};

} // namespace espalier
