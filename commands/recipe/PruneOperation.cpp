// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/PruneOperation.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kInternodesKey("internodes");

} // namespace

PruneOperation PruneOperation::read(JsonReader& reader, RecipeReading&)
{
    const QJsonArray array = reader.array(kInternodesKey);
    PruneOperation prune;
    if (array.isEmpty() || array.size() > kMostCuts)
        reader.fail(kInternodesKey, RecipeText::tr("1 to %1 internodes are expected").arg(kMostCuts));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const Result<InternodeReference> reference = InternodeReference::fromJson(array.at(i));
        if (!reference) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kInternodesKey)).arg(i),
                                   reference.error().message));
            break;
        }
        prune.internodes.push_back(*reference);
    }
    return prune;
}

QJsonObject PruneOperation::write(RecipeWriting&) const
{
    QJsonArray array;
    for (const InternodeReference& internode : internodes)
        array.append(internode.toJson());
    return {{kInternodesKey, array}};
}

} // namespace espalier
