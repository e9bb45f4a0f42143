// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/ParameterScale.h"

#include "model/settings/Lengths.h"
#include "panels/ParameterValue.h"

#include <algorithm>
#include <cmath>

namespace espalier {

ParameterScale::ParameterScale(const ParameterInfo& info, const ParameterText& text)
    : m_info(info), m_text(text)
{
    if (info.quantity != Quantity::Metres || units() == Units::Metric)
        return;
    // As many decimals as are needed for the same precision.
    m_text.decimals += std::max(0, static_cast<int>(std::lround(std::log10(text.factor))) - 1);
    const bool areMetres = text.factor == 1.0;
    m_text.unit = areMetres ? "ft" : "in";
    m_text.factor = 1.0 / (areMetres ? kFoot : kInch);
}

ParameterScale ParameterScale::of(const char* key)
{
    const TreeParameters any;
    ParameterInfo found{};
    visitParameter(any, key, [&](const ParameterInfo& info, const auto&) { found = info; });
    return {found, *parameterText(key)};
}

double ParameterScale::at(double place) const
{
    using enum ParameterText::Scale;
    const double low = m_info.minimum;
    const double high = m_info.maximum;
    double value = low + place * (high - low);
    if (m_text.scale == Logarithmic)
        value = low * std::pow(high / low, place);
    else if (m_text.scale == Cubic)
        value = low + place * place * place * (high - low);
    return rounded(value);
}

double ParameterScale::placeOf(double value) const
{
    using enum ParameterText::Scale;
    const double low = m_info.minimum;
    const double high = m_info.maximum;
    double place = (value - low) / (high - low);
    if (m_text.scale == Logarithmic)
        place = std::log(value / low) / std::log(high / low);
    else if (m_text.scale == Cubic)
        place = std::cbrt(place);
    return std::clamp(place, 0.0, 1.0);
}

double ParameterScale::grain() const
{
    return std::pow(10.0, m_text.decimals) * m_text.factor;
}

double ParameterScale::rounded(double value) const
{
    return std::clamp(std::round(value * grain()) / grain(), m_info.minimum, m_info.maximum);
}

double ParameterScale::stepped(double value, int direction, Stride stride) const
{
    const double least = rounded(value + direction / grain());
    if (stride == Stride::Fine)
        return least;
    const double way = stride == Stride::Coarse ? 0.1 : 0.02;
    const double wanted = at(std::clamp(placeOf(value) + direction * way, 0.0, 1.0));
    return direction > 0 ? std::max(least, wanted) : std::min(least, wanted);
}

std::optional<double> ParameterScale::keyed(double value, int key, Qt::KeyboardModifiers modifiers) const
{
    using enum Stride;
    const Stride stride = modifiers & Qt::ShiftModifier ? Fine : Normal;
    switch (key) {
    case Qt::Key_Right:
    case Qt::Key_Up:
    case Qt::Key_Plus:
        return stepped(value, 1, stride);
    case Qt::Key_Left:
    case Qt::Key_Down:
    case Qt::Key_Minus:
        return stepped(value, -1, stride);
    case Qt::Key_PageUp:
        return stepped(value, 1, Coarse);
    case Qt::Key_PageDown:
        return stepped(value, -1, Coarse);
    case Qt::Key_Home:
        return m_info.minimum;
    case Qt::Key_End:
        return m_info.maximum;
    default:
        return std::nullopt;
    }
}

QString ParameterScale::suffix() const
{
    const QString unit = QString::fromUtf8(m_text.unit);
    return unit.isEmpty() || unit == QStringLiteral("°") ? unit : QLatin1Char(' ') + unit;
}

QString ParameterScale::shown(double value) const
{
    if (*m_text.least != '\0' && value <= m_info.minimum)
        return parameterTr(m_text.least);
    return numberText(value * m_text.factor, m_text.decimals) + suffix();
}

std::optional<double> ParameterScale::typed(const QString& text) const
{
    QString number = text.trimmed();
    if (*m_text.least != '\0' && number == parameterTr(m_text.least))
        return m_info.minimum;
    // Removes the shown unit if it follows a number that was typed with another unit.
    const QString unit = QString::fromUtf8(m_text.unit);
    if (!unit.isEmpty() && number.endsWith(unit) && parsed(number.chopped(unit.size())))
        number.chop(unit.size());
    const std::optional<double> value = parsed(number);
    return value ? std::optional(std::clamp(*value, m_info.minimum, m_info.maximum)) : std::nullopt;
}

std::optional<double> ParameterScale::parsed(const QString& number) const
{
    if (m_info.quantity == Quantity::Metres)
        return parseLength(number, 1.0 / m_text.factor);
    const std::optional<double> shown = parseNumber(number);
    return shown ? std::optional(*shown / m_text.factor) : std::nullopt;
}

} // namespace espalier
