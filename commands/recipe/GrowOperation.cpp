// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/GrowOperation.h"

#include "commands/GrowGesture.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kStepsKey("steps");

class FreeGrowthPerformance : public GrowthPerformance {
public:
    FreeGrowthPerformance(TreeDocument& document, int steps, BudReference::Found only)
        : GrowthPerformance(std::make_unique<GrowGesture>(document, only.competitors), steps),
          m_warning(std::move(only.warning))
    {
    }

    QString warning() const override
    {
        return m_warning.isEmpty() && gesture().stepCount() == 0 ? RecipeText::tr("nothing grew") : m_warning;
    }

private:
    QString m_warning;
};

} // namespace

GrowOperation GrowOperation::read(JsonReader& reader, RecipeReading&)
{
    return {static_cast<int>(reader.integer(kStepsKey, 1, kMostSteps)), BudReference::read(reader)};
}

QJsonObject GrowOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kStepsKey, steps}};
    only.write(json);
    return json;
}

std::unique_ptr<Performance> GrowOperation::begin(TreeDocument& document) const
{
    return std::make_unique<FreeGrowthPerformance>(document, steps, only.resolve(document));
}

} // namespace espalier
