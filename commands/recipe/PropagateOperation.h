// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/sketch/BranchPropagation.h"

#include <vector>

namespace espalier {

/// Copies what a branch carries to other branches (commands/PropagateBranch.h).
struct PropagateOperation {
    static constexpr QLatin1StringView kName{"propagate"};

    InternodeReference internode; ///< Any of the reference
    Propagation::Targets targets = Propagation::Targets::All;
    std::vector<InternodeReference> axes; ///< For Listed: 1...Propagation::kMostListed
    bool scaling = true;
    bool replaces = false;

    /// The operation that does what @p propagation says. Precondition: the document has its reference, which
    /// is alive.
    static PropagateOperation of(const TreeDocument& document, const Propagation& propagation);
    static PropagateOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const PropagateOperation&) const = default;
};

} // namespace espalier
