// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ParametersJson.h"
#include "model/io/ZipArchive.h"
#include "model/tree/Tree.h"

namespace espalier {

class ProjectImages;

// How the archive of a project holds kept values, each kind in entries kept/<name>…: an addKept() and a
// readKept() for each type of the list ESPALIER_KEPT_VALUES. Readers check sizes; treeFault() checks the
// values.

/// kept/<name>.json: the first set in whole, each other as far as it differs from the one before.
void addKept(ZipWriter& archive, const QByteArray& name, const QList<TreeParameters>& sets);
Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<TreeParameters>& sets);

/// kept/<name>.origin, .right, .up and .pointCount have a row a stroke, kept/<name>.points the points of all.
void addKept(ZipWriter& archive, const QByteArray& name, const QList<LassoStroke>& strokes);
Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<LassoStroke>& strokes);

/// The sets of a JSON array, as kept/parameters.json has them.
Result<QList<TreeParameters>> readParameterSets(const QJsonArray& array, ProjectImages& images);
/// The same columns, whose names are @p prefix and the column's name.
Result<void> readLassoColumns(const ZipReader& archive, const QByteArray& prefix,
                              QList<LassoStroke>& strokes);

} // namespace espalier
