// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QDateTime>
#include <QImage>
#include <QString>

#include <functional>

namespace espalier {

/// Something in the library that a person can open or start from.
struct LibraryEntry {
    QString fileName;  ///< A project, or a recipe of the program
    QString name;      ///< For a person
    QString line;      ///< A recipe's description; empty for a project
    QDateTime changed; ///< Of a project

    bool operator==(const LibraryEntry&) const = default;
};

/// Reads the picture of an entry's file, null if it has none; called on a worker thread.
using PictureReader = std::function<Result<QImage>(const QString& fileName)>;

} // namespace espalier
