// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowGesture.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Lets a document's tree grow on its own while the window stays alive: one step at a time, between the
/// window's other events. All steps between begin() and end() are one undo step.
class GrowRunner : public QObject {
    Q_OBJECT

public:
    /// How fast a tree grows under a hand that holds, steps a second at most.
    static constexpr double kStepsPerSecond = 12.0;

    explicit GrowRunner(TreeDocument& document, QObject* parent = nullptr);

    /// Makes a step at once and goes on until end() or cancel().
    void begin();
    void end();
    /// Grows up to @p steps as fast as it goes, then ends by itself.
    void run(int steps);
    /// Takes back what grew since begin() or run().
    void cancel();

    bool isRunning() const { return m_gesture != nullptr; }

Q_SIGNALS:
    void runningChanged(bool running);
    /// The tree has no more room to grow in.
    void exhausted();

private:
    void start(int steps, int interval);
    void step();

    TreeDocument& m_document;
    std::unique_ptr<GrowGesture> m_gesture;
    QTimer m_timer;
    int m_stepsLeft = 0;
};

} // namespace espalier
