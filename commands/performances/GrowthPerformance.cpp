// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/performances/GrowthPerformance.h"

#include "commands/GrowGesture.h"
#include "commands/GrowthCeiling.h"
#include "commands/recipe/GrowOperation.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr double kStepsPerSecond = 12.0;

class FreeGrowthPerformance : public GrowthPerformance {
public:
    FreeGrowthPerformance(TreeDocument& document, int steps, BudReference::Found only)
        : GrowthPerformance(std::make_unique<GrowGesture>(document, only.competitors), steps),
          m_warning(std::move(only.warning))
    {
    }

    QString warning() const override
    {
        if (!m_warning.isEmpty())
            return m_warning;
        return gesture().stepCount() == 0 ? RecipeText::tr("nothing grew") : GrowthPerformance::warning();
    }

private:
    QString m_warning;
};

} // namespace

GrowthPerformance::GrowthPerformance(std::unique_ptr<GrowthGesture> gesture, int mostSteps)
    : m_gesture(std::move(gesture)),
      m_ceiling(growthCeiling(m_gesture->document().tree())),
      m_mostSteps(mostSteps)
{
}

bool GrowthPerformance::advance(double seconds)
{
    m_due += seconds * kStepsPerSecond;
    for (; m_steps < m_mostSteps; ++m_steps, m_due -= 1.0) {
        if (m_due < 1.0)
            return false;
        const std::uint32_t internodes = m_gesture->document().tree().size();
        if (internodes >= m_ceiling) {
            m_ceilingWarning = RecipeText::tr("growth stopped at %1 internodes, since the memory of this "
                                              "machine may not hold more")
                                   .arg(internodes);
            break;
        }
        if (!m_gesture->step())
            break;
    }
    m_gesture->finish();
    return true;
}

std::unique_ptr<Performance> GrowOperation::begin(TreeDocument& document) const
{
    return std::make_unique<FreeGrowthPerformance>(document, steps, only.resolve(document));
}

} // namespace espalier
