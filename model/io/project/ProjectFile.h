// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/io/project/Project.h"
#include "model/io/project/ProjectLimits.h"

#include <QByteArray>
#include <QImage>
#include <QString>

namespace espalier {

/// The tree at the moment that was shown. Can be called on any thread, also while a document that shares the
/// project's deltas travels.
Tree shownTree(const Project& project);

/// What a project file (.espalier) holds. The format is a ZIP archive of
///
/// - project.json: versions, name, seed, step, and how many rows the tables have;
/// - internodes/<column>, leaves/<column>, sparse/<column>.id and .value: the tables of TreeTables.h, one
/// file a column,
///   numbers little-endian, a rotation as four floats x, y, z, w; a column of which every row is the default
///   is left out;
/// - kept/<name>…: the values that the tree refers to: parameter sets, strokes of the lasso;
/// - journal/<number> with a row a delta, and journal/<table>.<column>.count, .row, .before and .after for
/// the cells that
///   the deltas changed;
/// - journal/records.deltas, .size and .json: what made the edits (EditRecord), the texts one after another;
/// files
///   that are older than records have none of these;
/// - look.json: the look of the scene (SceneLook); files that are older than looks have none;
/// - assets/<SHA-256>.png or .jpg: the images that the parameter sets and the look name by that hash, as they
///   were read, each once; project.json and look.json have their files' names;
/// - thumbnail.png, if there is one.
///
/// Members of project.json and entries that are not known are kept (ForeignParts), so that other programs can
/// put something of their own into a project.
///
/// Version 1, which had absent rows and no keys, is read and brought up to date (ProjectVersion1.h).
///
/// The file's bytes; equal projects give equal bytes. Fails for what unpackProject() would refuse: a project
/// beyond the limits, or one whose tree or journal is not sound.
Result<QByteArray> packProject(const Project& project);
/// Checks all that it reads, so that the tree and its journal can be trusted. A thumbnail that cannot be read
/// is left out; so is an image, or the look, and the project's warning says so.
Result<Project> unpackProject(const QByteArray& content);

/// Checks a project's tree and history as both the reader and the writer of files do.
Result<void> checkProject(const Project& project);

/// Replaces the file whole or leaves it as it was.
Result<void> saveProject(const Project& project, const QString& fileName);
Result<Project> loadProject(const QString& fileName);
/// Reads the thumbnail alone; null if there is none.
Result<QImage> readThumbnail(const QString& fileName);

} // namespace espalier
