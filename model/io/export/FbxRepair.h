// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QByteArray>
#include <QByteArrayView>

namespace espalier {

/// Mends a binary FBX file as Assimp up to 5.2 writes it: there the lists of nested nodes lack the record of
/// zeros that ends them (25 bytes from version 7500 on, 13 before), without which Blender and others cannot
/// read the file. Writes the tree of nodes anew with those records and the offsets that follow from them; a
/// file that has them comes back the same. Fails if the content is no sound tree of nodes.
Result<QByteArray> repairFbx(QByteArrayView content);

} // namespace espalier
