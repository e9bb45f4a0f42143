// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/ParametersJson.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QSet>

#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <type_traits>

namespace espalier {

namespace {

struct ParametersText {
    Q_DECLARE_TR_FUNCTIONS(ParametersJson)
};

/// "growth" and "shedding" of "growth.shedding".
struct Key {
    QString group;
    QString name;

    explicit Key(const ParameterInfo& info) : Key(info.key) {}
    explicit Key(const char* text)
    {
        const QLatin1StringView key(text);
        const qsizetype dot = key.indexOf(QLatin1Char('.'));
        group = key.first(dot);
        name = key.sliced(dot + 1);
    }
};

/// The angle in degrees, with as few digits as lead back to exactly the same radians. Every angle that was
/// given in degrees has such a number; for others the nearest number is used.
double shortestDegrees(double angle)
{
    const double direct = degrees(angle);
    char text[40];
    for (int digits = 1; digits < 17; ++digits) {
        const auto end =
            std::to_chars(text, text + sizeof text, direct, std::chars_format::general, digits).ptr;
        double candidate = 0.0;
        std::from_chars(text, end, candidate);
        if (radians(candidate) == angle)
            return candidate;
    }
    double below = direct;
    double above = direct;
    for (int i = 0; i < 4; ++i) {
        if (radians(below) == angle)
            return below;
        if (radians(above) == angle)
            return above;
        below = std::nextafter(below, -1e9);
        above = std::nextafter(above, 1e9);
    }
    return direct;
}

QStringList choicesOf(const ParameterInfo& info)
{
    return QString::fromLatin1(info.choices).split(QLatin1Char(' '));
}

template <class T>
QJsonValue valueToJson(const ParameterInfo& info, T field)
{
    if constexpr (std::is_enum_v<T>)
        return choicesOf(info).at(static_cast<int>(field));
    else if constexpr (std::is_same_v<T, double>)
        return info.quantity == Quantity::Angle ? shortestDegrees(field) : field;
    else
        return field;
}

/// Reads @p value into @p field. Returns what is wrong with it, or nothing.
template <class T>
std::optional<QString> readValue(const ParameterInfo& info, const QJsonValue& value, T& field)
{
    if constexpr (std::is_same_v<T, bool>) {
        if (!value.isBool())
            return ParametersText::tr("true or false is expected");
        field = value.toBool();
    } else if constexpr (std::is_enum_v<T>) {
        const QStringList choices = choicesOf(info);
        const auto choice = value.isString() ? choices.indexOf(value.toString()) : -1;
        if (choice < 0)
            return ParametersText::tr("one of these is expected: %1").arg(choices.join(QLatin1String(", ")));
        field = static_cast<T>(choice);
    } else {
        const double number = value.toDouble();
        constexpr bool whole = std::is_same_v<T, int>;
        if (!value.isDouble() || (whole && std::floor(number) != number))
            return whole ? ParametersText::tr("a whole number is expected")
                         : ParametersText::tr("a number is expected");
        if (!(number >= info.minimum && number <= info.maximum))
            return ParametersText::tr("%1 is not within %2…%3")
                .arg(number)
                .arg(info.minimum)
                .arg(info.maximum);
        field = static_cast<T>(info.quantity == Quantity::Angle ? radians(number) : number);
    }
    return {};
}

/// Reads the name of an image and sets @p image to the image of that name. Returns what is wrong, or nothing.
std::optional<QString> readImageName(const QJsonValue& value, const ImageOfName& imageOfName,
                                     ImageAsset& image)
{
    if (!value.isString())
        return ParametersText::tr("the name of an image is expected");
    if (value.toString().isEmpty()) {
        image = {};
        return {};
    }
    if (!imageOfName)
        return ParametersText::tr("there are no images here");
    const Result<ImageAsset> found = imageOfName(value.toString());
    if (!found)
        return found.error().message;
    image = *found;
    return {};
}

QString nameOf(const ImageAsset& image, const ImageName& imageName)
{
    if (image.isNull())
        return {};
    return imageName ? imageName(image) : image.hash();
}

void put(QJsonObject& json, const Key& key, const QJsonValue& value)
{
    QJsonObject group = json[key.group].toObject();
    group[key.name] = value;
    json[key.group] = group;
}

/// Finds parameters that contradict each other; the error names the field.
std::optional<Error> contradiction(const GrowthParameters& growth, const QString& place)
{
    if (growth.axisWeight + growth.tropismWeight + growth.spaceWeight <= 0.0) {
        return inputError(place + QLatin1String(".growth.axisWeight"),
                          ParametersText::tr("axisWeight, tropismWeight and spaceWeight must not all be 0"));
    }
    if (std::abs(growth.ellipseOffset) > 0.99 * growth.ellipseVertical) {
        return inputError(place + QLatin1String(".growth.ellipseOffset"),
                          ParametersText::tr("it must not exceed 0.99 times ellipseVertical, which is %1")
                              .arg(growth.ellipseVertical));
    }
    return {};
}

QString unknownName(const QJsonObject& json, const QHash<QString, QSet<QString>>& known)
{
    for (auto group = json.begin(); group != json.end(); ++group) {
        const auto names = known.find(group.key());
        if (names == known.end())
            return group.key();
        const QJsonObject members = group.value().toObject();
        for (auto member = members.begin(); member != members.end(); ++member) {
            if (!names->contains(member.key()))
                return group.key() + QLatin1Char('.') + member.key();
        }
    }
    return {};
}

} // namespace

QJsonObject toJson(const TreeParameters& parameters, const ImageName& imageName)
{
    QHash<QString, QJsonObject> groups;
    visitParameters(parameters, [&](const ParameterInfo& info, const auto& field) {
        const Key key(info);
        groups[key.group].insert(key.name, valueToJson(info, field));
    });
    QJsonObject json;
    for (auto group = groups.cbegin(); group != groups.cend(); ++group)
        json.insert(group.key(), group.value());
    visitImages(parameters, [&](const char* key, const ImageAsset& image) {
        if (!image.isNull())
            put(json, Key(key), nameOf(image, imageName));
    });
    return json;
}

QJsonObject toJson(const TreeParameters& parameters, const TreeParameters& base, const ImageName& imageName)
{
    TreeParameters plain = parameters;
    visitImages(plain, [](const char*, ImageAsset& image) { image = {}; });
    TreeParameters plainBase = base;
    visitImages(plainBase, [](const char*, ImageAsset& image) { image = {}; });
    QJsonObject json = toJson(plain);
    const QJsonObject known = toJson(plainBase);
    for (const QString& group : known.keys()) {
        QJsonObject members = json[group].toObject();
        const QJsonObject same = known[group].toObject();
        for (const QString& name : same.keys()) {
            if (members[name] == same[name])
                members.remove(name);
        }
        if (members.isEmpty())
            json.remove(group);
        else
            json[group] = members;
    }
    visitImages(parameters, [&](const char* key, const ImageAsset& image) {
        visitImages(base, [&](const char* baseKey, const ImageAsset& before) {
            if (std::strcmp(key, baseKey) == 0 && !(image == before))
                put(json, Key(key), nameOf(image, imageName));
        });
    });
    return json;
}

Result<TreeParameters> fromJson(const QJsonObject& json, const TreeParameters& base, const QString& place,
                                const ImageOfName& imageOfName)
{
    TreeParameters result = base;
    std::optional<Error> error;
    QHash<QString, QSet<QString>> known;
    visitParameters(result, [&](const ParameterInfo& info, auto& field) {
        const Key key(info);
        known[key.group].insert(key.name);
        const QJsonValue group = json.value(key.group);
        if (error || group.isUndefined())
            return;
        if (!group.isObject()) {
            error =
                inputError(place + QLatin1Char('.') + key.group, ParametersText::tr("an object is expected"));
            return;
        }
        const QJsonValue value = group.toObject().value(key.name);
        if (value.isUndefined())
            return;
        if (const auto fault = readValue(info, value, field))
            error = inputError(place + QLatin1Char('.') + QLatin1String(info.key), *fault);
    });
    visitImages(result, [&](const char* keyText, ImageAsset& image) {
        const Key key(keyText);
        known[key.group].insert(key.name);
        const QJsonValue value = json.value(key.group).toObject().value(key.name);
        if (error || value.isUndefined())
            return;
        if (const auto fault = readImageName(value, imageOfName, image))
            error = inputError(place + QLatin1Char('.') + QLatin1String(keyText), *fault);
    });
    if (!error) {
        if (const QString name = unknownName(json, known); !name.isEmpty())
            error =
                inputError(place + QLatin1Char('.') + name, ParametersText::tr("there is no such parameter"));
    }
    if (!error)
        error = contradiction(result.growth, place);
    if (error)
        return *error;
    return result;
}

void normaliseDirectionWeights(GrowthParameters& growth)
{
    const double sum = growth.axisWeight + growth.tropismWeight + growth.spaceWeight;
    if (std::abs(sum - 1.0) < 1e-12)
        return;
    growth.axisWeight /= sum;
    growth.tropismWeight /= sum;
    growth.spaceWeight /= sum;
}

} // namespace espalier
