// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/TreeSize.h"

#include <QString>

namespace espalier {

/// What a new tree begins with, besides a seedling.
struct NewTree {
    TreeParameters parameters{};
    double viewHeight = sizePreset(TreeSize::StreetTree).viewHeight; ///< See TreeSizePreset
    double brushRadius = 0.0; ///< m; 0 leaves the brush as the user has set it
    QString name{};           ///< Empty if it has none yet

    /// @p takesBrush: with a brush for crowns of that size.
    static NewTree ofSize(TreeSize size, bool takesBrush);
    /// With the parameters of a tree of a project or recipe, at its scale: those in force at the moment that
    /// the project shows, those that the recipe begins with. May run on any thread.
    static Result<NewTree> like(const QString& fileName);
};

} // namespace espalier
