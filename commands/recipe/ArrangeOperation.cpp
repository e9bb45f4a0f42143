// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/ArrangeOperation.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeText.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr QLatin1StringView kEngineKey("engine");
constexpr QLatin1StringView kArrangeInternodeKey("internode");
constexpr QLatin1StringView kArrangeAlongKey("along");

/// In the order of LeafEngine.
constexpr QLatin1StringView kEngineNames[] = {
    QLatin1StringView("addToWhorl"), QLatin1StringView("extendWhorls"), QLatin1StringView("alternate"),
    QLatin1StringView("opposite"),   QLatin1StringView("decussate"),
};
static_assert(std::size(kEngineNames) == kLeafEngines.size());

} // namespace

QLatin1StringView ArrangeOperation::nameOf(LeafEngine engine)
{
    return kEngineNames[static_cast<std::size_t>(engine)];
}

ArrangeOperation ArrangeOperation::read(JsonReader& reader, RecipeReading&)
{
    ArrangeOperation operation;
    const QString name = reader.text(kEngineKey);
    const auto* const named = std::ranges::find(kEngineNames, name);
    if (named == std::end(kEngineNames))
        reader.fail(kEngineKey,
                    RecipeText::tr("one of these is expected: %1")
                        .arg(QStringLiteral("addToWhorl, extendWhorls, alternate, opposite, decussate")));
    else
        operation.engine = kLeafEngines[static_cast<std::size_t>(named - std::begin(kEngineNames))];
    operation.internode = InternodeReference::read(reader, kArrangeInternodeKey);
    operation.along =
        static_cast<float>(reader.number(kArrangeAlongKey, 0.0, 1.0, static_cast<double>(operation.along)));
    return operation;
}

QJsonObject ArrangeOperation::write(RecipeWriting&) const
{
    return {{kEngineKey, QString(nameOf(engine))},
            {kArrangeInternodeKey, internode.toJson()},
            {kArrangeAlongKey, shortestDouble(along)}};
}

} // namespace espalier
