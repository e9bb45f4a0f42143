// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QByteArray>

namespace espalier {

/// Which files readFile() reads.
enum class FileKind {
    Regular, ///< Nothing else: a device or a pipe may never end
    Any,     ///< Also what was piped into the program: /dev/stdin, /dev/fd/3
};

/// All bytes of a file, if there are at most @p most. The message of an error names the file without its
/// folder.
Result<QByteArray> readFile(const QString& fileName, qint64 most, FileKind kind = FileKind::Regular);

} // namespace espalier
