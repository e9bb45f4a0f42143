// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <QIODevice>

namespace espalier {

/// Writes the living internodes as comma-separated values, a row each after the row of names
/// id,parent,x0,y0,z0,x1,y1,z1,radius: ids as in the tree, -1 as the parent of the first; lower and upper end
/// and radius in metres, z up (the tree's x, -z, y). Whether the device took it all.
bool writeSkeleton(QIODevice& device, const Tree& tree, const TreeIndex& index);

} // namespace espalier
