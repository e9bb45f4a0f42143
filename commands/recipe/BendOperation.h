// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <vector>

namespace espalier {

/// Bends the branch from a base, which stays, to the uppermost handle.
struct BendOperation {
    static constexpr QLatin1StringView kName{"bend"};
    static constexpr qsizetype kMostHandles = 100;
    static constexpr double kLeastWeight = 0.01;
    static constexpr double kGreatestWeight = 100.0;

    struct Handle {
        InternodeReference internode;
        double along = 1.0;         ///< 0...1 from its lower to its upper node
        Vec3 target = Vec3::Zero(); ///< m
        bool operator==(const Handle&) const = default;
    };
    InternodeReference base;
    std::vector<Handle> handles; ///< 1...kMostHandles
    double bending = 1.0;        ///< kLeastWeight...kGreatestWeight
    double stretching = 1.0;     ///< kLeastWeight...kGreatestWeight

    static BendOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const BendOperation&) const = default;
};

} // namespace espalier
