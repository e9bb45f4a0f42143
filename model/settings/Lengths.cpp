// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/Lengths.h"

#include <QLocale>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {

namespace {

Units g_units = Units::Metric;

struct UnitName {
    const char* name;
    double metres;
    double next; ///< Unit of a bare number that follows, m; 0 for none
};

constexpr std::array kUnits{
    UnitName{"mm", 0.001, 0.0},       UnitName{"cm", 0.01, 0.001},    UnitName{"m", 1.0, 0.01},
    UnitName{"in", kInch, 0.0},       UnitName{"inch", kInch, 0.0},   UnitName{"inches", kInch, 0.0},
    UnitName{"\"", kInch, 0.0},       UnitName{"\u2033", kInch, 0.0}, UnitName{"\u201d", kInch, 0.0},
    UnitName{"''", kInch, 0.0},       UnitName{"ft", kFoot, kInch},   UnitName{"foot", kFoot, kInch},
    UnitName{"feet", kFoot, kInch},   UnitName{"'", kFoot, kInch},    UnitName{"\u2032", kFoot, kInch},
    UnitName{"\u2019", kFoot, kInch},
};

/// Numbers that are rounded up to 1 or 10 get the digits of 1 or 10.
int digitsFor(double number)
{
    if (number == 0.0 || number >= 9.95)
        return 0;
    return number < 0.995 ? 2 : 1;
}

} // namespace

Units units()
{
    return g_units;
}

void setUnits(Units units)
{
    g_units = units;
}

QString numberText(double number, int decimals)
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return locale.toString(number, 'f', decimals);
}

QString lengthText(double metres)
{
    if (g_units == Units::Imperial) {
        const double inches = metres / kInch;
        if (inches < 11.5)
            return QStringLiteral("%1 in").arg(numberText(inches, digitsFor(inches)));
        const auto whole = static_cast<int>(std::lround(inches));
        const QString feet = QStringLiteral("%1 ft").arg(whole / 12);
        return whole % 12 == 0 ? feet : feet + QStringLiteral(" %1 in").arg(whole % 12);
    }
    if (metres >= 0.995)
        return QStringLiteral("%1 m").arg(numberText(metres, 2));
    const double centimetres = 100.0 * metres;
    return QStringLiteral("%1 cm").arg(numberText(centimetres, digitsFor(centimetres)));
}

QString roundLengthText(double metres)
{
    if (g_units == Units::Imperial || std::abs(metres - std::round(metres)) > 1e-9)
        return lengthText(metres);
    return QStringLiteral("%1 m").arg(numberText(metres, 0));
}

double roundedLength(double metres)
{
    const double perMetre = g_units == Units::Imperial ? 20.0 / kInch : 1000.0;
    return std::round(metres * perMetre) / perMetre;
}

std::optional<double> parseNumber(const QString& text)
{
    QString digits = text.trimmed();
    digits.replace(QChar(0x2212), QLatin1Char('-'));
    const auto last = std::max(digits.lastIndexOf(QLatin1Char('.')), digits.lastIndexOf(QLatin1Char(',')));
    QString plain;
    for (qsizetype i = 0; i < digits.size(); ++i) {
        const QChar c = digits[i];
        if (c == QLatin1Char('.') || c == QLatin1Char(',')) {
            if (i == last)
                plain += QLatin1Char('.');
        } else {
            plain += c;
        }
    }
    // "1e5" and "inf" are not accepted as lengths.
    static const QRegularExpression kNumber(QStringLiteral("^[+-]?([0-9]+\\.?[0-9]*|\\.[0-9]+)$"));
    if (!kNumber.match(plain).hasMatch())
        return std::nullopt;
    return plain.toDouble();
}

std::optional<double> parseLength(const QString& text, double bareUnit)
{
    static const QRegularExpression kTerm(QStringLiteral("\\G\\s*([0-9.,]+)\\s*([^0-9.,\\s]*)"));
    QString rest = text.trimmed();
    rest.replace(QChar(0x2212), QLatin1Char('-'));
    const bool isNegative = rest.startsWith(QLatin1Char('-'));
    if (isNegative || rest.startsWith(QLatin1Char('+')))
        rest = rest.mid(1).trimmed();

    double sum = 0.0;
    double bare = bareUnit;
    qsizetype done = 0;
    while (done < rest.size()) {
        const QRegularExpressionMatch term = kTerm.match(rest, done);
        const std::optional<double> number = term.hasMatch() ? parseNumber(term.captured(1)) : std::nullopt;
        if (!number || bare == 0.0)
            return std::nullopt;
        const QString name = term.captured(2).toLower();
        double unit = bare;
        // Only the last number can be without a unit.
        bare = 0.0;
        if (!name.isEmpty()) {
            const auto* known = std::ranges::find_if(
                kUnits, [&](const UnitName& each) { return name == QString::fromUtf8(each.name); });
            if (known == kUnits.end())
                return std::nullopt;
            unit = known->metres;
            bare = known->next;
        }
        sum += *number * unit;
        done = term.capturedEnd();
    }
    if (done == 0)
        return std::nullopt;
    return isNegative ? -sum : sum;
}

} // namespace espalier
