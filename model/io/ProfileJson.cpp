// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ProfileJson.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>

#include <optional>

namespace espalier {

namespace {

struct ProfileJsonText {
    Q_DECLARE_TR_FUNCTIONS(ProfileJson)
};

constexpr QLatin1StringView kBoundariesKey("boundaries");
constexpr QLatin1StringView kAttractorsKey("attractors");

QJsonArray pointToJson(const Vec2& point)
{
    return {double{point.x()}, double{point.y()}};
}

std::optional<Vec2> pointFromJson(const QJsonValue& json)
{
    const QJsonArray pair = json.toArray();
    if (pair.size() != 2 || !pair.at(0).isDouble() || !pair.at(1).isDouble())
        return {};
    return Vec2(static_cast<float>(pair.at(0).toDouble()), static_cast<float>(pair.at(1).toDouble()));
}

} // namespace

QJsonObject profileToJson(const StrandProfile& profile)
{
    QJsonArray boundaries;
    for (const StrandProfile::Loop& loop : profile.boundaries) {
        QJsonArray points;
        for (const Vec2& point : loop)
            points.append(pointToJson(point));
        boundaries.append(points);
    }
    QJsonObject json{{kBoundariesKey, boundaries}};
    QJsonArray attractors;
    for (const auto& [from, to] : profile.attractors)
        attractors.append(QJsonArray{pointToJson(from), pointToJson(to)});
    if (!attractors.isEmpty())
        json[kAttractorsKey] = attractors;
    return json;
}

Result<StrandProfile> readProfile(const QJsonValue& json, const QString& place)
{
    if (!json.isObject())
        return inputError(place, ProfileJsonText::tr("a profile is expected"));
    JsonReader reader(json.toObject(), place);
    StrandProfile profile;
    const auto read = [&](QLatin1StringView key, std::size_t most, auto&& take) {
        const QJsonArray array = reader.array(key);
        if (static_cast<std::size_t>(array.size()) > most)
            return reader.fail(key, ProfileJsonText::tr("at most %1 are possible").arg(most));
        for (const QJsonValue& entry : array) {
            if (!take(entry.toArray()))
                return reader.fail(key, ProfileJsonText::tr("lists of points [x, y] are expected"));
        }
    };
    std::size_t count = 0;
    read(kBoundariesKey, kMostProfileLoops, [&](const QJsonArray& points) {
        StrandProfile::Loop& loop = profile.boundaries.emplace_back();
        for (const QJsonValue& value : points) {
            const std::optional<Vec2> point = pointFromJson(value);
            if (!point || ++count > kMostProfilePoints)
                return false;
            loop.push_back(*point);
        }
        return true;
    });
    read(kAttractorsKey, kMostAttractors, [&](const QJsonArray& ends) {
        const std::optional<Vec2> from = pointFromJson(ends.at(0));
        const std::optional<Vec2> to = pointFromJson(ends.at(1));
        if (ends.size() != 2 || !from || !to)
            return false;
        profile.attractors.push_back({*from, *to});
        return true;
    });
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    if (const QString fault = profileFault(profile); !fault.isEmpty())
        return inputError(place, fault);
    return profile;
}

} // namespace espalier
