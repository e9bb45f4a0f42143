// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/VaryTree.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/VaryOperation.h"
#include "model/sketch/TreeVariation.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

Result<void> varyWith(Edit& edit, std::uint64_t seed, double amount)
{
    const TreeDocument& document = edit.document();
    if (!(amount >= VaryOperation::kLeastAmount))
        return {};
    const VaryOperation operation{.seed = seed, .amount = std::min(amount, 1.0)};
    Result<TreeDelta> delta = varied(document.tree(), document.index(), seed, operation.amount);
    if (!delta)
        return delta.error();
    edit.apply(std::move(*delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Vary Tree"), [&] { return operation; });
    return {};
}

} // namespace

Result<void> varyTree(TreeDocument& document, std::uint64_t seed, double amount)
{
    Edit edit(document);
    return varyWith(edit, seed, amount);
}

Result<void> VariationTrial::tryOut(std::uint64_t seed, double amount)
{
    return tryWith([&](Edit& edit) { return varyWith(edit, seed, amount); });
}

} // namespace espalier
