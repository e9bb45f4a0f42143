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

/// Grows a document's tree while the window responds: another thread computes the steps on a copy, one ahead,
/// and each is shown when it is due. All steps from start to end are one undo step. If parameters are changed
/// meanwhile, the steps before the change and those after it are one undo step each.
class GrowthRunner : public QObject {
    Q_OBJECT

public:
    static constexpr int kEndless = std::numeric_limits<int>::max();

    explicit GrowthRunner(TreeDocument& document, QObject* parent = nullptr);
    /// Takes back the steps of growth that has not ended.
    ~GrowthRunner() override;

    bool isRunning() const { return m_gesture != nullptr; }
    /// Null if growth is not running.
    const GrowthGesture* gesture() const { return m_gesture.get(); }

    /// The pointer was released: growth ends, but not before its first step.
    void release();
    /// Ends growth at once and keeps its steps.
    void end();
    /// After ceilingReached(): the next growth goes on beyond it, by half of what the tree has now.
    void raiseCeiling();
    /// Sets the ceiling that the next growth has at most.
    void limitCeiling(std::uint32_t internodes) { m_mostCeiling = internodes; }
    /// Ends growth at once and takes back its steps; after a change of parameters, only the steps since.
    void cancel();

Q_SIGNALS:
    void runningChanged(bool running);
    /// All wanted steps were made, and growth has ended.
    void finished();
    /// Growth has ended because the tree finds no more space.
    void exhausted();
    /// Growth has ended because the machine's memory may not hold a tree of more internodes.
    void ceilingReached();

protected:
    /// Makes a gesture that continues growth after parameters were changed; null if that is not possible.
    using Continuation = std::function<std::unique_ptr<GrowthGesture>()>;
    struct Pace {
        int steps = kEndless; ///< The greatest number of steps
        int interval = 0;     ///< The least time from one step to the next, ms
    };

    TreeDocument& document() { return m_document; }
    /// Precondition: growth is not running.
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
    std::uint32_t m_ceiling = 0; ///< Internodes
    std::uint32_t m_leastCeiling = 0;
    std::uint32_t m_mostCeiling = std::numeric_limits<std::uint32_t>::max();
    std::shared_ptr<GrowthReplica> m_replica; ///< Null while parameters are held
    std::optional<GrownStep> m_next;          ///< Computed, but not due yet
    QElapsedTimer m_sinceLast;
    QTimer m_due;
};

} // namespace espalier
