// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/PlaceLeafOperation.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeText.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr QLatin1StringView kLeafInternodeKey("internode");
constexpr QLatin1StringView kLeafAlongKey("along");
constexpr QLatin1StringView kLeafRotationKey("rotation");
constexpr QLatin1StringView kLeafLengthKey("length");
constexpr QLatin1StringView kLeafKindKey("kind");
constexpr double kLeastLeafLength = 1e-4; ///< kSmallestLeaf with few digits

struct LeafKindName {
    QLatin1StringView name;
    LeafKind kind;
};
constexpr LeafKindName kLeafKinds[] = {
    {QLatin1StringView("leaf"), LeafKind::Leaf},
    {QLatin1StringView("flower"), LeafKind::Flower},
    {QLatin1StringView("fruit"), LeafKind::Fruit},
};

} // namespace

PlaceLeafOperation PlaceLeafOperation::of(const TreeDocument& document, const LeafRow& leaf)
{
    return {.internode = InternodeReference::to(document, leaf.internode),
            .along = leaf.along,
            .rotation = leaf.rotation,
            .length = leaf.length,
            .kind = leaf.kind};
}

PlaceLeafOperation PlaceLeafOperation::read(JsonReader& reader, RecipeReading&)
{
    PlaceLeafOperation operation;
    operation.internode = InternodeReference::read(reader, kLeafInternodeKey);
    operation.along =
        static_cast<float>(reader.number(kLeafAlongKey, 0.0, 1.0, static_cast<double>(operation.along)));
    operation.rotation = readRotation(reader, kLeafRotationKey);
    operation.length =
        static_cast<float>(reader.number(kLeafLengthKey, kLeastLeafLength, double{kGreatestLeaf}));
    const QString kind = reader.text(kLeafKindKey, QString(kLeafKinds[0].name));
    const auto* const named = std::ranges::find(kLeafKinds, kind, &LeafKindName::name);
    if (named == std::end(kLeafKinds))
        reader.fail(
            kLeafKindKey,
            RecipeText::tr("one of these is expected: %1").arg(QStringLiteral("leaf, flower, fruit")));
    else
        operation.kind = named->kind;
    return operation;
}

QJsonObject PlaceLeafOperation::write(RecipeWriting&) const
{
    return {{kLeafInternodeKey, internode.toJson()},
            {kLeafAlongKey, shortestDouble(along)},
            {kLeafRotationKey, toJson<4>(rotation.coeffs())},
            {kLeafLengthKey, shortestDouble(length)},
            {kLeafKindKey, QString(std::ranges::find(kLeafKinds, kind, &LeafKindName::kind)->name)}};
}

LeafRow PlaceLeafOperation::leafAt(InternodeId id) const
{
    LeafRow leaf;
    leaf.internode = id;
    leaf.along = along;
    leaf.rotation = rotation;
    leaf.length = length;
    leaf.kind = kind;
    return leaf;
}

} // namespace espalier
