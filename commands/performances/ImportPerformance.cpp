// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ImportSkeleton.h"
#include "commands/recipe/ImportOperation.h"

namespace espalier {

QString ImportOperation::perform(TreeDocument& document) const
{
    const Result<void> imported = importSkeleton(document, skeleton);
    return imported ? QString() : imported.error().message;
}

} // namespace espalier
