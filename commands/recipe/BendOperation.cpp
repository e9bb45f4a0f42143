// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/BendOperation.h"

#include "commands/BendGesture.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kBaseKey("base");
constexpr QLatin1StringView kHandlesKey("handles");
constexpr QLatin1StringView kBendingKey("bending");
constexpr QLatin1StringView kStretchingKey("stretching");
constexpr QLatin1StringView kInternodeKey("internode");
constexpr QLatin1StringView kAlongKey("along");
constexpr QLatin1StringView kTargetKey("target");

BendOperation::Handle readHandle(JsonReader& reader)
{
    BendOperation::Handle handle;
    handle.internode = InternodeReference::read(reader, kInternodeKey);
    handle.along = reader.number(kAlongKey, 0.0, 1.0, handle.along);
    if (const auto target = vectorFromJson<3>(reader.array(kTargetKey), recipeLimits::kCoordinate))
        handle.target = *target;
    else
        reader.fail(kTargetKey, RecipeText::tr("an array of three numbers within ±%1 is expected")
                                    .arg(recipeLimits::kCoordinate));
    return handle;
}

} // namespace

BendOperation BendOperation::read(JsonReader& reader, RecipeReading&)
{
    BendOperation bend;
    bend.base = InternodeReference::read(reader, kBaseKey);
    bend.bending = reader.number(kBendingKey, kLeastWeight, kGreatestWeight, bend.bending);
    bend.stretching = reader.number(kStretchingKey, kLeastWeight, kGreatestWeight, bend.stretching);
    const QJsonArray array = reader.array(kHandlesKey);
    if (array.isEmpty() || array.size() > kMostHandles)
        reader.fail(kHandlesKey, RecipeText::tr("a bend has from 1 to %1 handles").arg(kMostHandles));
    for (qsizetype i = 0; i < std::min(array.size(), kMostHandles); ++i) {
        const QString place = QStringLiteral("%1[%2]").arg(reader.placeOf(kHandlesKey)).arg(i);
        if (!array.at(i).isObject()) {
            reader.fail(inputError(place, RecipeText::tr("an object is expected")));
            break;
        }
        JsonReader handle(array.at(i).toObject(), place);
        bend.handles.push_back(readHandle(handle));
        if (const Result<void> end = handle.finish(); !end)
            reader.fail(end.error());
    }
    return bend;
}

QJsonObject BendOperation::write(RecipeWriting&) const
{
    QJsonArray array;
    for (const Handle& handle : handles) {
        array.append(QJsonObject{{kInternodeKey, handle.internode.toJson()},
                                 {kAlongKey, handle.along},
                                 {kTargetKey, toJson(handle.target)}});
    }
    return {{kBaseKey, base.toJson()},
            {kHandlesKey, array},
            {kBendingKey, bending},
            {kStretchingKey, stretching}};
}

QString BendOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> baseId = base.resolve(document);
    if (!baseId)
        return baseId.error().message;
    QStringList faults;
    std::vector<BranchBend::Handle> held;
    std::vector<Vec3> targets;
    for (const Handle& handle : handles) {
        const Result<InternodeId> id = handle.internode.resolve(document);
        if (!id) {
            faults.append(id.error().message);
            continue;
        }
        held.push_back({*id, handle.along});
        targets.push_back(handle.target);
    }
    BendGesture gesture(document, *baseId, held, {.stretching = stretching, .bending = bending});
    // The path begins with the base, which no handle moves.
    const std::span<const InternodeId> path = gesture.path();
    for (const BranchBend::Handle& handle : held) {
        if (path.empty() || std::ranges::find(path.subspan(1), handle.id) == path.end())
            faults.append(RecipeText::tr("internode %1 is not on the branch above internode %2")
                              .arg(handle.id)
                              .arg(*baseId));
    }
    gesture.settleAt(targets);
    gesture.finish();
    return joinedFaults(faults);
}

} // namespace espalier
