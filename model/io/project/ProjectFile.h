// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Tree.h"

#include <QByteArray>
#include <QImage>
#include <QString>

namespace espalier {

/// What a project file (.espalier) holds. The format is a ZIP archive of
///
/// - project.json: versions, name, seed, step, how many rows the columns have, and the parameter sets, the
///   first in whole and each other as far as it differs from the one before;
/// - tree/<column>: one file a column of InternodeColumns, numbers little-endian, a rotation as four floats
///   x, y, z, w;
/// - journal/<column>: the deltas as columns, then their deaths and changed buds in the same order;
/// - assets/<SHA-256>.png or .jpg: the images that the parameter sets name by that hash, as they were read,
/// each
///   once; project.json has their files' names;
/// - lasso/<column>: the strokes of the lasso as columns, then their points in the same order;
/// - thumbnail.png, if there is one.
struct Project {
    Tree tree{};
    Journal journal; ///< Its deltas stand applied
    QString name;
    QImage thumbnail; ///< May be null
    /// So many of the last deltas lie ahead of the moment that was shown.
    std::uint32_t ahead = 0;
    /// One sentence for a person about what of the file could not be taken over, such as an image that is
    /// missing in it; not part of a file.
    QString warning{};
};

/// The tree at the moment that was shown.
Tree shownTree(const Project& project);

namespace projectLimits {
inline constexpr int kVersion = 1;
inline constexpr std::uint32_t kInternodes = 20'000'000;
inline constexpr std::uint32_t kDeltas = 4'000'000;
inline constexpr std::uint32_t kBudChanges = 100'000'000;
inline constexpr std::uint32_t kFrames = 100'000'000;
inline constexpr std::uint32_t kWidths = 10'000'000;
inline constexpr std::uint32_t kLassos = 100'000;
inline constexpr std::uint32_t kLassoPoints = 10'000'000; ///< In all
inline constexpr std::uint32_t kLassoChanges = 10'000'000;
inline constexpr std::uint32_t kParameterSets = 65'536;
inline constexpr std::uint32_t kImages = 4096;
inline constexpr qsizetype kImageBytes = qsizetype{512} << 20; ///< In all
inline constexpr float kWorld = 10'000.0F; ///< m; no node may be further away from the origin along an axis
} // namespace projectLimits

/// The file's bytes; equal projects give equal bytes. Fails for a project beyond the limits.
Result<QByteArray> packProject(const Project& project);
/// Checks all that it reads, so that the tree and its journal can be trusted. A thumbnail that cannot be read
/// is left out; so is an image, and the project's warning says so.
Result<Project> unpackProject(const QByteArray& content);

/// Replaces the file whole or leaves it as it was.
Result<void> saveProject(const Project& project, const QString& fileName);
Result<Project> loadProject(const QString& fileName);
/// Reads the thumbnail alone; null if there is none.
Result<QImage> readThumbnail(const QString& fileName);

} // namespace espalier
