// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/JsonReader.h"
#include "model/io/ZipArchive.h"
#include "model/io/project/Project.h"

namespace espalier::projectVersion1 {

/// Reads a project of version 1 as one of today. In that version
///
/// - rows of undone births stayed in the tables, marked absent: they go, and the ids of those behind them
/// change;
/// - random numbers hung on ids: each internode gets the key that gives it the same ones;
/// - buds were a set of living ones: they are active;
/// - project.json had parameter sets and widths, tree/<column> the internodes, lasso/<column> the strokes,
/// and
///   journal/<column> five kinds of changes.
///
/// The project's warning is the name of an image that could not be read, if there is one. The journal is
/// still to be checked (checkJournal()).
Result<Project> read(const ZipReader& archive, JsonReader& reader);

} // namespace espalier::projectVersion1
