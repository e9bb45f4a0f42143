// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BrushGesture.h"
#include "commands/recipe/BrushStrokeOperation.h"
#include "commands/recipe/RecipeText.h"

#include <algorithm>
#include <limits>

namespace espalier {

namespace {

/// A stroke in its own time.
class StrokePerformance : public Performance {
public:
    StrokePerformance(TreeDocument& document, const BrushStrokeOperation& operation, BudReference::Found only)
        : m_document(document),
          m_samples(operation.samples),
          m_warning(std::move(only.warning)),
          m_historyBefore(document.journal().size()),
          m_gesture(document, m_samples.front(), only.competitors, operation.end, operation.placement),
          m_end(operation.until.value_or(std::numeric_limits<double>::infinity())),
          m_time(m_samples.front().time),
          m_isArriving(operation.end == StrokeEnd::Arrives)
    {
    }

    bool advance(double seconds) override
    {
        m_time = std::min(m_time + seconds, m_end);
        for (; m_next < m_samples.size() && m_samples[m_next].time <= m_time; ++m_next)
            m_gesture.add(m_samples[m_next]);
        if (m_next < m_samples.size()) {
            m_gesture.moveToward(m_samples[m_next], m_time);
            if (m_time < m_end)
                return false;
        }
        if (isSettling(seconds))
            return false;
        if (m_warning.isEmpty() && m_document.journal().size() == m_historyBefore)
            m_warning = RecipeText::tr("nothing grew");
        m_gesture.finish();
        return true;
    }
    QString warning() const override { return m_warning; }
    std::optional<BrushSample> brush() const override { return m_gesture.path().back(); }
    const BrushGesture* stroke() const override { return &m_gesture; }

private:
    /// Grows on after the stroke, as many steps a second as during it; whether there is more to grow.
    bool isSettling(double seconds)
    {
        for (m_settling += seconds * kBrushStepsPerSecond; m_isArriving && m_settling >= 1.0;
             m_settling -= 1.0)
            m_isArriving = m_gesture.settle();
        return m_isArriving;
    }

    const TreeDocument& m_document;
    std::span<const BrushSample> m_samples;
    QString m_warning;
    std::size_t m_historyBefore;
    BrushGesture m_gesture;
    double m_end;  ///< s of the stroke's time; infinity if it ends at its last sample
    double m_time; ///< s of the stroke's time
    std::size_t m_next = 1;
    double m_settling = 0.0; ///< Growth steps that are due after the stroke
    bool m_isArriving;
};

} // namespace

std::unique_ptr<Performance> BrushStrokeOperation::begin(TreeDocument& document) const
{
    return std::make_unique<StrokePerformance>(document, *this, only.resolve(document));
}

} // namespace espalier
