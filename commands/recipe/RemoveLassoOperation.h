// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Puts the envelopes out of force; the tree stays as it is.
struct RemoveLassoOperation {
    static constexpr QLatin1StringView kName{"removeLasso"};

    static RemoveLassoOperation read(JsonReader&, RecipeReading&) { return {}; }
    QJsonObject write(RecipeWriting&) const { return {}; }
    QString perform(TreeDocument& document) const;
    bool operator==(const RemoveLassoOperation&) const = default;
};

} // namespace espalier
