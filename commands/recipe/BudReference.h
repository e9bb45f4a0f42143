// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "model/growth/Competition.h"

#include <optional>

namespace espalier {

/// Which buds a recipe lets grow: all, or the one that the member "only" names, with what comes of it.
struct BudReference {
    std::optional<InternodeReference> internode; ///< At whose upper end the bud sits; nothing for all buds
    int slot = kTerminalSlot;

    /// What stands for @p competitors.
    static BudReference to(const TreeDocument& document, const Competitors& competitors);

    /// What growth is to be told, and what is wrong with it.
    struct Found {
        Competitors competitors;
        QString warning; ///< Why nothing can grow: internode or bud are missing; empty if they are there
    };
    Found resolve(const TreeDocument& document) const;

    /// Reads the member "only" of @p parent, which keeps what is wrong with it.
    static BudReference read(JsonReader& parent);
    /// Adds the member "only" unless all buds may grow.
    void write(QJsonObject& json) const;

    bool operator==(const BudReference&) const = default;
};

} // namespace espalier
