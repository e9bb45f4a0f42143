// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/CommandLine.h"
#include "model/document/TreeDocument.h"

#include <QJsonObject>

namespace espalier {

/// Makes a tree of the drawings that the command line names, one over another, in @p document, and returns
/// what
/// --stats says about it: "strokes", "attached" (branches and leaves that strokes became), "leavesPlaced",
/// "frontError", "sideOverFront" and "infer" (s).
///
/// "frontError" is the greatest distance between the drawn lines, once their bases have moved to the wood,
/// and the tree as seen from the front, in thousandths of the drawing's longer side. "sideOverFront" is the
/// area of the tree's silhouette from the side, leaves included, divided by that from the front.
Result<QJsonObject> sketchTree(TreeDocument& document, const CommandLine& line);

} // namespace espalier
