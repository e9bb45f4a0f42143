// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/AddBudsOperation.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kBudsInternodeKey("internode");
constexpr QLatin1StringView kBudCountKey("count");
constexpr QLatin1StringView kBudSpacingKey("spacing");
constexpr QLatin1StringView kBudsAlongKey("along");
constexpr QLatin1StringView kBudsAzimuthKey("azimuth");
constexpr double kGreatestAzimuth = 360.0;

} // namespace

AddBudsOperation AddBudsOperation::of(const TreeDocument& document, const BudSpiral& spiral)
{
    return {.internode = InternodeReference::to(document, spiral.internode),
            .count = spiral.count,
            .spacing = spiral.spacing,
            .along = spiral.along,
            .azimuth = spiral.azimuth};
}

AddBudsOperation AddBudsOperation::read(JsonReader& reader, RecipeReading&)
{
    const AddBudsOperation usual;
    return {.internode = InternodeReference::read(reader, kBudsInternodeKey),
            .count = static_cast<int>(reader.integer(kBudCountKey, 1, BudSpiral::kMostBuds, usual.count)),
            .spacing = reader.number(kBudSpacingKey, 0.0, BudSpiral::kGreatestSpacing, usual.spacing),
            .along = reader.number(kBudsAlongKey, 0.0, 1.0, usual.along),
            .azimuth = reader.number(kBudsAzimuthKey, -kGreatestAzimuth, kGreatestAzimuth, usual.azimuth)};
}

QJsonObject AddBudsOperation::write(RecipeWriting&) const
{
    return {{kBudsInternodeKey, internode.toJson()},
            {kBudCountKey, count},
            {kBudSpacingKey, spacing},
            {kBudsAlongKey, along},
            {kBudsAzimuthKey, azimuth}};
}

BudSpiral AddBudsOperation::spiralAt(InternodeId id) const
{
    return {.internode = id, .along = along, .azimuth = azimuth, .count = count, .spacing = spacing};
}

} // namespace espalier
