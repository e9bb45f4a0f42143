// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SetWidthOperation.h"

#include "commands/WidthGesture.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kWidthInternodeKey("internode");
constexpr QLatin1StringView kDiameterKey("diameter");

} // namespace

SetWidthOperation SetWidthOperation::read(JsonReader& reader, RecipeReading&)
{
    return {InternodeReference::read(reader, kWidthInternodeKey),
            reader.number(kDiameterKey, 0.0, kGreatestDiameter)};
}

QJsonObject SetWidthOperation::write(RecipeWriting&) const
{
    return {{kWidthInternodeKey, internode.toJson()}, {kDiameterKey, diameter}};
}

QString SetWidthOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    if (diameter == 0.0 && document.tree().widthConstraint(*id) == 0.0F)
        return RecipeText::tr("internode %1 has no width to take away").arg(*id);
    setWidth(document, *id, diameter);
    return {};
}

} // namespace espalier
