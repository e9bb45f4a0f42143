// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QDateTime>
#include <QString>

namespace espalier {

/// Size and time of a file: cheap to compare, but a file can change without them. A first hint that the file
/// was written.
struct FileStamp {
    qint64 size = -1;   ///< bytes; -1 if there is no file
    QDateTime modified; ///< Null if there is no file

    static FileStamp of(const QString& fileName);
    bool operator==(const FileStamp&) const = default;
};

/// What a file holds, so that a change by another window or another program is noticed.
struct FileContent {
    qint64 size = -1; ///< bytes; -1 if there is no file, or none that can be read
    QByteArray hash;  ///< SHA-256 of the bytes

    /// Reads all of the file; may run on any thread.
    static FileContent of(const QString& fileName);
    static FileContent of(const QByteArray& bytes);
    bool exists() const { return size >= 0; }
    bool operator==(const FileContent&) const = default;

    /// Converts to one line for a side file, and back; a line that is not valid gives a content that does not
    /// exist.
    QString toLine() const;
    static FileContent fromLine(const QString& line);
};

} // namespace espalier
