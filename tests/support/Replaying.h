// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"

namespace espalier::test {

/// Makes a recipe of the document's history, writes and reads it, and plays it in another document. In what
/// this one differs then (tree, journal, future, project file), or why it could not be done; empty for
/// nothing.
QString replayFault(const TreeDocument& document);

} // namespace espalier::test
