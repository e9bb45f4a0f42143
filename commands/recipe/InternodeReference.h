// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/JsonReader.h"

#include <optional>

namespace espalier {

/// How a recipe names an internode: by its key, by the place of its node, or both; in old recipes by its row
/// number. The key is looked for first; if no living internode has it, the place. So an operation finds the
/// internode that was meant although an earlier step of the recipe was changed.
class InternodeReference {
public:
    static constexpr std::int64_t kGreatestNumber = 0xffff'fffe;
    /// The greatest distance of an internode from the place, in internode lengths.
    static constexpr float kReach = 6.0F;

    /// @p number: 0 (the seedling)...kGreatestNumber; the tree need not have this internode.
    InternodeReference(InternodeId number = 0) : m_number(number) {}
    /// @p place: the world position of the internode's node, m.
    InternodeReference(std::optional<InternodeKey> key, std::optional<Vec3> place)
        : m_number(static_cast<InternodeId>(kGreatestNumber)),
          m_hasKey(key.has_value()),
          m_hasPlace(place.has_value()),
          m_key(key.value_or(0)),
          m_place(place.value_or(Vec3(Vec3::Zero())))
    {
    }
    /// By key, and by place if it is within recipeLimits::kCoordinate. Precondition: the document has the
    /// internode.
    static InternodeReference to(const TreeDocument& document, InternodeId id);

    /// kGreatestNumber for a reference by key or place.
    InternodeId number() const { return m_number; }
    bool isNumber() const { return !m_hasKey && !m_hasPlace; }

    /// The living internode, or an Error that names the missing one.
    Result<InternodeId> resolve(const TreeDocument& document) const;

    /// The Error says what is expected, but not where.
    static Result<InternodeReference> fromJson(const QJsonValue& value);
    /// Reads a required member; @p reader gets the error if there is one.
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
