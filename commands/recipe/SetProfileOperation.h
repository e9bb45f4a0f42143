// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "commands/recipe/RecipeOperation.h"
#include "model/tree/StrandProfile.h"

#include <vector>

namespace espalier {

/// Gives nodes a profile, or takes it away.
struct SetProfileOperation {
    static constexpr QLatin1StringView kName{"setProfile"};
    static constexpr qsizetype kMostNodes = 10'000;

    std::vector<InternodeReference> internodes; ///< 1...kMostNodes; exactly one if there is `to`
    std::optional<StrandProfile> profile{};     ///< Empty: the profiles are taken away
    /// The other end of a branch whose nodes all get the profile. One end is on the way from the other to the
    /// root.
    std::optional<InternodeReference> to{};
    /// The profile of that other end; the nodes between get profiles between the two. Only with `to`.
    std::optional<StrandProfile> toProfile{};

    static SetProfileOperation read(JsonReader& reader, RecipeReading& reading);
    QJsonObject write(RecipeWriting& writing) const;
    QString perform(TreeDocument& document) const;
    bool operator==(const SetProfileOperation&) const = default;
};

} // namespace espalier
