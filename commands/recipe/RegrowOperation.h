// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

namespace espalier {

/// Fills the envelopes in force again, with the parameters in force (LassoGesture::regrow).
struct RegrowOperation {
    static constexpr QLatin1StringView kName{"regrow"};

    static RegrowOperation read(JsonReader&, RecipeReading&) { return {}; }
    QJsonObject write(RecipeWriting&) const { return {}; }
    std::unique_ptr<Performance> begin(TreeDocument& document) const;
    bool operator==(const RegrowOperation&) const = default;
};

} // namespace espalier
