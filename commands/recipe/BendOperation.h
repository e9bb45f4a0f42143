// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"

#include <optional>
#include <vector>

namespace espalier {

/// Bends the branch from a base, which stays, to the uppermost handle. A recipe that a person writes gives
/// only the final places of the handles. A recorded one also has their moves, because the form in which a
/// branch settles depends on them.
struct BendOperation {
    static constexpr QLatin1StringView kName{"bend"};
    static constexpr qsizetype kMostHandles = 100;
    static constexpr qsizetype kMostMoves = 100'000; ///< Of each grip
    static constexpr int kMostCalls = 100'000;
    static constexpr qsizetype kMostGrips = 1000;
    static constexpr double kLeastWeight = 0.01;
    static constexpr double kGreatestWeight = 100.0;

    struct Handle {
        InternodeReference internode;
        double along = 1.0;         ///< place on the internode, 0 (lower end)...1 (node)
        Vec3 target = Vec3::Zero(); ///< m
        bool operator==(const Handle&) const = default;
    };
    /// The places to which the handles were pulled at one moment of the drag.
    struct Move {
        std::vector<Vec3> targets; ///< m, in the order of the handles
        /// How often the branch was pulled there (BendGesture::moveTo), 1...kMostCalls; if empty, until it
        /// has settled.
        std::optional<int> calls{};
        bool operator==(const Move&) const = default;
    };
    /// A base, handles, and how they are pulled.
    struct Grip {
        InternodeReference base;
        std::vector<Handle> handles; ///< 1...kMostHandles
        /// In their order, up to the handles' targets; if empty, the handles are pulled there at once.
        std::vector<Move> moves{};
        bool operator==(const Grip&) const = default;
    };
    InternodeReference base;
    std::vector<Handle> handles; ///< 1...kMostHandles
    std::vector<Move> moves{};   ///< Of the first grip, which has this base and these handles
    std::vector<Grip> regrips{}; ///< The following grips, each from the form that the one before left
    double bending = 1.0;        ///< kLeastWeight...kGreatestWeight
    double stretching = 1.0;     ///< kLeastWeight...kGreatestWeight

    static BendOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const BendOperation&) const = default;
};

} // namespace espalier
