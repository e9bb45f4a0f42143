// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/ParametersJson.h"
#include "model/io/ZipArchive.h"
#include "model/tree/Tree.h"

namespace espalier {

class ProjectImages;

// How the archive of a project holds kept values, each kind in entries kept/<name>…: an addKept() and a
// readKept() for each type of the list ESPALIER_KEPT_VALUES. The readers check sizes; treeFault() checks the
// values.

/// kept/<name>.json has the first set in whole, and of each other set what differs from the one before.
void addKept(ZipWriter& archive, const QByteArray& name, const QList<TreeParameters>& sets);
Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<TreeParameters>& sets);

/// kept/<name>.origin, .right, .up and .pointCount have a row a stroke, kept/<name>.points the points of all
/// strokes.
void addKept(ZipWriter& archive, const QByteArray& name, const QList<LassoStroke>& strokes);
Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<LassoStroke>& strokes);

/// kept/<name>.json has an array of profiles in the form of ProfileJson.
void addKept(ZipWriter& archive, const QByteArray& name, const QList<StrandProfile>& profiles);
Result<void> readKept(const ZipReader& archive, const QByteArray& name, ProjectImages& images,
                      QList<StrandProfile>& profiles);

/// Reads the sets of a JSON array that has the form of kept/parameters.json.
Result<QList<TreeParameters>> readParameterSets(const QJsonArray& array, ProjectImages& images);
/// Reads the columns of lasso strokes, whose names are @p prefix and the column's name.
Result<void> readLassoColumns(const ZipReader& archive, const QByteArray& prefix,
                              QList<LassoStroke>& strokes);

} // namespace espalier
