// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/KeptEntries.h"

#include "model/io/JsonReader.h"
#include "model/io/ProfileJson.h"
#include "model/io/project/ColumnEntries.h"
#include "model/io/project/ProjectImages.h"
#include "model/io/project/ProjectLimits.h"
#include "model/io/project/ProjectText.h"

#include <QJsonDocument>

namespace espalier {

namespace {

constexpr std::uint64_t kMaximumJson = 64 << 20;

QByteArray entryOf(const QByteArray& name, const char* suffix)
{
    return "kept/" + name + suffix;
}

/// The array in an entry of the form {"name": […]}.
Result<QJsonArray> readArray(const ZipReader& archive, const QByteArray& entry, const QByteArray& name)
{
    const Result<QByteArray> text = archive.read(entry.constData(), kMaximumJson);
    if (!text)
        return text.error();
    const Result<QJsonObject> json = parseJsonObject(*text, kMaximumJson);
    if (!json)
        return inputError(QString::fromLatin1(entry), json.error().message);
    JsonReader reader(*json, {});
    QJsonArray array = reader.array(QLatin1StringView(name));
    if (const Result<void> end = reader.finish(); !end)
        return inputError(QString::fromLatin1(entry), end.error().message);
    return array;
}

} // namespace

void addKept(ZipWriter& archive, const QByteArray& name, const QList<TreeParameters>& sets)
{
    QJsonArray array;
    TreeParameters before;
    for (const TreeParameters& set : sets) {
        array.append(array.isEmpty() ? toJson(set) : toJson(set, before));
        before = set;
    }
    archive.add(entryOf(name, ".json"),
                QJsonDocument(QJsonObject{{QLatin1StringView(name), array}}).toJson());
}

Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<TreeParameters>& sets)
{
    const QByteArray entry = entryOf(name, ".json");
    const Result<QJsonArray> array = readArray(archive, entry, name);
    if (!array)
        return array.error();
    Result<QList<TreeParameters>> read = readParameterSets(*array, images);
    if (!read)
        return inputError(QString::fromLatin1(entry), read.error().message);
    sets = std::move(*read);
    return {};
}

Result<QList<TreeParameters>> readParameterSets(const QJsonArray& array, ProjectImages& images)
{
    if (array.isEmpty() || array.size() > kMostParameterSets)
        return inputError(QStringLiteral("parameterSets"),
                          ProjectText::tr("1 to %1 sets are expected").arg(kMostParameterSets));
    QList<TreeParameters> sets;
    TreeParameters before = parametersOfFirstFiles();
    for (qsizetype i = 0; i < array.size(); ++i) {
        const QString place = QStringLiteral("parameterSets[%1]").arg(i);
        if (!array.at(i).isObject())
            return inputError(place, ProjectText::tr("an object is expected"));
        const Result<TreeParameters> set =
            fromJson(array.at(i).toObject(), before, place,
                     [&images](const QString& hash) { return images.find(hash); });
        if (!set)
            return set.error();
        before = *set;
        sets.append(before);
    }
    return sets;
}

void addKept(ZipWriter& archive, const QByteArray& name, const QList<LassoStroke>& strokes)
{
    if (strokes.isEmpty())
        return;
    QList<Vec3> origin;
    QList<Vec3> right;
    QList<Vec3> up;
    QList<std::uint32_t> pointCount;
    QList<Vec2> points;
    for (const LassoStroke& stroke : strokes) {
        origin.append(stroke.origin);
        right.append(stroke.right);
        up.append(stroke.up);
        pointCount.append(static_cast<std::uint32_t>(stroke.points.size()));
        for (const Vec2& point : stroke.points)
            points.append(point);
    }
    addEntry(archive, entryOf(name, ".origin"), origin);
    addEntry(archive, entryOf(name, ".right"), right);
    addEntry(archive, entryOf(name, ".up"), up);
    addEntry(archive, entryOf(name, ".pointCount"), pointCount);
    addEntry(archive, entryOf(name, ".points"), points);
}

Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& /*images*/,
                      QList<LassoStroke>& strokes)
{
    if (!archive.contains(entryOf(name, ".pointCount").constData()))
        return {};
    return readLassoColumns(archive, entryOf(name, "."), strokes);
}

Result<void> readLassoColumns(const ZipReader& archive, const QByteArray& prefix, QList<LassoStroke>& strokes)
{
    const QByteArray countName = prefix + "pointCount";
    const Result<QByteArray> bytes =
        archive.read(countName.constData(), std::uint64_t{projectLimits::kLassos} * sizeof(std::uint32_t));
    if (!bytes)
        return bytes.error();
    const auto count =
        static_cast<std::uint32_t>(bytes->size() / static_cast<qsizetype>(sizeof(std::uint32_t)));
    QList<std::uint32_t> pointCount;
    QList<Vec3> origin;
    QList<Vec3> right;
    QList<Vec3> up;
    Result<void> read = readEntry(archive, countName, count, pointCount);
    if (read)
        read = readEntry(archive, prefix + "origin", count, origin);
    if (read)
        read = readEntry(archive, prefix + "right", count, right);
    if (read)
        read = readEntry(archive, prefix + "up", count, up);
    if (!read)
        return read;
    std::uint64_t sum = 0;
    for (const std::uint32_t each : pointCount) {
        sum += each;
        if (each > kMostLassoPoints || sum > projectLimits::kLassoPoints)
            return inputError(ProjectText::tr("the lassos"), ProjectText::tr("they have too many points"));
    }
    QList<Vec2> points;
    read = readEntry(archive, prefix + "points", static_cast<std::uint32_t>(sum), points);
    if (!read)
        return read;
    auto first = points.cbegin();
    for (qsizetype i = 0; i < origin.size(); ++i) {
        const auto last = first + pointCount[i];
        strokes.append({origin[i], right[i], up[i], {first, last}});
        first = last;
    }
    return {};
}

void addKept(ZipWriter& archive, const QByteArray& name, const QList<StrandProfile>& profiles)
{
    if (profiles.isEmpty())
        return;
    QJsonArray array;
    for (const StrandProfile& profile : profiles)
        array.append(profileToJson(profile));
    archive.add(entryOf(name, ".json"),
                QJsonDocument(QJsonObject{{QLatin1StringView(name), array}}).toJson(QJsonDocument::Compact));
}

Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& /*images*/,
                      QList<StrandProfile>& profiles)
{
    const QByteArray entry = entryOf(name, ".json");
    if (!archive.contains(entry.constData()))
        return {};
    const Result<QJsonArray> array = readArray(archive, entry, name);
    if (!array)
        return array.error();
    if (array->size() > qsizetype{projectLimits::kProfiles})
        return inputError(ProjectText::tr("the profiles"), ProjectText::tr("there are too many"));
    for (qsizetype i = 0; i < array->size(); ++i) {
        const Result<StrandProfile> profile =
            readProfile(array->at(i), QStringLiteral("%1[%2]").arg(QString::fromLatin1(name)).arg(i));
        if (!profile)
            return profile.error();
        profiles.append(*profile);
    }
    return {};
}

} // namespace espalier
