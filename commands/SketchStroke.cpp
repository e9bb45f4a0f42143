// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SketchStroke.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/LassoJson.h"
#include "commands/recipe/SketchStrokeOperation.h"
#include "model/shape/Pruning.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

/// The same stroke on the other side of the vertical through @p foot.
LassoStroke mirrored(LassoStroke stroke, const Vec3& foot)
{
    const float middle = (foot - stroke.origin).dot(stroke.right);
    for (Vec2& point : stroke.points)
        point.x() = 2.0F * middle - point.x();
    return stroke;
}

/// The mirror image that was drawn with a branch, if it is the last that has grown: its first internode.
std::optional<InternodeId> imageOf(const TreeDocument& document, InternodeId branch)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    const InternodeId image = index.axis(tree.size() - 1);
    if (image == branch || !tree.isAlive(image) || tree.birth(image) != tree.birth(branch) + 1 ||
        index.axis(image - 1) != branch)
        return std::nullopt;
    return image;
}

/// Applies the births of one branch; its first internode.
Result<InternodeId> growStroke(Edit& edit, const LassoStroke& stroke, std::optional<BranchPlace> base,
                               std::vector<float> radii)
{
    const TreeDocument& document = edit.document();
    DrawnBranch branch{.base = base, .line = {}, .radii = std::move(radii)};
    for (const Vec2& point : stroke.points)
        branch.line.emplace_back(stroke.origin + point.x() * stroke.right + point.y() * stroke.up);
    if (document.index().livingCount() == 1 && !base) {
        if (branch.line.back().y() < branch.line.front().y())
            std::ranges::reverse(branch.line);
    } else if (!base) {
        const auto inPlane = [&](const Vec3& point) {
            const Vec3 offset = point - stroke.origin;
            return std::optional(
                Eigen::Vector2d(double{offset.dot(stroke.right)}, double{offset.dot(stroke.up)}));
        };
        const std::optional<Attachment> nearest =
            nearestAttachment(document.tree(), document.index(), inPlane,
                              stroke.points.front().cast<double>(), stroke.points.back().cast<double>());
        branch.base = nearest->place;
        if (nearest->isReversed)
            std::ranges::reverse(branch.line);
    }
    const InternodeId first = branch.base ? document.tree().size() : 0;
    Result<TreeDelta> delta = growDrawnBranch(document.tree(), document.index(), std::move(branch),
                                              document.parameters().growth.internodeLength);
    if (!delta)
        return delta.error();
    edit.apply(std::move(*delta));
    return first;
}

} // namespace

Result<InternodeId> sketchBranch(TreeDocument& document, BranchStroke stroke)
{
    stroke.stroke = recordableLasso(std::move(stroke.stroke));
    Edit edit(document);
    const SketchStrokeOperation operation = SketchStrokeOperation::of(document, stroke);
    if (stroke.replaces) {
        const InternodeId axis = document.index().axis(*stroke.replaces);
        std::vector<InternodeId> gone{axis};
        // The seedling's internode lives on: it becomes the foot of the new trunk.
        if (axis == 0) {
            gone.clear();
            for (InternodeId child = document.index().firstChild(0); child != kNoInternode;
                 child = document.index().nextSibling(child))
                gone.push_back(child);
        } else if (stroke.isMirrored) {
            if (const std::optional<InternodeId> image = imageOf(document, axis))
                gone.push_back(*image);
        }
        edit.apply(prune(document.tree(), document.index(), gone));
    }
    const bool isTrunk = document.index().livingCount() == 1 && !stroke.base;
    Result<InternodeId> first = growStroke(edit, stroke.stroke, stroke.base, stroke.radii);
    if (first && stroke.isMirrored && !isTrunk) {
        const LassoStroke image = mirrored(stroke.stroke, document.tree().rootPosition(0));
        if (const Result<InternodeId> second = growStroke(edit, image, {}, stroke.radii); !second)
            first = second.error();
    }
    if (!first)
        return first;
    commitRecorded(edit, QCoreApplication::translate("Commands", "Draw Branch"), [&] { return operation; });
    return first;
}

} // namespace espalier
