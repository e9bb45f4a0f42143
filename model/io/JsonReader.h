// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QByteArray>
#include <QJsonArray>
#include <QJsonObject>
#include <QString>

#include <optional>

namespace espalier {

/// "place: what"; only what if there is no place to name.
Error inputError(const QString& place, const QString& what);

/// Parses JSON that must be an object. JSON of more than @p maximumBytes, or of so many values that they
/// would fill the memory, is refused before it is parsed; other errors name the line.
Result<QJsonObject> parseJsonObject(const QByteArray& json, qsizetype maximumBytes);

/// Reads the members of one JSON object strictly: each must be of its type and within its limits, none may be
/// unknown. The first fault is kept, together with its place ("operations[3].steps"); values that are read
/// after a fault have no meaning. So a caller reads all members, then calls finish() once.
class JsonReader {
public:
    JsonReader(QJsonObject object, QString place) : m_object(std::move(object)), m_place(std::move(place)) {}

    bool has(QLatin1StringView key) const { return m_object.contains(key); }
    /// Place of a member: "operations[3].steps".
    QString placeOf(QLatin1StringView key) const;

    /// A whole number within the limits; without a fallback it must be there.
    std::int64_t integer(QLatin1StringView key, std::int64_t minimum, std::int64_t maximum,
                         std::optional<std::int64_t> fallback = {});
    /// A number within the limits; without a fallback it must be there.
    double number(QLatin1StringView key, double minimum, double maximum, std::optional<double> fallback = {});
    QString text(QLatin1StringView key, const std::optional<QString>& fallback = {});
    /// A whole number of 64 bits: as a number up to 2^53, or as a string of decimal digits.
    std::uint64_t seed(QLatin1StringView key, std::optional<std::uint64_t> fallback = {});
    /// A member of any type, which must be there.
    QJsonValue value(QLatin1StringView key) { return take(key, true); }
    /// Empty if it is not there.
    QJsonObject object(QLatin1StringView key);
    QJsonArray array(QLatin1StringView key);

    /// Keeps @p error if it is the first.
    void fail(Error error);
    void fail(QLatin1StringView key, const QString& what) { fail(inputError(placeOf(key), what)); }
    /// The members that were not read so far; now they count as read.
    QJsonObject takeRest();
    /// The first fault, or else an error that names a member that was never read.
    Result<void> finish() const;

private:
    QJsonValue take(QLatin1StringView key, bool required);

    QJsonObject m_object;
    QString m_place;
    QStringList m_asked;
    std::optional<Error> m_error;
};

/// A seed in the form that JsonReader::seed() reads.
QJsonValue seedToJson(std::uint64_t seed);

} // namespace espalier
