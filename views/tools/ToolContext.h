// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"
#include "views/camera/Camera.h"
#include "views/tools/BudPicker.h"

#include <functional>
#include <optional>

namespace espalier {

/// The parts of the program that a tool may use. All of them outlive the tool.
class ToolContext {
public:
    virtual ~ToolContext() = default;

    virtual TreeDocument& document() = 0;
    virtual ViewSettings& viewSettings() = 0;
    /// The camera of the view that the pointer is in. Positions of samples are in that view.
    virtual const Camera& camera() const = 0;
    /// The camera of the large view, which shows the sun.
    virtual const Camera& mainCamera() const = 0;
    /// The branch under the pointer, within the distance for that kind of pointer.
    virtual std::optional<PickedBranch> pick(const QPointF& screen, PointerDevice device) const = 0;
    /// The same, but thin branches in front of thick ones are passed over (pickThickBranch).
    virtual std::optional<PickedBranch> pickThick(const QPointF& screen, PointerDevice device) const = 0;
    /// The living buds around the pointer, the nearest first, within @p factor times that distance.
    virtual std::vector<PickedBud> pickBuds(const QPointF& screen, PointerDevice device,
                                            double factor) const = 0;
    /// Radius of the bark as it is drawn, m.
    virtual float branchRadius(InternodeId id) const = 0;
    /// The subject of the label at @p screen, if a label that has one was painted there.
    virtual std::optional<InternodeId> labelAt(const QPointF& screen) const = 0;
    /// Shows a field with @p text in place of the label with that subject. @p take gets what the user has
    /// typed, and returns whether it has a meaning. The tool may be gone by then.
    virtual void editLabel(InternodeId subject, const QString& text,
                           std::function<bool(const QString&)> take) = 0;
    /// Requests a repaint because the tool's overlay has changed. Changes of the tree need no request.
    virtual void requestRepaint() = 0;
};

} // namespace espalier
