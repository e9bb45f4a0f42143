// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier {

/// Puts @p parameters in force as one command. Does nothing if they are in force already. Returns false, and
/// does nothing, if the document has no room for another parameter set. Internodes keep the parameters that
/// they grew with; widths, leaves and bark change at once.
bool setParameters(TreeDocument& document, const TreeParameters& parameters);

} // namespace espalier
