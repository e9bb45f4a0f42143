// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/LassoGesture.h"

#include <QObject>
#include <QTimer>

#include <memory>

namespace espalier {

/// Lets a document's tree fill envelopes while the window stays alive: one step at a time, slowly enough to
/// be watched. What grows between its beginning and its end is one undo step.
class LassoRunner : public QObject {
    Q_OBJECT

public:
    /// How fast envelopes are filled, steps a second at most.
    static constexpr double kStepsPerSecond = 24.0;

    explicit LassoRunner(TreeDocument& document, QObject* parent = nullptr);

    /// See LassoGesture::fill(); says refused() if that gives an error. Ends what is under way.
    void fill(const LassoStroke& stroke);
    /// See LassoGesture::regrow().
    void regrow();
    /// Leaves growth where it is and keeps it.
    void end();
    /// Takes back what grew, and the envelope.
    void cancel();

    bool isRunning() const { return m_gesture != nullptr; }
    /// Null unless it runs.
    const LassoGesture* gesture() const { return m_gesture.get(); }

Q_SIGNALS:
    void runningChanged(bool running);
    /// In one sentence, why nothing was begun.
    void refused(const QString& why);

private:
    void start(LassoGesture::Begun begun);
    void step();

    TreeDocument& m_document;
    std::unique_ptr<LassoGesture> m_gesture;
    QTimer m_timer;
};

} // namespace espalier
