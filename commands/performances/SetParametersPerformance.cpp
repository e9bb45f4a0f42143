// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/SetParameters.h"
#include "commands/recipe/SetParametersOperation.h"

namespace espalier {

QString SetParametersOperation::perform(TreeDocument& document) const
{
    setParameters(document, parameters);
    return {};
}

} // namespace espalier
