// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/document/ViewSettings.h"
#include "views/camera/Camera.h"

namespace espalier {

/// All that a tool sees of the program. All of it outlives the tool.
class ToolContext {
public:
    virtual ~ToolContext() = default;

    virtual TreeDocument& document() = 0;
    virtual ViewSettings& viewSettings() = 0;
    virtual const Camera& camera() const = 0;
    /// What the tool shows has changed; the tree's own changes are seen anyway.
    virtual void requestRepaint() = 0;
};

} // namespace espalier
