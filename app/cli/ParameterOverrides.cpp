// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/ParameterOverrides.h"

#include "commands/recipe/SetParametersOperation.h"
#include "model/io/ParametersJson.h"
#include "panels/ParameterValue.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

namespace espalier {

namespace {

struct OverrideText {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

/// The greatest share of the ellipse's half-axis that its offset may be; see fromJson().
constexpr double kGreatestOffsetShare = 0.99;

/// The value that a text stands for, as JSON has it; fromJson() finds what is wrong with it.
QJsonValue valueOf(const ParameterInfo& info, const QString& text)
{
    if (info.quantity == Quantity::Switch) {
        if (text == QLatin1String("true") || text == QLatin1String("false"))
            return text == QLatin1String("true");
        return text;
    }
    if (info.quantity == Quantity::Choice)
        return text;
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber && std::isfinite(number) ? QJsonValue(number) : QJsonValue(text);
}

/// Parameters that leave as much room as possible to each value alone.
TreeParameters roomyParameters()
{
    TreeParameters roomy;
    roomy.growth.ellipseOffset = 0.0;
    visitParameters(roomy, [&](const ParameterInfo& info, auto&) {
        if (QLatin1StringView(info.key) == QLatin1StringView("growth.ellipseVertical"))
            roomy.growth.ellipseVertical = info.maximum;
    });
    return roomy;
}

template <class T>
void assignSame(T& field, const T& value)
{
    field = value;
}
/// Parameters of one name have one type.
template <class T, class U>
void assignSame(T&, const U&)
{
}

/// A direction weight, and whether the command line gives it.
struct Weight {
    double* value;
    bool isGiven;
};

void makeRoomForGiven(std::span<const Weight> weights)
{
    double given = 0.0;
    double others = 0.0;
    std::ptrdiff_t count = 0;
    for (const Weight& weight : weights) {
        (weight.isGiven ? given : others) += *weight.value;
        count += weight.isGiven ? 0 : 1;
    }
    const double rest = std::max(0.0, 1.0 - given);
    for (const Weight& weight : weights) {
        if (!weight.isGiven)
            *weight.value = others > 0.0 ? *weight.value * rest / others : rest / static_cast<double>(count);
    }
}

} // namespace

Result<void> ParameterOverrides::add(const QString& text)
{
    const auto equals = text.indexOf(QLatin1Char('='));
    const QString key = text.left(equals).trimmed();
    if (equals < 1)
        return inputError({}, OverrideText::tr("--set needs group.name=value, not \"%1\"").arg(text));
    std::optional<QJsonValue> value;
    const TreeParameters roomy = roomyParameters();
    visitParameters(roomy, [&](const ParameterInfo& info, const auto&) {
        if (key == QLatin1StringView(info.key))
            value = valueOf(info, text.mid(equals + 1).trimmed());
    });
    if (!value)
        return inputError({}, OverrideText::tr("--set: there is no parameter \"%1\"").arg(key));
    const QString group = key.section(QLatin1Char('.'), 0, 0);
    QJsonObject members = m_values.value(group).toObject();
    members[key.section(QLatin1Char('.'), 1)] = *value;
    QJsonObject values = m_values;
    values[group] = members;
    const QString place = QStringLiteral("--set");
    if (const Result<TreeParameters> read = fromJson(values, roomy, place); !read) {
        // "--set growth.shedding", as it stands on the command line.
        QString message = read.error().message;
        if (message.startsWith(place + QLatin1Char('.')))
            message[place.size()] = QLatin1Char(' ');
        return inputError({}, message);
    }
    m_values = values;
    return {};
}

bool ParameterOverrides::has(const char* key) const
{
    const QString text = QString::fromLatin1(key);
    return m_values.value(text.section(QLatin1Char('.'), 0, 0))
        .toObject()
        .contains(text.section(QLatin1Char('.'), 1));
}

TreeParameters ParameterOverrides::appliedTo(const TreeParameters& parameters) const
{
    if (isEmpty())
        return parameters;
    // The values do not contradict each other, so they can be read on parameters that contradict none.
    const Result<TreeParameters> read = fromJson(m_values, roomyParameters(), {});
    Q_ASSERT(read);
    TreeParameters result = parameters;
    visitParameters(*read, [&](const ParameterInfo& info, const auto& given) {
        if (!has(info.key))
            return;
        visitParameter(result, info.key,
                       [&](const ParameterInfo&, auto& field) { assignSame(field, given); });
    });
    GrowthParameters& growth = result.growth;
    const Weight weights[] = {{&growth.axisWeight, has("growth.axisWeight")},
                              {&growth.tropismWeight, has("growth.tropismWeight")},
                              {&growth.spaceWeight, has("growth.spaceWeight")}};
    if (std::ranges::any_of(weights, &Weight::isGiven)) {
        makeRoomForGiven(weights);
        normaliseDirectionWeights(growth);
    }
    if (has("growth.ellipseOffset"))
        growth.ellipseVertical =
            std::max(growth.ellipseVertical, std::abs(growth.ellipseOffset) / kGreatestOffsetShare);
    const double most = kGreatestOffsetShare * growth.ellipseVertical;
    growth.ellipseOffset = std::clamp(growth.ellipseOffset, -most, most);
    return result;
}

void ParameterOverrides::applyTo(Recipe& recipe) const
{
    if (isEmpty())
        return;
    recipe.parameters = appliedTo(recipe.parameters);
    for (RecipeOperation& operation : recipe.operations) {
        if (const auto* set = operation.as<SetParametersOperation>())
            operation = SetParametersOperation{appliedTo(set->parameters)};
    }
}

} // namespace espalier
