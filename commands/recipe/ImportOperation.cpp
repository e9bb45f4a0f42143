// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/ImportOperation.h"

#include "commands/recipe/RecipeText.h"

#include <cmath>

namespace espalier {

namespace {

constexpr QLatin1StringView kFileKey("file");
constexpr QLatin1StringView kSegmentsKey("segments");
/// Of a segment in JSON: the index of its parent or -1, both ends, and the radius.
constexpr qsizetype kNumbers = 8;

/// Returns a sentence if @p json is no segment.
Result<SkeletonSegment> segmentOf(const QJsonValue& json, std::size_t index)
{
    const QJsonArray numbers = json.toArray();
    bool areNumbers = numbers.size() == kNumbers;
    for (const QJsonValue& number : numbers)
        areNumbers = areNumbers && number.isDouble();
    if (!areNumbers)
        return Error{Error::Kind::Input, RecipeText::tr("%1 numbers are expected").arg(kNumbers)};
    const double parent = numbers[0].toDouble();
    if (parent != std::floor(parent) || parent < -1.0 || parent >= static_cast<double>(index))
        return Error{Error::Kind::Input,
                     RecipeText::tr("its parent is neither one of the segments before it nor -1")};
    const auto at = [&](qsizetype i) { return static_cast<float>(numbers[i].toDouble()); };
    const SkeletonSegment segment{.parent = parent < 0.0 ? kNoInternode : static_cast<std::uint32_t>(parent),
                                  .base = {at(1), at(2), at(3)},
                                  .tip = {at(4), at(5), at(6)},
                                  .radius = at(7)};
    if (const QString fault = segmentFault(segment); !fault.isEmpty())
        return Error{Error::Kind::Input, fault};
    return segment;
}

} // namespace

ImportOperation ImportOperation::read(JsonReader& reader, RecipeReading& reading)
{
    ImportOperation operation;
    if (reader.has(kFileKey)) {
        Result<Skeleton> skeleton = reading.readSkeleton(reader.text(kFileKey));
        if (skeleton)
            operation.skeleton = std::move(*skeleton);
        else
            reader.fail(inputError(reader.placeOf(kFileKey), skeleton.error().message));
        return operation;
    }
    const QJsonArray array = reader.array(kSegmentsKey);
    if (array.isEmpty() || static_cast<std::size_t>(array.size()) > kMostSegments)
        reader.fail(kSegmentsKey, RecipeText::tr("1 to %1 segments are expected").arg(kMostSegments));
    for (qsizetype i = 0; i < array.size(); ++i) {
        const Result<SkeletonSegment> segment = segmentOf(array.at(i), static_cast<std::size_t>(i));
        if (!segment) {
            reader.fail(inputError(QStringLiteral("%1[%2]").arg(reader.placeOf(kSegmentsKey)).arg(i),
                                   segment.error().message));
            break;
        }
        operation.skeleton.push_back(*segment);
    }
    return operation;
}

QJsonObject ImportOperation::write(RecipeWriting&) const
{
    QJsonArray segments;
    for (const SkeletonSegment& segment : skeleton) {
        QJsonArray numbers{segment.parent == kNoInternode ? -1.0 : static_cast<double>(segment.parent)};
        for (const Vec3& end : {segment.base, segment.tip}) {
            for (const float coordinate : end)
                numbers.append(static_cast<double>(coordinate));
        }
        numbers.append(static_cast<double>(segment.radius));
        segments.append(numbers);
    }
    return {{kSegmentsKey, segments}};
}

} // namespace espalier
