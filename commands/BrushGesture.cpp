// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"

#include <QCoreApplication>

namespace espalier {

namespace {

/// The sample as a recipe has it.
BrushSample recordable(BrushSample sample)
{
    sample.position = withoutNegativeZeros(sample.position);
    return sample;
}

} // namespace

BrushGesture::BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors)
    : m_edit(document, [this] { finish(); }),
      m_growth(competitors),
      m_only(BudReference::to(document, competitors)),
      m_path{recordable(first)},
      m_samples(m_path),
      m_next(m_path.front()),
      m_last(m_path.front())
{
}

void BrushGesture::add(const BrushSample& sample)
{
    if (!m_edit.isActive() || sample.time <= m_samples.back().time)
        return;
    moveToward(sample, sample.time);
    m_samples.push_back(recordable(sample));
}

void BrushGesture::moveToward(const BrushSample& sample, double time)
{
    if (!m_edit.isActive() || time <= m_path.back().time)
        return;
    const BrushSample next = recordable(sample);
    m_next = next;
    m_path.push_back(time < next.time ? between(m_samples.back(), next, time) : next);
    for (;;) {
        const double stepTime =
            m_path.front().time + static_cast<double>(m_stepsDone + 1) / kBrushStepsPerSecond;
        if (stepTime > time)
            return;
        const BrushSample brush = between(m_samples.back(), next, stepTime);
        const TreeDocument& document = m_edit.document();
        m_edit.apply(m_growth.step(document.tree(), document.index(), document.growthModel(), m_last, brush));
        m_last = brush;
        ++m_stepsDone;
    }
}

BrushStrokeOperation BrushGesture::operation() const
{
    BrushStrokeOperation stroke{m_samples, m_only};
    const double end = m_path.back().time;
    if (end > m_samples.back().time) {
        stroke.samples.push_back(m_next);
        stroke.until = end;
    }
    return stroke;
}

void BrushGesture::finish()
{
    commitRecorded(m_edit, QCoreApplication::translate("Commands", "Brush Stroke"),
                   [this] { return operation(); });
}

} // namespace espalier
