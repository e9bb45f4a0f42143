// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates the messages of the recipe operations.
struct RecipeText {
    Q_DECLARE_TR_FUNCTIONS(Recipe)
};

} // namespace espalier
