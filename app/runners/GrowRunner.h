// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/GrowthRunner.h"
#include "views/tools/GrowTool.h"

#include <deque>

namespace espalier {

/// Lets a tree grow into whatever space and light there is.
class GrowRunner : public GrowthRunner, public HeldGrowth {
    Q_OBJECT

public:
    /// How fast a tree grows under a hand that holds, steps a second at most.
    static constexpr int kStepsPerSecond = 12;

    explicit GrowRunner(TreeDocument& document, QObject* parent = nullptr);

    bool isRunning() const override { return GrowthRunner::isRunning(); }
    void begin() override;
    void release() override { GrowthRunner::release(); }
    void end() override { GrowthRunner::end(); }
    void cancel() override { GrowthRunner::cancel(); }
    /// Grows up to @p steps as fast as it goes, then ends by itself; while it runs already, as an undo step
    /// of its own after that.
    void run(int steps);

private:
    void start(Pace pace);

    std::deque<int> m_asked; ///< Runs that wait
};

} // namespace espalier
