// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/shape/AdventitiousBuds.h"

namespace espalier {

/// Makes adventitious buds around a branch.
struct AddBudsOperation {
    static constexpr QLatin1StringView kName{"addBuds"};
    static constexpr double kSpacing = 0.03; ///< Unless the recipe says otherwise, m

    InternodeReference internode;
    int count = BudSpiral().count;    ///< 1...BudSpiral::kMostBuds
    double spacing = kSpacing;        ///< m, 0...BudSpiral::kGreatestSpacing
    double along = BudSpiral().along; ///< Of the middle bud on the internode, 0...1
    double azimuth = 0.0;             ///< Of the middle bud around the internode, degrees, -360...360

    /// The operation that makes the buds of @p spiral. Precondition: the document has the internode.
    static AddBudsOperation of(const TreeDocument& document, const BudSpiral& spiral);
    static AddBudsOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    /// The spiral around the internode @p id.
    BudSpiral spiralAt(InternodeId id) const;
    bool operator==(const AddBudsOperation&) const = default;
};

} // namespace espalier
