// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include <QCoreApplication>

namespace espalier {

BrushGesture::BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors)
    : m_edit(document, [this] { finish(); }),
      m_growth(competitors),
      m_path{first},
      m_sample(first),
      m_last(first)
{
}

void BrushGesture::add(const BrushSample& sample)
{
    if (!m_edit.isActive() || sample.time <= m_sample.time)
        return;
    moveToward(sample, sample.time);
    m_sample = sample;
}

void BrushGesture::moveToward(const BrushSample& next, double time)
{
    if (!m_edit.isActive() || time <= m_path.back().time)
        return;
    m_path.push_back(time < next.time ? between(m_sample, next, time) : next);
    for (;;) {
        const double stepTime =
            m_path.front().time + static_cast<double>(m_stepsDone + 1) / kBrushStepsPerSecond;
        if (stepTime > time)
            return;
        const BrushSample brush = between(m_sample, next, stepTime);
        const TreeDocument& document = m_edit.document();
        m_edit.apply(m_growth.step(document.tree(), document.index(), document.growthModel(), m_last, brush));
        m_last = brush;
        ++m_stepsDone;
    }
}

void BrushGesture::finish()
{
    m_edit.commit(QCoreApplication::translate("Commands", "Brush Stroke"));
}

} // namespace espalier
