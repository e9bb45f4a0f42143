// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/InferDepth.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/InferOperation.h"
#include "model/sketch/FlatTree.h"

#include <QCoreApplication>

namespace espalier {

namespace {

Result<void> inferWith(Edit& edit, const DepthOptions& options)
{
    const TreeDocument& document = edit.document();
    Result<TreeDelta> delta = giveDepth(document.tree(), document.index(), options);
    if (!delta)
        return delta.error();
    edit.apply(std::move(*delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Give Depth"),
                   [&] { return InferOperation{options}; });
    return {};
}

} // namespace

Result<void> inferDepth(TreeDocument& document, const DepthOptions& options)
{
    Edit edit(document);
    return inferWith(edit, options);
}

Result<void> DepthTrial::tryOut(const DepthOptions& options)
{
    return tryWith([&](Edit& edit) { return inferWith(edit, options); });
}

} // namespace espalier
