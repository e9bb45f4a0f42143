// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/PropagateOperation.h"

#include "commands/recipe/RecipeText.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr QLatin1StringView kReferenceKey("internode");
constexpr QLatin1StringView kTargetsKey("targets");
constexpr QLatin1StringView kScalingKey("scaling");
constexpr QLatin1StringView kReplacesKey("replaces");

struct TargetsName {
    QLatin1StringView name;
    Propagation::Targets targets;
};
constexpr TargetsName kTargets[] = {
    {QLatin1StringView("all"), Propagation::Targets::All},
    {QLatin1StringView("sameOrder"), Propagation::Targets::SameOrder},
};

bool readSwitch(JsonReader& reader, QLatin1StringView key, bool fallback)
{
    if (!reader.has(key))
        return fallback;
    const QJsonValue value = reader.value(key);
    if (!value.isBool())
        reader.fail(key, RecipeText::tr("true or false is expected"));
    return value.toBool();
}

void readListed(JsonReader& reader, const QJsonArray& array, std::vector<InternodeReference>& axes)
{
    if (array.isEmpty() || static_cast<std::size_t>(array.size()) > Propagation::kMostListed) {
        reader.fail(kTargetsKey, RecipeText::tr("1 to %1 internodes are expected")
                                     .arg(static_cast<qsizetype>(Propagation::kMostListed)));
        return;
    }
    for (qsizetype i = 0; i < array.size(); ++i) {
        const Result<InternodeReference> reference = InternodeReference::fromJson(array.at(i));
        if (!reference) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kTargetsKey)).arg(i),
                                   reference.error().message));
            return;
        }
        axes.push_back(*reference);
    }
}

} // namespace

PropagateOperation PropagateOperation::of(const TreeDocument& document, const Propagation& propagation)
{
    PropagateOperation operation{.internode = InternodeReference::to(document, propagation.reference),
                                 .targets = propagation.targets,
                                 .axes = {},
                                 .scaling = propagation.scaling,
                                 .replaces = propagation.replaces};
    if (propagation.targets != Propagation::Targets::Listed)
        return operation;
    for (const InternodeId id : propagation.axes) {
        if (document.tree().isAlive(id))
            operation.axes.push_back(InternodeReference::to(document, id));
    }
    return operation;
}

PropagateOperation PropagateOperation::read(JsonReader& reader, RecipeReading&)
{
    PropagateOperation operation;
    operation.internode = InternodeReference::read(reader, kReferenceKey);
    operation.scaling = readSwitch(reader, kScalingKey, true);
    operation.replaces = readSwitch(reader, kReplacesKey, false);
    if (!reader.has(kTargetsKey))
        return operation;
    const QJsonValue value = reader.value(kTargetsKey);
    if (value.isArray()) {
        operation.targets = Propagation::Targets::Listed;
        readListed(reader, value.toArray(), operation.axes);
        return operation;
    }
    const auto* const named = std::ranges::find(kTargets, value.toString(), &TargetsName::name);
    if (named == std::end(kTargets))
        reader.fail(kTargetsKey, RecipeText::tr("one of these is expected: %1")
                                     .arg(QStringLiteral("all, sameOrder, [internode, …]")));
    else
        operation.targets = named->targets;
    return operation;
}

QJsonObject PropagateOperation::write(RecipeWriting&) const
{
    QJsonObject json{{kReferenceKey, internode.toJson()}};
    if (targets == Propagation::Targets::Listed) {
        QJsonArray array;
        for (const InternodeReference& axis : axes)
            array.append(axis.toJson());
        json[kTargetsKey] = array;
    } else if (targets == Propagation::Targets::SameOrder) {
        json[kTargetsKey] = QString(kTargets[1].name);
    }
    if (!scaling)
        json[kScalingKey] = false;
    if (replaces)
        json[kReplacesKey] = true;
    return json;
}

} // namespace espalier
