// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/DepthJson.h"

#include "commands/recipe/RecipeText.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr QLatin1StringView kSketchSeedKey("seed");
constexpr QLatin1StringView kTreesKey("trees");
constexpr QLatin1StringView kSidewaysKey("sideways");

struct SidewaysName {
    QLatin1StringView name;
    DepthOptions::Sideways sideways;
};
constexpr SidewaysName kSideways[] = {
    {QLatin1StringView("all"), DepthOptions::Sideways::All},
    {QLatin1StringView("limbs"), DepthOptions::Sideways::FirstOrder},
    {QLatin1StringView("none"), DepthOptions::Sideways::None},
};

struct Magnification {
    QLatin1StringView key;
    double DepthOptions::*value;
};
constexpr Magnification kMagnifications[] = {
    {QLatin1StringView("hull"), &DepthOptions::hullMagnification},
    {QLatin1StringView("length"), &DepthOptions::lengthMagnification},
    {QLatin1StringView("angle"), &DepthOptions::angleMagnification},
};

} // namespace

DepthOptions readDepth(JsonReader& reader)
{
    DepthOptions options;
    options.seed = reader.seed(kSketchSeedKey, 1);
    options.secondTree = reader.integer(kTreesKey, 1, 2, 2) == 2;
    const QString sideways = reader.text(kSidewaysKey, QString(kSideways[0].name));
    const auto* const named = std::ranges::find(kSideways, sideways, &SidewaysName::name);
    if (named == std::end(kSideways))
        reader.fail(kSidewaysKey,
                    RecipeText::tr("one of these is expected: %1").arg(QStringLiteral("all, limbs, none")));
    else
        options.sideways = named->sideways;
    for (const auto& [key, value] : kMagnifications)
        options.*value = reader.number(key, kLeastMagnification, kGreatestMagnification, options.*value);
    return options;
}

void writeDepth(QJsonObject& json, const DepthOptions& options)
{
    const DepthOptions usual;
    if (options.seed != usual.seed)
        json[kSketchSeedKey] = seedToJson(options.seed);
    if (!options.secondTree)
        json[kTreesKey] = 1;
    const auto* const named = std::ranges::find(kSideways, options.sideways, &SidewaysName::sideways);
    if (named != std::begin(kSideways))
        json[kSidewaysKey] = QString(named->name);
    for (const auto& [key, value] : kMagnifications) {
        if (options.*value != usual.*value)
            json[key] = options.*value;
    }
}

} // namespace espalier
