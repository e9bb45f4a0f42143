// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/FileContent.h"
#include "app/files/FileLock.h"
#include "model/base/Error.h"
#include "model/io/project/Project.h"

#include <QSet>

#include <memory>
#include <vector>

namespace espalier {

/// The files of a safety copy: a project as it was at some time, the changes since, where the document comes
/// from, and a lock that says whether the program that writes them lives.
///
/// The file of changes begins with the hash of the project that they belong to, so changes of an earlier
/// project are never taken for those of the present one. Each piece has its length and a checksum: a piece
/// that is not whole, after a crash of the machine, ends the changes.
class SafetyCopy {
public:
    static constexpr const char* kSuffix = ".espalier";

    SafetyCopy() = default;
    /// @p base: path of the files without their suffixes.
    explicit SafetyCopy(QString base) : m_base(std::move(base)) {}
    /// The copy whose project file is @p fileName.
    static SafetyCopy ofProject(const QString& fileName);

    QString projectFile() const { return m_base + QLatin1String(kSuffix); }
    QString changesFile() const { return m_base + QStringLiteral(".changes"); }
    QString originFile() const { return m_base + QStringLiteral(".origin"); }
    QString lockFile() const { return m_base + QStringLiteral(".lock"); }

    /// Where the document comes from: the file's name, and what the file held then.
    struct Origin {
        QString fileName{};
        FileContent content{};
    };
    Result<void> writeOrigin(const Origin& origin) const;
    Origin readOrigin() const;

    /// What the writer of changes knows about the files. It goes from one job of a worker thread to the next.
    struct Written {
        QByteArray projectHash; ///< SHA-256
        QSet<QString> images;   ///< Hashes of those that the files hold
        qint64 projectBytes = 0;
        qint64 changeBytes = 0;
    };
    /// Writes a project, and ends the changes before it.
    Result<Written> writeProject(const Project& project) const;
    /// The same with the bytes of a file, if the file still has @p content. Its project is not read.
    Result<Written> copyProject(const QString& fileName, const FileContent& content) const;
    /// The same with what another copy, or this one, holds; an error if its history has not so many deltas.
    Result<Written> takeOver(const SafetyCopy& other, std::size_t deltas) const;
    /// Adds a packed change (packChange()).
    Result<void> addChange(const QByteArray& packed, Written& written) const;

    /// The project with its changes.
    Result<Project> read() const;
    /// Whether it holds more than the file that the document comes from held.
    bool hasChanges() const;
    /// Whether there are bytes of changes that cannot be read.
    bool isTorn() const;
    /// Removes all files but the lock.
    void remove() const;

private:
    Result<Written> writeBytes(const QByteArray& bytes, QSet<QString> images) const;
    /// The changes that belong to the project with that hash.
    std::vector<QByteArray> readChanges(const QByteArray& projectHash) const;

    QString m_base;
};

} // namespace espalier
