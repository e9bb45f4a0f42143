// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/GrowthRunner.h"

#include "app/runners/Background.h"
#include "commands/GrowthCeiling.h"
#include "commands/GrowthReplica.h"
#include "model/base/Parallel.h"
#include "model/io/project/ProjectLimits.h"

#include <algorithm>

namespace espalier {

GrowthRunner::GrowthRunner(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    m_due.setTimerType(Qt::PreciseTimer);
    m_due.setSingleShot(true);
    connect(&m_due, &QTimer::timeout, this, &GrowthRunner::show);
    connect(&document, &TreeDocument::parametersHeld, this, &GrowthRunner::holdParameters);
    connect(&document, &TreeDocument::changed, this, [this](const TreeChange& change) {
        if (change.kind == TreeChange::Kind::Reset)
            m_leastCeiling = 0;
    });
}

GrowthRunner::~GrowthRunner()
{
    if (isRunning())
        stop();
}

void GrowthRunner::start(std::unique_ptr<GrowthGesture> gesture, Pace pace, Continuation goOn)
{
    m_gesture = std::move(gesture);
    m_gesture->setInterrupted([this] { end(); });
    m_pace = pace;
    m_ceiling = std::max(m_leastCeiling, std::min(m_mostCeiling, growthCeiling(m_document.tree())));
    m_goOn = std::move(goOn);
    m_sinceLast.invalidate();
    if (!m_document.areParametersHeld())
        grow();
    Q_EMIT runningChanged(true);
}

void GrowthRunner::grow()
{
    m_replica = std::make_shared<GrowthReplica>(m_document.tree(), m_document.freshGrowthModel(),
                                                m_gesture->takeProcess());
    ask();
}

void GrowthRunner::ask()
{
    runInBackground(
        this, [replica = m_replica] { return leavingOneThread([&] { return replica->grow(); }); },
        [this, asked = std::weak_ptr(m_replica)](GrownStep grown) {
            // The result of an older copy is not used.
            if (m_replica && asked.lock() == m_replica)
                receive(std::move(grown));
        });
}

void GrowthRunner::receive(GrownStep grown)
{
    m_next = std::move(grown);
    const qint64 passed = m_sinceLast.isValid() ? m_sinceLast.elapsed() : m_pace.interval;
    if (passed >= m_pace.interval)
        show();
    else
        m_due.start(static_cast<int>(m_pace.interval - passed));
}

void GrowthRunner::show()
{
    m_sinceLast.start();
    if (!m_gesture->add(*std::exchange(m_next, std::nullopt))) {
        end();
        Q_EMIT exhausted();
    } else if (--m_pace.steps == 0) {
        end();
        Q_EMIT finished();
    } else if (m_document.tree().size() >= m_ceiling) {
        end();
        Q_EMIT ceilingReached();
    } else {
        ask();
    }
}

void GrowthRunner::raiseCeiling()
{
    const std::uint32_t internodes = m_document.tree().size();
    m_leastCeiling = std::min(internodes + internodes / 2, projectLimits::kInternodes);
}

void GrowthRunner::holdParameters(bool held)
{
    if (!isRunning())
        return;
    if (held) {
        stop();
        m_gesture->finish();
        m_document.setPausedWork([this] { end(); });
        return;
    }
    m_document.setPausedWork({});
    if ((m_gesture = m_goOn())) {
        m_gesture->setInterrupted([this] { end(); });
        grow();
    } else {
        Q_EMIT runningChanged(false);
    }
}

void GrowthRunner::stop()
{
    m_due.stop();
    m_next.reset();
    m_replica.reset();
    m_document.setPausedWork({});
}

void GrowthRunner::release()
{
    if (isRunning() && m_gesture->stepCount() == 0)
        m_pace.steps = 1;
    else
        end();
}

void GrowthRunner::end()
{
    if (!isRunning())
        return;
    stop();
    const auto gesture = std::move(m_gesture);
    gesture->finish();
    Q_EMIT runningChanged(false);
}

void GrowthRunner::cancel()
{
    if (!isRunning())
        return;
    stop();
    m_gesture.reset();
    Q_EMIT runningChanged(false);
}

} // namespace espalier
