// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/sketch/BranchMove.h"

namespace espalier {

/// Moves a branch to another place on the wood, turns it and scales it (commands/MoveBranch.h).
struct MoveBranchOperation {
    static constexpr QLatin1StringView kName{"moveBranch"};

    InternodeReference internode;             ///< Any of the branch
    InternodeReference onto;                  ///< That the branch will stand on
    float along = 1.0F;                       ///< 0...1 on that internode
    Rotation rotation = Rotation::Identity(); ///< Of the branch's first internode against that one
    double scale = 1.0;                       ///< BranchMove::kLeastScale...kMostScale

    /// The operation that does what @p move says. Precondition: the document has both internodes, which are
    /// alive.
    static MoveBranchOperation of(const TreeDocument& document, const BranchMove& move);
    static MoveBranchOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const MoveBranchOperation&) const = default;
};

} // namespace espalier
