// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/EditTitle.h"
#include "commands/GrowthGesture.h"
#include "commands/recipe/BudReference.h"

namespace espalier {

/// Growth into free space and light, by the parameters in force.
class GrowGesture : public GrowthGesture {
public:
    /// Only the buds that @p competitors names may grow.
    explicit GrowGesture(TreeDocument& document, Competitors competitors = {});

private:
    QString title() const override { return titleOfGrowth(static_cast<int>(stepCount())); }
    RecipeOperation operation() const override;

    BudReference m_only;
};

} // namespace espalier
