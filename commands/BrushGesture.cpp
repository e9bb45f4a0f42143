// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include "commands/DeltaCommand.h"

#include <QCoreApplication>

namespace espalier {

BrushGesture::BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors)
    : m_document(document), m_growth(competitors), m_path{first}, m_sample(first), m_last(first)
{
}

BrushGesture::~BrushGesture()
{
    cancel();
}

void BrushGesture::add(const BrushSample& sample)
{
    if (m_ended || sample.time <= m_sample.time)
        return;
    moveToward(sample, sample.time);
    m_sample = sample;
}

void BrushGesture::moveToward(const BrushSample& next, double time)
{
    if (m_ended || time <= m_path.back().time)
        return;
    m_path.push_back(time < next.time ? between(m_sample, next, time) : next);
    for (;;) {
        const double stepTime =
            m_path.front().time + static_cast<double>(m_stepsDone + 1) / kBrushStepsPerSecond;
        if (stepTime > time)
            return;
        const BrushSample brush = between(m_sample, next, stepTime);
        TreeDelta delta =
            m_growth.step(m_document.tree(), m_document.index(), m_document.growthIndex(), m_last, brush);
        m_last = brush;
        ++m_stepsDone;
        if (!delta.isEmpty()) {
            m_deltas.push_back(std::make_shared<TreeDelta>(std::move(delta)));
            m_document.apply(m_deltas.back());
        }
    }
}

void BrushGesture::finish()
{
    if (std::exchange(m_ended, true) || m_deltas.empty())
        return;
    m_document.undoStack().push(new DeltaCommand(
        m_document, QCoreApplication::translate("Commands", "Brush Stroke"), std::move(m_deltas)));
}

void BrushGesture::cancel()
{
    if (std::exchange(m_ended, true))
        return;
    for (std::size_t i = 0; i < m_deltas.size(); ++i)
        m_document.revertLast();
    m_deltas.clear();
}

} // namespace espalier
