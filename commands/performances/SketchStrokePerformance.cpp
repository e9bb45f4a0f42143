// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/InferDepth.h"
#include "commands/SketchStroke.h"
#include "commands/recipe/InferOperation.h"
#include "commands/recipe/SketchStrokeOperation.h"

namespace espalier {

QString SketchStrokeOperation::perform(TreeDocument& document) const
{
    BranchStroke drawn{.stroke = stroke, .base = {}, .radii = radii, .replaces = {}, .isMirrored = mirror};
    if (on) {
        const Result<InternodeId> id = on->resolve(document);
        if (!id)
            return id.error().message;
        drawn.base = BranchPlace{*id, along};
    }
    if (replaces) {
        const Result<InternodeId> id = replaces->resolve(document);
        if (!id)
            return id.error().message;
        drawn.replaces = *id;
    }
    const Result<InternodeId> first = sketchBranch(document, drawn);
    return first ? QString() : first.error().message;
}

QString InferOperation::perform(TreeDocument& document) const
{
    const Result<void> inferred = inferDepth(document, options);
    return inferred ? QString() : inferred.error().message;
}

} // namespace espalier
