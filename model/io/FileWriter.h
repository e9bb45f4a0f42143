// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"

#include <QByteArray>
#include <QIODevice>

#include <vector>

namespace espalier {

/// A file that is being written. All code of this program writes files through this class
/// (scripts/check-writers.py checks that).
///
/// The text goes into a temporary file in the folder of the target, which has no name until it is whole, so a
/// program that is killed leaves nothing (where the file system has such files). commit() puts that file in
/// the target's place; until then, and if anything fails, the target stays as it was. A program that is
/// killed in commit() can leave a hidden file; a commit() into the same folder, a day later or more, removes
/// it. Permissions of an existing target are kept, and a symbolic link keeps pointing to its target, which is
/// what gets replaced. A device or a pipe (/dev/stdout) cannot be replaced: it is written to at once.
///
/// Errors are sticky: after the first one, writing does nothing, and finish() and commit() return it.
class FileWriter : public QIODevice {
public:
    /// Opens it. A failure is the result of finish() and commit().
    explicit FileWriter(const QString& fileName);
    /// Leaves the target as it was unless commit() succeeded.
    ~FileWriter() override;

    const QString& fileName() const { return m_fileName; }
    bool isSequential() const override { return true; }

    /// Brings all that was written to the disk. If the disk is full, this fails; after it has succeeded,
    /// commit() only renames. For files that belong together, call finish() of all before commit() of the
    /// first.
    Result<void> finish();
    /// Calls finish(), then replaces the target, then brings the folder to the disk.
    Result<void> commit();
    /// Commits all files, or none: if one fails, those before it get back what they had. If the program is
    /// killed meanwhile, some files are new, others old, and each is whole.
    static Result<void> commitAll(const std::vector<FileWriter*>& files);

protected:
    qint64 readData(char*, qint64) override { return -1; }
    qint64 writeData(const char* data, qint64 size) override;

private:
    void openTarget();
    void openTemporary();
    /// Gives the temporary file, which is whole, the name m_temporary.
    void nameTemporary();
    void closeDescriptor();
    /// Keeps what the target holds under another name until dropOld() or restoreOld().
    Result<void> keepOld();
    void dropOld();
    void restoreOld();
    void flushBlock();
    void writeOut(const char* data, qint64 size);
    /// Keeps the reason of a system call that failed with @p number, unless an earlier failure is kept.
    void fail(int number);
    void fail(const QString& reason);

    QString m_fileName;
    QByteArray m_target;    ///< Path of the file itself, not of a link to it
    QByteArray m_temporary; ///< Path; empty while the temporary file has no name
    QByteArray m_old;       ///< Path of what the target held; empty if it is not kept
    int m_descriptor = -1;
    bool m_isDevice = false; ///< The target is a device or a pipe
    bool m_isFinished = false;
    QByteArray m_block; ///< Small pieces that wait to be written together
    QString m_reason;   ///< Of the first failure
    Result<void> m_result;
};

/// Replaces the file by @p bytes whole, or leaves it as it was; see FileWriter. The message of an error names
/// the file without its folder.
Result<void> writeFile(const QString& fileName, const QByteArray& bytes);

/// Copies the content of a file; the target is replaced whole or stays as it was.
Result<void> copyFile(const QString& from, const QString& to);

/// Adds @p bytes at the end of a file of @p size bytes, which is made if the size is 0, and brings them to
/// the disk. If the file has another size, or if it fails, the file stays as it was, as far as the disk
/// allows: a reader must be able to tell a piece that is not whole.
Result<void> appendToFile(const QString& fileName, const QByteArray& bytes, qint64 size);

/// Why a system call failed with @p number (errno), in words for the user: "the disk is full".
QString systemReason(int number);

} // namespace espalier
