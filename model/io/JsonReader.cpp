// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QJsonDocument>

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

struct JsonText {
    Q_DECLARE_TR_FUNCTIONS(JsonReader)
};

/// Limits of arrays and objects together, and of values, when parsing. A value takes 16 bytes and a container
/// some 150, so this is about 300 MB; the largest recipe has a million samples of five numbers.
constexpr qsizetype kMaximumContainers = 1'300'000;
constexpr qsizetype kMaximumValues = 8'000'000;
/// Above it not every whole number is a double.
constexpr double kExactIntegers = 9007199254740992.0;

bool isWhole(const QJsonValue& value)
{
    return value.isDouble() && std::floor(value.toDouble()) == value.toDouble();
}

} // namespace

Error inputError(const QString& place, const QString& what)
{
    return {Error::Kind::Input, place.isEmpty() ? what : JsonText::tr("%1: %2").arg(place, what)};
}

Result<QJsonObject> parseJsonObject(const QByteArray& json, qsizetype maximumBytes)
{
    if (json.size() > maximumBytes)
        return inputError({}, JsonText::tr("it is larger than %1 MB").arg(maximumBytes >> 20));
    // Brackets and commas inside strings count too: they only bring the limit nearer.
    const auto occurrences = [&](char c) { return std::count(json.begin(), json.end(), c); };
    if (occurrences('[') + occurrences('{') > kMaximumContainers || occurrences(',') > kMaximumValues)
        return inputError({}, JsonText::tr("it holds too many values"));

    QJsonParseError fault;
    const QJsonDocument document = QJsonDocument::fromJson(json, &fault);
    if (fault.error != QJsonParseError::NoError) {
        const qsizetype offset = std::clamp<qsizetype>(fault.offset, 0, json.size());
        const auto line = 1 + std::count(json.begin(), json.begin() + offset, '\n');
        return inputError(JsonText::tr("line %1").arg(line),
                          JsonText::tr("not valid JSON: %1").arg(fault.errorString()));
    }
    if (!document.isObject())
        return inputError({}, JsonText::tr("a JSON object is expected"));
    return document.object();
}

QString JsonReader::placeOf(QLatin1StringView key) const
{
    return m_place.isEmpty() ? QString(key) : m_place + QLatin1Char('.') + key;
}

QJsonValue JsonReader::take(QLatin1StringView key, bool required)
{
    m_asked.append(key);
    const QJsonValue value = m_object.value(key);
    if (value.isUndefined() && required)
        fail(key, JsonText::tr("it is missing"));
    return value;
}

std::int64_t JsonReader::integer(QLatin1StringView key, std::int64_t minimum, std::int64_t maximum,
                                 std::optional<std::int64_t> fallback)
{
    const QJsonValue value = take(key, !fallback);
    if (value.isUndefined())
        return fallback.value_or(minimum);
    const double number = value.toDouble();
    if (!isWhole(value) || number < static_cast<double>(minimum) || number > static_cast<double>(maximum)) {
        fail(key, JsonText::tr("a whole number from %1 to %2 is expected").arg(minimum).arg(maximum));
        return minimum;
    }
    return value.toInteger();
}

double JsonReader::number(QLatin1StringView key, double minimum, double maximum,
                          std::optional<double> fallback)
{
    const QJsonValue value = take(key, !fallback);
    if (value.isUndefined())
        return fallback.value_or(minimum);
    const double number = value.toDouble();
    if (!value.isDouble() || !(number >= minimum && number <= maximum)) {
        fail(key, JsonText::tr("a number from %1 to %2 is expected").arg(minimum).arg(maximum));
        return minimum;
    }
    return number;
}

QString JsonReader::text(QLatin1StringView key, const std::optional<QString>& fallback)
{
    const QJsonValue value = take(key, !fallback);
    if (!value.isString() && !(value.isUndefined() && fallback))
        fail(key, JsonText::tr("a string is expected"));
    return value.toString(fallback.value_or(QString()));
}

std::uint64_t JsonReader::seed(QLatin1StringView key, std::optional<std::uint64_t> fallback)
{
    const QJsonValue value = take(key, !fallback);
    if (value.isUndefined())
        return fallback.value_or(0);
    bool good = isWhole(value) && value.toDouble() >= 0 && value.toDouble() <= kExactIntegers;
    if (good)
        return static_cast<std::uint64_t>(value.toInteger());
    const QString digits = value.toString();
    good = !digits.isEmpty() && std::ranges::all_of(digits, [](QChar c) { return c >= u'0' && c <= u'9'; });
    const std::uint64_t number = good ? digits.toULongLong(&good) : 0;
    if (!good) {
        fail(key, JsonText::tr("a whole number of at most 64 bits is expected; from 2^53 on, write it as a "
                               "string of digits"));
        return 0;
    }
    return number;
}

QJsonObject JsonReader::object(QLatin1StringView key)
{
    const QJsonValue value = take(key, false);
    if (!value.isUndefined() && !value.isObject())
        fail(key, JsonText::tr("an object is expected"));
    return value.toObject();
}

QJsonArray JsonReader::array(QLatin1StringView key)
{
    const QJsonValue value = take(key, false);
    if (!value.isUndefined() && !value.isArray())
        fail(key, JsonText::tr("an array is expected"));
    return value.toArray();
}

void JsonReader::fail(Error error)
{
    if (!m_error)
        m_error = std::move(error);
}

QJsonObject JsonReader::takeRest()
{
    QJsonObject rest;
    for (auto member = m_object.constBegin(); member != m_object.constEnd(); ++member) {
        if (!m_asked.contains(member.key()))
            rest.insert(member.key(), member.value());
    }
    m_asked.append(rest.keys());
    return rest;
}

Result<void> JsonReader::finish() const
{
    if (m_error)
        return *m_error;
    for (auto member = m_object.begin(); member != m_object.end(); ++member) {
        if (!m_asked.contains(member.key()))
            return inputError(m_place, JsonText::tr("“%1” is not known here").arg(member.key()));
    }
    return {};
}

QJsonValue seedToJson(std::uint64_t seed)
{
    if (seed <= static_cast<std::uint64_t>(kExactIntegers))
        return static_cast<qint64>(seed);
    return QString::number(seed);
}

} // namespace espalier
