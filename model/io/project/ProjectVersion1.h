// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/JsonReader.h"
#include "model/io/ZipArchive.h"
#include "model/io/project/Project.h"

namespace espalier::projectVersion1 {

/// Reads a project of version 1 and converts it to the current version. In version 1
///
/// - rows of undone births stayed in the tables, marked absent: they are removed, and the ids of the rows
///   behind them change;
/// - random numbers depended on ids: each internode gets the key that gives it the same numbers;
/// - buds were a set of living ones: these become active;
/// - project.json had parameter sets and widths, tree/<column> the internodes, lasso/<column> the strokes,
/// and
///   journal/<column> five kinds of changes.
///
/// The project's warning is the name of an image that could not be read, if there is one. The caller must
/// check the journal (checkJournal()).
Result<Project> read(const ZipReader& archive, JsonReader& reader);

} // namespace espalier::projectVersion1
