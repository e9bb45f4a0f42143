// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ImportSkeleton.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/ImportOperation.h"
#include "model/io/import/SkeletonTree.h"

#include <QCoreApplication>

namespace espalier {

Result<void> importSkeleton(TreeDocument& document, const Skeleton& skeleton)
{
    Edit edit(document);
    if (document.tree().size() > 1)
        return Error{Error::Kind::Input,
                     QCoreApplication::translate("Commands",
                                                 "a skeleton can only be imported where nothing has grown")};
    Result<TreeDelta> delta = growSkeleton(document.tree(), skeleton);
    if (!delta)
        return delta.error();
    edit.apply(std::move(*delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Import"),
                   [&] { return ImportOperation{skeleton}; });
    return {};
}

} // namespace espalier
