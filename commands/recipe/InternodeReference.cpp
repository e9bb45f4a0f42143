// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/InternodeReference.h"

#include <QCoreApplication>

#include <cmath>

namespace espalier {

namespace {

struct Text {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

} // namespace

Result<InternodeId> InternodeReference::resolve(const TreeDocument& document) const
{
    const Tree& tree = document.tree();
    if (m_number >= tree.size() || !tree.isAlive(m_number))
        return inputError({}, Text::tr("there is no internode %1").arg(m_number));
    return m_number;
}

Result<InternodeReference> InternodeReference::fromJson(const QJsonValue& value)
{
    const double number = value.toDouble(-1.0);
    if (!(number >= 0.0 && number <= static_cast<double>(kGreatestNumber) && number == std::floor(number)))
        return inputError({}, Text::tr("a whole number from 0 to %1 is expected").arg(kGreatestNumber));
    return InternodeReference(static_cast<InternodeId>(number));
}

InternodeReference InternodeReference::read(JsonReader& reader, QLatin1StringView key)
{
    const Result<InternodeReference> reference = fromJson(reader.value(key));
    if (reference)
        return *reference;
    reader.fail(key, reference.error().message);
    return {};
}

QJsonValue InternodeReference::toJson() const
{
    return static_cast<qint64>(m_number);
}

} // namespace espalier
