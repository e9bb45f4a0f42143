// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/import/Skeleton.h"

namespace espalier {

/// Makes the trees of a skeleton out of the document's seedling (see growSkeleton()), as one undo step. Fails
/// (Kind::Input), and changes nothing, if anything else than a seedling stands there or if the skeleton
/// cannot become a tree.
Result<void> importSkeleton(TreeDocument& document, const Skeleton& skeleton);

} // namespace espalier
