// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"

#include <QCoreApplication>

#include <optional>
#include <utility>

namespace espalier {

namespace {

/// The sample as a recipe has it.
BrushSample recordable(BrushSample sample)
{
    sample.position = withoutNegativeZeros(sample.position);
    return sample;
}

/// What the undo step of a stroke is called: with the number of branches that it grew.
QString titleOf(const Edit& edit)
{
    const TreeDocument& document = edit.document();
    int branches = 0;
    for (std::size_t i = document.journal().size() - edit.deltaCount(); i < document.journal().size(); ++i) {
        const IdRange born = document.journal()[i]->born;
        for (InternodeId id = born.first; id < born.end(); ++id)
            branches += document.tree().isAlive(id) && document.index().axis(id) == id ? 1 : 0;
    }
    return branches > 1
               ? QCoreApplication::translate("Commands", "Brush Stroke, %n branches", nullptr, branches)
               : QCoreApplication::translate("Commands", "Brush Stroke");
}

} // namespace

BrushGesture::BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors,
                           StrokeEnd end)
    : m_edit(document, [this] { finish(); }),
      m_end(end),
      m_growth(competitors, end),
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
    m_next = recordable(sample);
    m_path.push_back(time < m_next.time ? between(m_samples.back(), m_next, time) : m_next);
    growTo(time);
}

void BrushGesture::growTo(double time)
{
    for (;;) {
        const double stepTime =
            m_path.front().time + static_cast<double>(m_stepsDone + 1) / kBrushStepsPerSecond;
        if (stepTime > time)
            return;
        const std::size_t last = m_met;
        while (m_met + 1 < m_samples.size() && m_samples[m_met + 1].time < stepTime)
            ++m_met;
        const BrushSample& to = m_met + 1 < m_samples.size() ? m_samples[m_met + 1] : m_next;
        const BrushSample brush = between(m_samples[m_met], to, stepTime);
        std::vector<BrushSample> way{m_last};
        if (m_end == StrokeEnd::Arrives)
            way.insert(way.end(), m_samples.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                       m_samples.begin() + static_cast<std::ptrdiff_t>(m_met) + 1);
        way.push_back(brush);
        growAlong(way);
        ++m_stepsDone;
    }
}

void BrushGesture::growAlong(std::span<const BrushSample> way)
{
    const TreeDocument& document = m_edit.document();
    m_edit.apply(m_growth.step(document.tree(), document.index(), document.growthModel(), way));
    m_last = way.back();
}

bool BrushGesture::settle()
{
    if (!m_edit.isActive() || m_end != StrokeEnd::Arrives)
        return false;
    const BrushSample end = m_path.back();
    if (end.time > m_last.time) { // The rest of the way, which is shorter than a step's
        std::vector<BrushSample> way{m_last};
        for (std::size_t i = m_met + 1; i < m_samples.size() && m_samples[i].time < end.time; ++i)
            way.push_back(m_samples[i]);
        way.push_back(end);
        growAlong(way);
        return true;
    }
    const TreeDocument& document = m_edit.document();
    std::optional<TreeDelta> delta =
        m_growth.settle(document.tree(), document.index(), document.growthModel(), end);
    if (delta)
        m_edit.apply(std::move(*delta));
    return delta.has_value();
}

BrushStrokeOperation BrushGesture::operation() const
{
    BrushStrokeOperation stroke{m_samples, m_only};
    stroke.end = m_end;
    const double end = m_path.back().time;
    if (end > m_samples.back().time) {
        stroke.samples.push_back(m_next);
        stroke.until = end;
    }
    return stroke;
}

void BrushGesture::finish()
{
    while (settle()) {
    }
    commitRecorded(m_edit, titleOf(m_edit), [this] { return operation(); });
}

} // namespace espalier
