// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/recipe/InternodeReference.h"
#include "model/growth/Competition.h"

#include <optional>

namespace espalier {

/// The buds that a recipe lets grow: all, or the one that the member "only" names, with its descendants.
struct BudReference {
    std::optional<InternodeReference> internode; ///< The one at whose node the bud is; empty for all buds
    int slot = kTerminalSlot;

    /// The reference to @p competitors.
    static BudReference to(const TreeDocument& document, const Competitors& competitors);

    /// The buds that may grow, and a warning.
    struct Found {
        Competitors competitors;
        QString warning; ///< Why nothing can grow: the internode or the bud is missing; empty if both exist
    };
    Found resolve(const TreeDocument& document) const;

    /// Reads the member "only" of @p parent, which gets the error if there is one.
    static BudReference read(JsonReader& parent);
    /// Adds the member "only" unless all buds may grow.
    void write(QJsonObject& json) const;

    bool operator==(const BudReference&) const = default;
};

} // namespace espalier
