// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/RecipeOperation.h"

#include <cstdint>

namespace espalier {

/// Changes the trees' angles and lengths slightly (commands/VaryTree.h).
struct VaryOperation {
    static constexpr QLatin1StringView kName{"vary"};
    static constexpr double kLeastAmount = 0.01;

    std::uint64_t seed = 1;
    double amount = 0.3; ///< kLeastAmount...1

    static VaryOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const VaryOperation&) const = default;
};

} // namespace espalier
