// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/JsonReader.h"

#include <optional>

namespace espalier {

/// How a recipe names an internode: by its key, by the place of its node, or both; in old recipes by the
/// number of its row. The key is looked for first, and the place if no living internode has the key: so an
/// operation finds what it meant when an earlier step of the recipe was changed.
class InternodeReference {
public:
    static constexpr std::int64_t kGreatestNumber = 0xffff'fffe;
    /// How far from the place an internode may be, in internode lengths.
    static constexpr float kReach = 6.0F;

    /// @p number is 0 (the seedling)...kGreatestNumber; the tree need not have such an internode.
    InternodeReference(InternodeId number = 0) : m_number(number) {}
    /// @p place is the world position of the internode's node, m.
    InternodeReference(std::optional<InternodeKey> key, std::optional<Vec3> place)
        : m_number(static_cast<InternodeId>(kGreatestNumber)),
          m_hasKey(key.has_value()),
          m_hasPlace(place.has_value()),
          m_key(key.value_or(0)),
          m_place(place.value_or(Vec3(Vec3::Zero())))
    {
    }
    /// By key and, unless it is too far away for a recipe, by place. Precondition: the document has the
    /// internode.
    static InternodeReference to(const TreeDocument& document, InternodeId id);

    /// kGreatestNumber for a reference by key or place.
    InternodeId number() const { return m_number; }
    bool isNumber() const { return !m_hasKey && !m_hasPlace; }

    /// The living internode, or an Error that says which one is missing.
    Result<InternodeId> resolve(const TreeDocument& document) const;

    /// The Error says what is expected, without a place.
    static Result<InternodeReference> fromJson(const QJsonValue& value);
    /// A member that must be there; @p reader keeps what is wrong with it.
    static InternodeReference read(JsonReader& reader, QLatin1StringView key);
    /// A number, or {"key": 16 hexadecimal digits, "at": [x, y, z]}.
    QJsonValue toJson() const;

    bool operator==(const InternodeReference&) const = default;

private:
    QString text() const;

    InternodeId m_number;
    bool m_hasKey = false;
    bool m_hasPlace = false;
    InternodeKey m_key = 0;
    Vec3 m_place = Vec3::Zero(); ///< m
};

} // namespace espalier
