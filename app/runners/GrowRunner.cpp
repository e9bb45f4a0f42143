// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/GrowRunner.h"

#include "commands/GrowGesture.h"

namespace espalier {

GrowRunner::GrowRunner(TreeDocument& document, QObject* parent) : GrowthRunner(document, parent)
{
    connect(this, &GrowthRunner::finished, this, [this] {
        if (m_asked.empty())
            return;
        const int steps = m_asked.front();
        m_asked.pop_front();
        start({steps, 0});
    });
}

void GrowRunner::begin()
{
    if (isRunning())
        return;
    m_asked.clear();
    start({kEndless, 1000 / kStepsPerSecond});
}

void GrowRunner::run(int steps)
{
    if (isRunning()) {
        m_asked.push_back(steps);
        return;
    }
    m_asked.clear();
    start({steps, 0});
}

void GrowRunner::start(Pace pace)
{
    // The interrupted edit may change which buds may grow, so it ends before they are read.
    document().interruptEdit();
    const auto gesture = [this] {
        return std::make_unique<GrowGesture>(document(), document().competitors());
    };
    GrowthRunner::start(gesture(), pace, gesture);
}

} // namespace espalier
