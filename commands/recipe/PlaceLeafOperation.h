// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Places a leaf, a flower or a fruit.
struct PlaceLeafOperation {
    static constexpr QLatin1StringView kName{"placeLeaf"};

    InternodeReference internode;
    float along = 1.0F;                       ///< 0...1 on the internode
    Rotation rotation = Rotation::Identity(); ///< Against the internode: +Y the midrib, +Z the upper side
    float length = 0.1F;                      ///< m, kSmallestLeaf...kGreatestLeaf
    LeafKind kind = LeafKind::Leaf;

    /// The operation that places @p leaf. Precondition: the document has its internode.
    static PlaceLeafOperation of(const TreeDocument& document, const LeafRow& leaf);
    static PlaceLeafOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    /// The leaf on the internode @p id.
    LeafRow leafAt(InternodeId id) const;
    bool operator==(const PlaceLeafOperation&) const = default;
};

} // namespace espalier
