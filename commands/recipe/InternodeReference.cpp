// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/InternodeReference.h"

#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/RecipeLimits.h"
#include "commands/recipe/RecipeText.h"

#include <cmath>

namespace espalier {

namespace {

constexpr QLatin1StringView kKeyKey("key");
constexpr QLatin1StringView kAtKey("at");
constexpr int kKeyDigits = 16;

std::optional<InternodeId> livingWithKey(const Tree& tree, InternodeKey key)
{
    const QList<InternodeKey>& keys = tree.columns().key;
    for (auto id = static_cast<InternodeId>(0); id < tree.size(); ++id) {
        if (keys[id] == key && tree.isAlive(id))
            return id;
    }
    return {};
}

/// The living internode whose node is nearest to @p place, within @p reach, both in m.
std::optional<InternodeId> nearestLiving(const TreeDocument& document, const Vec3& place, float reach)
{
    std::optional<InternodeId> nearest;
    float least = reach * reach;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const float squared = (document.index().nodePosition(id) - place).squaredNorm();
        if (squared <= least && document.tree().isAlive(id)) {
            least = squared;
            nearest = id;
        }
    }
    return nearest;
}

QString keyText(InternodeKey key)
{
    return QStringLiteral("%1").arg(key, kKeyDigits, 16, QLatin1Char('0'));
}

Result<InternodeReference> fromObject(const QJsonObject& object)
{
    JsonReader reader(object, {});
    std::optional<InternodeKey> key;
    if (reader.has(kKeyKey)) {
        const QString text = reader.text(kKeyKey);
        bool isNumber = false;
        key = text.toULongLong(&isNumber, 16);
        if (!isNumber || text.size() != kKeyDigits)
            reader.fail(kKeyKey, RecipeText::tr("%1 hexadecimal digits are expected").arg(kKeyDigits));
    }
    std::optional<Vec3> place;
    if (reader.has(kAtKey)) {
        place = vectorFromJson<3>(reader.array(kAtKey), recipeLimits::kCoordinate);
        if (!place)
            reader.fail(kAtKey, RecipeText::tr("an array of three numbers within ±%1 is expected")
                                    .arg(recipeLimits::kCoordinate));
    }
    if (!key && !place)
        reader.fail(inputError({}, RecipeText::tr("a key (“key”) or a place (“at”) is expected")));
    if (const Result<void> end = reader.finish(); !end)
        return end.error();
    return InternodeReference(key, place);
}

} // namespace

InternodeReference InternodeReference::to(const TreeDocument& document, InternodeId id)
{
    const Vec3 place = document.index().nodePosition(id);
    const bool isNear = place.cwiseAbs().maxCoeff() <= static_cast<float>(recipeLimits::kCoordinate);
    return {document.tree().key(id), isNear ? std::optional(withoutNegativeZeros(place)) : std::nullopt};
}

Result<InternodeId> InternodeReference::resolve(const TreeDocument& document) const
{
    const Tree& tree = document.tree();
    std::optional<InternodeId> found;
    if (isNumber() && tree.isAlive(m_number))
        found = m_number;
    if (m_hasKey)
        found = livingWithKey(tree, m_key);
    if (!found && m_hasPlace) {
        const auto length = static_cast<float>(tree.parameters().growth.internodeLength);
        found = nearestLiving(document, m_place, kReach * length);
    }
    if (!found)
        return inputError({}, text());
    return *found;
}

QString InternodeReference::text() const
{
    if (isNumber())
        return RecipeText::tr("there is no internode %1").arg(m_number);
    if (!m_hasPlace)
        return RecipeText::tr("there is no internode with the key %1").arg(keyText(m_key));
    const auto coordinate = [this](int axis) {
        return QString::number(static_cast<double>(m_place[axis]), 'g', 4);
    };
    return RecipeText::tr("there is no internode near (%1, %2, %3) m")
        .arg(coordinate(0), coordinate(1), coordinate(2));
}

Result<InternodeReference> InternodeReference::fromJson(const QJsonValue& value)
{
    if (value.isObject())
        return fromObject(value.toObject());
    const double number = value.toDouble(-1.0);
    if (!(number >= 0.0 && number <= static_cast<double>(kGreatestNumber) && number == std::floor(number)))
        return inputError({}, RecipeText::tr("a whole number from 0 to %1 is expected").arg(kGreatestNumber));
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
    if (isNumber())
        return static_cast<qint64>(m_number);
    QJsonObject json;
    if (m_hasKey)
        json[kKeyKey] = keyText(m_key);
    if (m_hasPlace)
        json[kAtKey] = espalier::toJson(m_place);
    return json;
}

} // namespace espalier
