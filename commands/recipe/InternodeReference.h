// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/JsonReader.h"

namespace espalier {

/// How a recipe names an internode: by the number of its row in the tree.
class InternodeReference {
public:
    static constexpr std::int64_t kGreatestNumber = 0xffff'fffe;

    /// @p number is 0 (the seedling)...kGreatestNumber; the tree need not have such an internode.
    InternodeReference(InternodeId number = 0) : m_number(number) {}

    InternodeId number() const { return m_number; }

    /// The living internode, or an Error that says which one is missing.
    Result<InternodeId> resolve(const TreeDocument& document) const;

    /// The Error says what is expected, without a place.
    static Result<InternodeReference> fromJson(const QJsonValue& value);
    /// A member that must be there; @p reader keeps what is wrong with it.
    static InternodeReference read(JsonReader& reader, QLatin1StringView key);
    QJsonValue toJson() const;

    bool operator==(const InternodeReference&) const = default;

private:
    InternodeId m_number;
};

} // namespace espalier
