// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <optional>
#include <vector>

namespace espalier {

/// Bends the branch from a base, which stays, to the uppermost handle. A recipe that a person writes says
/// where the handles end up. One that was recorded has the way of the hands as well: the form that a branch
/// settles in depends on it.
struct BendOperation {
    static constexpr QLatin1StringView kName{"bend"};
    static constexpr qsizetype kMostHandles = 100;
    static constexpr qsizetype kMostMoves = 100'000; ///< Of a grip
    static constexpr int kMostCalls = 100'000;
    static constexpr qsizetype kMostGrips = 1000;
    static constexpr double kLeastWeight = 0.01;
    static constexpr double kGreatestWeight = 100.0;

    struct Handle {
        InternodeReference internode;
        double along = 1.0;         ///< 0...1 from its lower to its upper node
        Vec3 target = Vec3::Zero(); ///< m
        bool operator==(const Handle&) const = default;
    };
    /// Where the handles were pulled to at one moment of the drag.
    struct Move {
        std::vector<Vec3> targets; ///< m, of the handles in their order
        /// How often the branch was pulled there (BendGesture::moveTo), 1...kMostCalls; nothing for until it
        /// has settled.
        std::optional<int> calls{};
        bool operator==(const Move&) const = default;
    };
    /// How the branch is held, and pulled.
    struct Grip {
        InternodeReference base;
        std::vector<Handle> handles; ///< 1...kMostHandles
        /// To the handles' targets in the end; none if it goes there at once.
        std::vector<Move> moves{};
        bool operator==(const Grip&) const = default;
    };
    InternodeReference base;
    std::vector<Handle> handles; ///< 1...kMostHandles
    std::vector<Move> moves{};   ///< With the base and the handles, the first grip
    std::vector<Grip> regrips{}; ///< Those that followed, on the form that stood then
    double bending = 1.0;        ///< kLeastWeight...kGreatestWeight
    double stretching = 1.0;     ///< kLeastWeight...kGreatestWeight

    static BendOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const BendOperation&) const = default;
};

} // namespace espalier
