// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/BendOperation.h"

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
constexpr QLatin1StringView kMovesKey("moves");
constexpr QLatin1StringView kTargetsKey("targets");
constexpr QLatin1StringView kCallsKey("calls");
constexpr QLatin1StringView kRegripsKey("regrips");

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

QJsonArray targetsToJson(std::span<const Vec3> targets)
{
    QJsonArray array;
    for (const Vec3& target : targets)
        array.append(toJson(target));
    return array;
}

/// Reads element @p index of the array @p key of @p parent: an object whose members @p read reads.
template <class Read>
void readMember(JsonReader& parent, QLatin1StringView key, const QJsonArray& array, qsizetype index,
                const Read& read)
{
    const QString place = QStringLiteral("%1[%2]").arg(parent.placeOf(key)).arg(index);
    if (!array.at(index).isObject()) {
        parent.fail(inputError(place, RecipeText::tr("an object is expected")));
        return;
    }
    JsonReader reader(array.at(index).toObject(), place);
    read(reader);
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
}

BendOperation::Move readMove(JsonReader& reader, std::size_t handles, RecipeReading& reading)
{
    BendOperation::Move move;
    if (reader.has(kCallsKey))
        move.calls = static_cast<int>(reader.integer(kCallsKey, 1, BendOperation::kMostCalls));
    const QJsonArray array = reader.array(kTargetsKey);
    if (!reading.admitSamples(reader, kTargetsKey, array.size()))
        return move;
    if (array.size() != static_cast<qsizetype>(handles))
        reader.fail(kTargetsKey, RecipeText::tr("a target for each handle is expected"));
    for (const QJsonValue& value : array) {
        const auto target = vectorFromJson<3>(value.toArray(), recipeLimits::kCoordinate);
        if (!target) {
            reader.fail(kTargetsKey, RecipeText::tr("arrays of three numbers within ±%1 are expected")
                                         .arg(recipeLimits::kCoordinate));
            break;
        }
        move.targets.push_back(*target);
    }
    return move;
}

BendOperation::Grip readGrip(JsonReader& reader, RecipeReading& reading)
{
    BendOperation::Grip grip;
    grip.base = InternodeReference::read(reader, kBaseKey);
    const QJsonArray handles = reader.array(kHandlesKey);
    if (handles.isEmpty() || handles.size() > BendOperation::kMostHandles)
        reader.fail(kHandlesKey,
                    RecipeText::tr("a bend needs 1 to %1 handles").arg(BendOperation::kMostHandles));
    for (qsizetype i = 0; i < std::min(handles.size(), BendOperation::kMostHandles); ++i) {
        readMember(reader, kHandlesKey, handles, i,
                   [&](JsonReader& handle) { grip.handles.push_back(readHandle(handle)); });
    }
    if (!reader.has(kMovesKey))
        return grip;
    const QJsonArray moves = reader.array(kMovesKey);
    if (moves.size() > BendOperation::kMostMoves)
        reader.fail(kMovesKey, RecipeText::tr("there are more than %1").arg(BendOperation::kMostMoves));
    for (qsizetype i = 0; i < std::min(moves.size(), BendOperation::kMostMoves); ++i) {
        readMember(reader, kMovesKey, moves, i, [&](JsonReader& move) {
            grip.moves.push_back(readMove(move, grip.handles.size(), reading));
        });
    }
    return grip;
}

QJsonObject gripToJson(const InternodeReference& base, std::span<const BendOperation::Handle> handles,
                       std::span<const BendOperation::Move> moves)
{
    QJsonArray handleArray;
    for (const BendOperation::Handle& handle : handles) {
        handleArray.append(QJsonObject{{kInternodeKey, handle.internode.toJson()},
                                       {kAlongKey, handle.along},
                                       {kTargetKey, toJson(handle.target)}});
    }
    QJsonObject json{{kBaseKey, base.toJson()}, {kHandlesKey, handleArray}};
    if (moves.empty())
        return json;
    QJsonArray moveArray;
    for (const BendOperation::Move& move : moves) {
        QJsonObject object{{kTargetsKey, targetsToJson(move.targets)}};
        if (move.calls)
            object[kCallsKey] = *move.calls;
        moveArray.append(object);
    }
    json[kMovesKey] = moveArray;
    return json;
}

} // namespace

BendOperation BendOperation::read(JsonReader& reader, RecipeReading& reading)
{
    Grip first = readGrip(reader, reading);
    BendOperation bend{std::move(first.base), std::move(first.handles), std::move(first.moves)};
    bend.bending = reader.number(kBendingKey, kLeastWeight, kGreatestWeight, bend.bending);
    bend.stretching = reader.number(kStretchingKey, kLeastWeight, kGreatestWeight, bend.stretching);
    if (!reader.has(kRegripsKey))
        return bend;
    const QJsonArray regrips = reader.array(kRegripsKey);
    if (regrips.size() > kMostGrips)
        reader.fail(kRegripsKey, RecipeText::tr("there are more than %1").arg(kMostGrips));
    for (qsizetype i = 0; i < std::min(regrips.size(), kMostGrips); ++i) {
        readMember(reader, kRegripsKey, regrips, i,
                   [&](JsonReader& grip) { bend.regrips.push_back(readGrip(grip, reading)); });
    }
    return bend;
}

QJsonObject BendOperation::write(RecipeWriting&) const
{
    QJsonObject json = gripToJson(base, handles, moves);
    json[kBendingKey] = bending;
    json[kStretchingKey] = stretching;
    if (regrips.empty())
        return json;
    QJsonArray array;
    for (const Grip& grip : regrips)
        array.append(gripToJson(grip.base, grip.handles, grip.moves));
    json[kRegripsKey] = array;
    return json;
}

} // namespace espalier
