// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier {

/// Puts @p parameters in force as one command; does nothing if they are in force already. What has grown
/// keeps what it was grown with; widths, leaves and bark follow at once.
void setParameters(TreeDocument& document, const TreeParameters& parameters);

} // namespace espalier
