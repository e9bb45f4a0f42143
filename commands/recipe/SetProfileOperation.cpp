// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/SetProfileOperation.h"

#include "commands/recipe/RecipeText.h"
#include "model/io/ProfileJson.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kProfileInternodesKey("internodes");
constexpr QLatin1StringView kProfileKey("profile");
constexpr QLatin1StringView kClearKey("clear");
constexpr QLatin1StringView kToKey("to");
constexpr QLatin1StringView kToProfileKey("toProfile");

std::optional<StrandProfile> profileFrom(JsonReader& reader, QLatin1StringView key)
{
    const Result<StrandProfile> profile = readProfile(reader.value(key), reader.placeOf(key));
    if (profile)
        return *profile;
    reader.fail(profile.error());
    return {};
}

} // namespace

SetProfileOperation SetProfileOperation::read(JsonReader& reader, RecipeReading&)
{
    SetProfileOperation operation;
    const QJsonArray array = reader.array(kProfileInternodesKey);
    if (array.isEmpty() || array.size() > kMostNodes)
        reader.fail(kProfileInternodesKey, RecipeText::tr("1 to %1 internodes are expected").arg(kMostNodes));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const Result<InternodeReference> reference = InternodeReference::fromJson(array.at(i));
        if (!reference) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kProfileInternodesKey)).arg(i),
                                   reference.error().message));
            break;
        }
        operation.internodes.push_back(*reference);
    }
    if (reader.has(kToKey)) {
        operation.to = InternodeReference::read(reader, kToKey);
        if (array.size() > 1)
            reader.fail(kToKey, RecipeText::tr("a branch must begin at exactly one internode"));
    }
    if (reader.has(kClearKey)) {
        if (reader.value(kClearKey) != QJsonValue(true))
            reader.fail(kClearKey, RecipeText::tr("true is expected"));
    } else {
        operation.profile = profileFrom(reader, kProfileKey);
        if (reader.has(kToProfileKey)) {
            operation.toProfile = profileFrom(reader, kToProfileKey);
            if (!operation.to)
                reader.fail(kToProfileKey, RecipeText::tr("the other end of the branch (“to”) is missing"));
        }
    }
    return operation;
}

QJsonObject SetProfileOperation::write(RecipeWriting&) const
{
    QJsonArray array;
    for (const InternodeReference& internode : internodes)
        array.append(internode.toJson());
    QJsonObject json{{kProfileInternodesKey, array}};
    if (profile)
        json[kProfileKey] = profileToJson(*profile);
    else
        json[kClearKey] = true;
    if (to)
        json[kToKey] = to->toJson();
    if (toProfile)
        json[kToProfileKey] = profileToJson(*toProfile);
    return json;
}

} // namespace espalier
