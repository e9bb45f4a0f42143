// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/GrowthGesture.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>
#include <limits>
#include <memory>
#include <optional>

namespace espalier {

class GrowthReplica;

/// Lets a document's tree grow on its own while the window stays alive: another thread works out the steps on
/// a copy, one ahead, and each is shown when it is due. All steps between beginning and end are one undo
/// step; where parameters are changed meanwhile, those before and those after are one each.
class GrowthRunner : public QObject {
    Q_OBJECT

public:
    static constexpr int kEndless = std::numeric_limits<int>::max();

    explicit GrowthRunner(TreeDocument& document, QObject* parent = nullptr);
    /// Takes back what has not ended.
    ~GrowthRunner() override;

    bool isRunning() const { return m_gesture != nullptr; }
    /// Null unless it runs.
    const GrowthGesture* gesture() const { return m_gesture.get(); }

    /// The hand lets go: as soon as there is a step, growth ends.
    void release();
    /// Ends at once and keeps what has grown.
    void end();
    /// Ends at once and takes back what grew since it began, or since parameters were changed.
    void cancel();

Q_SIGNALS:
    void runningChanged(bool running);
    /// It has made all the steps that it was to make, and ended.
    void finished();
    /// The tree has no more room to grow in.
    void exhausted();

protected:
    /// Another gesture that goes on where one has ended.
    using Continuation = std::function<std::unique_ptr<GrowthGesture>()>;
    struct Pace {
        int steps = kEndless; ///< At most
        int interval = 0;     ///< ms from one to the next, at least
    };

    TreeDocument& document() { return m_document; }
    /// Precondition: it does not run.
    void start(std::unique_ptr<GrowthGesture> gesture, Pace pace, Continuation goOn);

private:
    void grow();
    void ask();
    void receive(GrownStep grown);
    void show();
    void holdParameters(bool held);
    void stop();

    TreeDocument& m_document;
    std::unique_ptr<GrowthGesture> m_gesture;
    Continuation m_goOn;
    Pace m_pace;
    std::shared_ptr<GrowthReplica> m_replica; ///< Null while parameters are held
    std::optional<GrownStep> m_next;          ///< Worked out, but not due yet
    QElapsedTimer m_sinceLast;
    QTimer m_due;
};

} // namespace espalier
