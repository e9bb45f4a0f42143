// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/Performance.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr double kStepsPerSecond = 12.0;
constexpr qsizetype kFaultsNamed = 3;

class LassoPerformance : public GrowthPerformance {
public:
    LassoPerformance(std::unique_ptr<LassoGesture> gesture, QString warning)
        : GrowthPerformance(std::move(gesture)), m_warning(std::move(warning))
    {
    }

    QString warning() const override { return m_warning; }
    const LassoGesture* lasso() const override { return static_cast<const LassoGesture*>(&gesture()); }

private:
    QString m_warning;
};

/// For what cannot be done at all.
class NoPerformance : public Performance {
public:
    explicit NoPerformance(QString warning) : m_warning(std::move(warning)) {}

    bool advance(double) override { return true; }
    QString warning() const override { return m_warning; }

private:
    QString m_warning;
};

} // namespace

GrowthPerformance::GrowthPerformance(std::unique_ptr<GrowthGesture> gesture, int mostSteps)
    : m_gesture(std::move(gesture)), m_mostSteps(mostSteps)
{
}

bool GrowthPerformance::advance(double seconds)
{
    m_due += seconds * kStepsPerSecond;
    for (; m_steps < m_mostSteps; ++m_steps, m_due -= 1.0) {
        if (m_due < 1.0)
            return false;
        if (!m_gesture->step())
            break;
    }
    m_gesture->finish();
    return true;
}

std::unique_ptr<Performance> performanceOf(LassoGesture::Begun begun, const QString& warning)
{
    if (!begun)
        return std::make_unique<NoPerformance>(begun.error().message);
    return std::make_unique<LassoPerformance>(std::move(*begun), warning);
}

QString joinedFaults(const QStringList& faults)
{
    const QString named = faults.mid(0, kFaultsNamed).join(QLatin1String("; "));
    return faults.size() <= kFaultsNamed
               ? named
               : RecipeText::tr("%1; and %2 more").arg(named).arg(faults.size() - kFaultsNamed);
}

} // namespace espalier
