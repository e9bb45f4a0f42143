// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/MoveBranchOperation.h"

#include "commands/recipe/RecipeJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kMovedKey("internode");
constexpr QLatin1StringView kOntoKey("onto");
constexpr QLatin1StringView kOntoAlongKey("along");
constexpr QLatin1StringView kMoveRotationKey("rotation");
constexpr QLatin1StringView kMoveScaleKey("scale");

} // namespace

MoveBranchOperation MoveBranchOperation::of(const TreeDocument& document, const BranchMove& move)
{
    return {.internode = InternodeReference::to(document, move.branch),
            .onto = InternodeReference::to(document, move.place.internode),
            .along = move.place.along,
            .rotation = move.rotation,
            .scale = move.scale};
}

MoveBranchOperation MoveBranchOperation::read(JsonReader& reader, RecipeReading&)
{
    MoveBranchOperation operation;
    operation.internode = InternodeReference::read(reader, kMovedKey);
    operation.onto = InternodeReference::read(reader, kOntoKey);
    operation.along = static_cast<float>(reader.number(kOntoAlongKey, 0.0, 1.0, 1.0));
    operation.rotation = readRotation(reader, kMoveRotationKey);
    operation.scale =
        reader.number(kMoveScaleKey, BranchMove::kLeastScale, BranchMove::kMostScale, operation.scale);
    return operation;
}

QJsonObject MoveBranchOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kMovedKey, internode.toJson()},
                     {kOntoKey, onto.toJson()},
                     {kOntoAlongKey, shortestDouble(along)},
                     {kMoveRotationKey, toJson<4>(rotation.coeffs())}};
    if (scale != 1.0)
        json[kMoveScaleKey] = scale;
    return json;
}

} // namespace espalier
