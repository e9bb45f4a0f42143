// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/MultiplyBranch.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/MultiplyOperation.h"
#include "model/sketch/BranchCopy.h"
#include "model/sketch/BranchMultiplication.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

Result<void> multiplyBranch(TreeDocument& document, InternodeId id, std::uint64_t seed, int count)
{
    Edit edit(document);
    const int wanted = std::clamp(count, 1, MultiplyOperation::kMostCount);
    MultiplyOperation operation{.internode = {}, .count = wanted, .seed = seed};
    std::uint32_t born = 0;
    for (int i = 0; i < wanted; ++i) {
        // The step of time makes each choice another one.
        Result<TreeDelta> delta = multiplied(document.tree(), document.index(), id, seed);
        if (!delta)
            return delta.error();
        born += delta->born.count;
        if (born > BranchCopies::kMost)
            return tooManyCopies();
        if (i == 0)
            operation.internode = InternodeReference::to(document, id);
        edit.apply(std::move(*delta));
    }
    commitRecorded(edit, QCoreApplication::translate("Commands", "Multiply Branch"),
                   [&] { return operation; });
    return {};
}

} // namespace espalier
