// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/LassoGesture.h"
#include "commands/performances/GrowthPerformance.h"
#include "commands/recipe/FillEnvelopesOperation.h"
#include "commands/recipe/LassoOperation.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/RegrowOperation.h"
#include "commands/recipe/RemoveLassoOperation.h"

namespace espalier {

namespace {

class LassoPerformance : public GrowthPerformance {
public:
    LassoPerformance(std::unique_ptr<LassoGesture> gesture, std::optional<int> steps, QString warning)
        : GrowthPerformance(std::move(gesture), steps.value_or(std::numeric_limits<int>::max())),
          m_warning(std::move(warning))
    {
    }

    QString warning() const override
    {
        return m_warning.isEmpty() ? GrowthPerformance::warning() : m_warning;
    }
    const LassoGesture* lasso() const override { return static_cast<const LassoGesture*>(&gesture()); }

private:
    QString m_warning;
};

/// Stands for an operation that cannot be started.
class NoPerformance : public Performance {
public:
    explicit NoPerformance(QString warning) : m_warning(std::move(warning)) {}

    bool advance(double) override { return true; }
    QString warning() const override { return m_warning; }

private:
    QString m_warning;
};

/// Growth into envelopes. @p begun is the gesture, or an Error, which becomes the warning. @p warning is
/// another fault, found before the gesture began.
std::unique_ptr<Performance> performanceOf(LassoGesture::Begun begun, std::optional<int> steps = {},
                                           const QString& warning = {})
{
    if (!begun)
        return std::make_unique<NoPerformance>(begun.error().message);
    return std::make_unique<LassoPerformance>(std::move(*begun), steps, warning);
}

} // namespace

std::unique_ptr<Performance> LassoOperation::begin(TreeDocument& document) const
{
    const BudReference::Found found = only.resolve(document);
    return performanceOf(LassoGesture::fill(document, stroke, found.competitors), steps, found.warning);
}

std::unique_ptr<Performance> FillEnvelopesOperation::begin(TreeDocument& document) const
{
    const BudReference::Found found = only.resolve(document);
    return performanceOf(envelopes
                             ? LassoGesture::fillAll(document, *envelopes, parameters, found.competitors)
                             : LassoGesture::goOn(document, found.competitors),
                         steps, found.warning);
}

std::unique_ptr<Performance> RegrowOperation::begin(TreeDocument& document) const
{
    return performanceOf(LassoGesture::regrow(document));
}

QString RemoveLassoOperation::perform(TreeDocument& document) const
{
    return removeEnvelopes(document) ? QString() : RecipeText::tr("there is no envelope");
}

} // namespace espalier
