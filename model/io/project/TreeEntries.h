// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ZipArchive.h"
#include "model/tree/Tree.h"

namespace espalier {

/// Adds the tables of a tree to a project's archive, by the lists of columns in TreeTables.h:
/// internodes/<column>, leaves/<column>, sparse/<column>.id and sparse/<column>.value. A column of which
/// every row has the fallback is left out. The column of keys holds the difference between each key and the
/// key that follows from the parent's (Random.h), which is usually zero.
void addTree(ZipWriter& archive, const TreeContent& content);

/// Reads the tables into @p content; a column that the archive lacks is filled with its fallback. Checks
/// sizes, not values.
Result<void> readTree(const ZipReader& archive, std::uint32_t internodes, std::uint32_t leaves,
                      TreeContent& content);

/// Adds rows that deltas bring, in the entries that a tree would have, but with the keys themselves.
void addRows(ZipWriter& archive, const InternodeColumns& internodes, const LeafColumns& leaves);
/// Reads what addRows() added; checks sizes, not values.
Result<void> readRows(const ZipReader& archive, std::uint32_t internodes, std::uint32_t leaves,
                      TreeRows& rows);

} // namespace espalier
