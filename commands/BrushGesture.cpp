// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"

#include "commands/EditTitle.h"
#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"

#include <QCoreApplication>

#include <algorithm>
#include <optional>
#include <utility>

namespace espalier {

namespace {

/// The times of a hand's samples ascend by this at least, s.
constexpr double kLeastPause = 1e-3;

/// The sample as a recipe has it.
BrushSample recordable(BrushSample sample)
{
    sample.position = withoutNegativeZeros(sample.position);
    return sample;
}

/// The placement as a recipe has it.
StrokePlacement recordable(StrokePlacement placement)
{
    if (placement.isUsual())
        return {};
    placement.around = withoutNegativeZeros(placement.around);
    placement.copies = std::clamp(placement.copies, 1, StrokePlacement::kMostCopies);
    return placement;
}

} // namespace

BrushGesture::BrushGesture(TreeDocument& document, const BrushSample& first, Competitors competitors,
                           StrokeEnd end, const StrokePlacement& placement)
    : m_edit(document, [this] { finish(); }),
      m_end(end),
      m_growth(document, competitors, end, recordable(placement)),
      m_only(BudReference::to(document, competitors)),
      m_path{recordable(first)},
      m_samples(m_path),
      m_next(m_path.front()),
      m_last(m_path.front()),
      m_due(first.time)
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
    m_due = time;
    while (growNext()) {
    }
}

void BrushGesture::follow(const BrushSample& sample)
{
    const BrushSample last = m_samples.back();
    if (!m_edit.isActive() || sample.time <= last.time)
        return;
    m_next = recordable(sample);
    // It has rested at least as long as growth took it to rest.
    if (const double until = std::max(sample.time - kBrushRest, m_last.time); until > last.time) {
        holdUntil(until);
        m_next.time = std::max(m_next.time, until + kLeastPause);
    }
    m_samples.push_back(m_next);
    m_path.push_back(m_next);
    m_due = std::max(m_due, m_next.time);
}

void BrushGesture::holdUntil(double time)
{
    m_samples.push_back(m_samples.back());
    m_samples.back().time = time;
    m_path.push_back(m_samples.back());
}

void BrushGesture::rest(double time)
{
    m_due = std::max(m_due, time - kBrushRest);
}

void BrushGesture::catchUp(std::chrono::nanoseconds longest)
{
    const auto begun = std::chrono::steady_clock::now();
    while (m_edit.isActive() && growNext() && std::chrono::steady_clock::now() - begun < longest) {
    }
}

/// Makes the next growth step if it is due; returns whether it was.
bool BrushGesture::growNext()
{
    const double stepTime = m_path.front().time + static_cast<double>(m_stepsDone + 1) / kBrushStepsPerSecond;
    if (stepTime > m_due)
        return false;
    const std::size_t last = m_met;
    while (m_met + 1 < m_samples.size() && m_samples[m_met + 1].time < stepTime)
        ++m_met;
    const BrushSample& from = m_samples[m_met];
    const BrushSample& to = m_met + 1 < m_samples.size() ? m_samples[m_met + 1] : m_next;
    BrushSample brush = to.time > from.time ? between(from, to, stepTime) : from;
    brush.time = stepTime; // At rest after the last sample
    std::vector<BrushSample> way{m_last};
    if (m_end == StrokeEnd::Arrives)
        way.insert(way.end(), m_samples.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                   m_samples.begin() + static_cast<std::ptrdiff_t>(m_met) + 1);
    way.push_back(brush);
    growAlong(way);
    ++m_stepsDone;
    return true;
}

void BrushGesture::growAlong(std::span<const BrushSample> way)
{
    m_growth.step(m_edit, way);
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
    return m_growth.settle(m_edit, end);
}

BrushStrokeOperation BrushGesture::operation() const
{
    BrushStrokeOperation stroke{m_samples, m_only};
    stroke.end = m_end;
    stroke.placement = m_growth.placement();
    const double end = m_path.back().time;
    if (end > m_samples.back().time) {
        stroke.samples.push_back(m_next);
        stroke.until = end;
    }
    return stroke;
}

void BrushGesture::finish()
{
    while (m_edit.isActive() && growNext()) {
    }
    if (m_last.time > m_path.back().time)
        holdUntil(m_last.time);
    while (settle()) {
    }
    const Journal& journal = m_edit.document().journal();
    const QString title =
        titleOfBrushStroke(m_edit.document().tree(), std::span(journal).last(m_edit.deltaCount()));
    commitRecorded(m_edit, title, [this] { return operation(); });
}

} // namespace espalier
