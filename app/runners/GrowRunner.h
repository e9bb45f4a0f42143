// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/GrowthRunner.h"
#include "views/tools/GrowTool.h"

#include <deque>

namespace espalier {

/// Lets a tree grow into free space and light.
class GrowRunner : public GrowthRunner, public HeldGrowth {
    Q_OBJECT

public:
    /// The greatest speed of growth while the pointer is held down, steps per second.
    static constexpr int kStepsPerSecond = 12;

    explicit GrowRunner(TreeDocument& document, QObject* parent = nullptr);

    bool isRunning() const override { return GrowthRunner::isRunning(); }
    void begin() override;
    void release() override { GrowthRunner::release(); }
    void end() override { GrowthRunner::end(); }
    void cancel() override { GrowthRunner::cancel(); }
    /// Grows up to @p steps steps as fast as possible, then ends by itself. If growth is under way, this run
    /// follows it, as an undo step of its own.
    void run(int steps);

private:
    void start(Pace pace);

    std::deque<int> m_asked; ///< Numbers of steps of the runs that wait
};

} // namespace espalier
