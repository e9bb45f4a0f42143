// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"
#include "views/camera/Camera.h"
#include "views/tools/BudPicker.h"

namespace espalier {

/// All that a tool sees of the program. All of it outlives the tool.
class ToolContext {
public:
    virtual ~ToolContext() = default;

    virtual TreeDocument& document() = 0;
    virtual ViewSettings& viewSettings() = 0;
    virtual const Camera& camera() const = 0;
    /// The branch under the pointer, as near as that kind of pointer must come.
    virtual std::optional<PickedBranch> pick(const QPointF& screen, PointerDevice device) const = 0;
    /// The living buds around the pointer, the nearest first, up to @p factor times as far as it must come.
    virtual std::vector<PickedBud> pickBuds(const QPointF& screen, PointerDevice device,
                                            double factor) const = 0;
    /// The bark's radius, m, as it is seen.
    virtual float branchRadius(InternodeId id) const = 0;
    /// What the tool shows has changed; the tree's own changes are seen anyway.
    virtual void requestRepaint() = 0;
};

} // namespace espalier
