// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/VaryOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kVarySeedKey("seed");
constexpr QLatin1StringView kAmountKey("amount");

} // namespace

VaryOperation VaryOperation::read(JsonReader& reader, RecipeReading&)
{
    return {.seed = reader.seed(kVarySeedKey, 1),
            .amount = reader.number(kAmountKey, kLeastAmount, 1.0, VaryOperation().amount)};
}

QJsonObject VaryOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kAmountKey, amount}};
    if (seed != 1)
        json[kVarySeedKey] = seedToJson(seed);
    return json;
}

} // namespace espalier
