// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RegrowOperation.h"

namespace espalier {

std::unique_ptr<Performance> RegrowOperation::begin(TreeDocument& document) const
{
    return performanceOf(LassoGesture::regrow(document));
}

} // namespace espalier
