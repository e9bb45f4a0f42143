// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QDateTime>
#include <QImage>
#include <QString>

#include <functional>

namespace espalier {

/// An entry of the library that the user can open or start from.
struct LibraryEntry {
    QString fileName;  ///< File of a project, or of a recipe of the program
    QString name;      ///< Name that the user sees
    QString line;      ///< A recipe's description; empty for a project
    QDateTime changed; ///< Time of a project's last change

    bool operator==(const LibraryEntry&) const = default;
};

/// Reads the picture of an entry's file, null if it has none; called on a worker thread.
using PictureReader = std::function<Result<QImage>(const QString& fileName)>;

} // namespace espalier
