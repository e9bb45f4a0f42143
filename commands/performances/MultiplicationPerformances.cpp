// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/MoveBranch.h"
#include "commands/MultiplyBranch.h"
#include "commands/PropagateBranch.h"
#include "commands/ReproduceTree.h"
#include "commands/VaryTree.h"
#include "commands/recipe/MultiplyOperation.h"
#include "commands/recipe/PropagateOperation.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/ReproduceOperation.h"
#include "commands/recipe/VaryOperation.h"

namespace espalier {

QString MoveBranchOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> branch = internode.resolve(document);
    const Result<InternodeId> parent = onto.resolve(document);
    if (!branch || !parent)
        return (branch ? parent : branch).error().message;
    const Result<void> done = moveBranch(
        document, {.branch = *branch, .place = {*parent, along}, .rotation = rotation, .scale = scale});
    return done ? QString() : done.error().message;
}

QString MultiplyOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    const Result<void> done = multiplyBranch(document, *id, seed, count);
    return done ? QString() : done.error().message;
}

QString PropagateOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    Propagation propagation{
        .reference = *id, .targets = targets, .axes = {}, .scaling = scaling, .replaces = replaces};
    QStringList faults;
    for (const InternodeReference& axis : axes) {
        if (const Result<InternodeId> target = axis.resolve(document); target)
            propagation.axes.push_back(*target);
        else
            faults.append(target.error().message);
    }
    if (const Result<void> done = propagateBranch(document, propagation); !done)
        faults.append(done.error().message);
    return joinedFaults(faults);
}

QString ReproduceOperation::perform(TreeDocument& document) const
{
    // Branches outside the silhouette are no fault of the recipe: it does again what the user did.
    const Result<std::uint32_t> outside = reproduceTree(document, figure);
    return outside ? QString() : outside.error().message;
}

QString VaryOperation::perform(TreeDocument& document) const
{
    const Result<void> done = varyTree(document, seed, amount);
    return done ? QString() : done.error().message;
}

} // namespace espalier
