// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/FileWriter.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QFile>
#include <QFileInfo>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

namespace espalier {

namespace {

struct WriterText {
    Q_DECLARE_TR_FUNCTIONS(FileWriter)
};

/// Bytes that are written at once.
constexpr qsizetype kBlock = 1 << 16;

/// Whether @p number says that a file system does not support bringing a file or folder to the disk, as with
/// some network and virtual file systems; that is not a failure.
bool cannotSync(int number)
{
    return number == EINVAL || number == ENOSYS || number == ENOTSUP || number == EROFS;
}

/// Brings a folder's list of names to the disk, so that a rename survives a power cut. If that fails, the new
/// file is in place nevertheless.
void syncFolder(const QString& folder)
{
    const int descriptor =
        ::open(QFile::encodeName(folder).constData(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); // NOLINT
    if (descriptor < 0)
        return;
    ::fsync(descriptor);
    ::close(descriptor);
}

/// The reason why no file can be made there, as far as it is known before trying; empty if there is none.
QString problemWithPlace(const QFileInfo& target)
{
    const QFileInfo folder(target.absolutePath());
    if (!folder.exists())
        return WriterText::tr("the folder %1 does not exist").arg(folder.filePath());
    if (!folder.isDir())
        return WriterText::tr("%1 is not a folder").arg(folder.filePath());
    if (target.isDir())
        return WriterText::tr("a folder with this name already exists");
    if (!target.exists() && !folder.isWritable())
        return WriterText::tr("you may not write into the folder %1").arg(folder.filePath());
    if (target.exists() && !target.isWritable())
        return WriterText::tr("you may not change this file");
    return {};
}

/// Why Qt could not open or replace the file. Compares Qt's error text with those of known errors, because
/// errno may have changed since.
QString reasonOf(const QFileDevice& file, int number)
{
    for (const int known : {ENOSPC, EDQUOT, EROFS, EACCES, EPERM, EFBIG, EIO, ENAMETOOLONG, EMFILE, ENFILE}) {
        if (file.errorString() == qt_error_string(known))
            return systemReason(known);
    }
    return systemReason(number);
}

} // namespace

QString systemReason(int number)
{
    switch (number) {
    case ENOSPC:
        return WriterText::tr("the disk is full");
    case EDQUOT:
        return WriterText::tr("your disk quota is used up");
    case EROFS:
        return WriterText::tr("the disk is read-only");
    case EACCES:
    case EPERM:
        return WriterText::tr("you may not write here");
    case EFBIG:
        return WriterText::tr("the file is too large for this disk");
    case EIO:
        return WriterText::tr("the disk reports an error");
    case ENAMETOOLONG:
        return WriterText::tr("the name is too long");
    case EMFILE:
    case ENFILE:
        return WriterText::tr("too many files are open");
    default:
        return number == 0 ? WriterText::tr("the system does not say why") : qt_error_string(number);
    }
}

FileWriter::FileWriter(const QString& fileName) : m_fileName(fileName)
{
    openTarget();
    QIODevice::open(QIODevice::WriteOnly | QIODevice::Unbuffered);
}

FileWriter::~FileWriter()
{
    if (m_isDevice && m_descriptor >= 0)
        ::close(m_descriptor);
}

void FileWriter::openTarget()
{
    if (m_fileName.isEmpty()) {
        fail(WriterText::tr("a file needs a name"));
        return;
    }
    struct stat status = {};
    const QByteArray path = QFile::encodeName(m_fileName);
    m_isDevice =
        ::stat(path.constData(), &status) == 0 && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    if (m_isDevice) {
        m_descriptor = ::open(path.constData(), O_WRONLY | O_CLOEXEC); // NOLINT
        if (m_descriptor < 0)
            fail(errno);
        return;
    }
    if (const QString problem = problemWithPlace(QFileInfo(m_fileName)); !problem.isEmpty()) {
        fail(problem);
        return;
    }
    m_file.setFileName(m_fileName);
    errno = 0;
    if (!m_file.open(QIODevice::WriteOnly | QIODevice::Unbuffered)) {
        fail(reasonOf(m_file, errno));
        return;
    }
    m_descriptor = m_file.handle();
    if (m_descriptor < 0)
        fail(0);
}

void FileWriter::fail(int number)
{
    fail(systemReason(number));
}

void FileWriter::fail(const QString& reason)
{
    if (!m_result)
        return;
    m_result = Error{Error::Kind::Output, inputError(QFileInfo(m_fileName).fileName(), reason).message};
    setErrorString(reason);
    if (m_file.isOpen())
        m_file.cancelWriting();
}

void FileWriter::writeOut(const char* data, qint64 size)
{
    // Writes to the descriptor and not to QSaveFile, which keeps data in a buffer and does not report if that
    // buffer could not be written in the end (Qt 6.4).
    while (m_result && size > 0) {
        const ssize_t written = ::write(m_descriptor, data, static_cast<std::size_t>(size));
        if (written < 0 && errno == EINTR)
            continue;
        if (written <= 0) {
            fail(written < 0 ? errno : ENOSPC);
            return;
        }
        data += written;
        size -= written;
    }
}

void FileWriter::flushBlock()
{
    writeOut(m_block.constData(), m_block.size());
    m_block.resize(0);
}

qint64 FileWriter::writeData(const char* data, qint64 size)
{
    if (m_block.size() + size > kBlock)
        flushBlock();
    if (size > kBlock)
        writeOut(data, size);
    else
        m_block.append(data, static_cast<qsizetype>(size));
    return m_result ? size : -1;
}

Result<void> FileWriter::finish()
{
    flushBlock();
    if (m_result && !m_isDevice && !std::exchange(m_isFinished, true) && ::fsync(m_descriptor) != 0 &&
        !cannotSync(errno))
        fail(errno);
    return m_result;
}

Result<void> FileWriter::commit()
{
    if (!finish())
        return m_result;
    if (m_isDevice) {
        if (::close(std::exchange(m_descriptor, -1)) != 0)
            fail(errno);
        return m_result;
    }
    errno = 0;
    if (!m_file.commit()) {
        fail(reasonOf(m_file, errno));
        return m_result;
    }
    const QFileInfo target(m_fileName);
    syncFolder(target.isSymLink() ? QFileInfo(target.symLinkTarget()).absolutePath() : target.absolutePath());
    return {};
}

Result<void> writeFile(const QString& fileName, const QByteArray& bytes)
{
    FileWriter writer(fileName);
    writer.write(bytes);
    return writer.commit();
}

Result<void> copyFile(const QString& from, const QString& to)
{
    QFile source(from);
    const auto unreadable = [&] { return inputError(QFileInfo(from).fileName(), source.errorString()); };
    if (!source.open(QIODevice::ReadOnly))
        return unreadable();
    FileWriter writer(to);
    while (!source.atEnd()) {
        const QByteArray block = source.read(kBlock);
        if (block.isEmpty() && source.error() != QFileDevice::NoError)
            return unreadable();
        writer.write(block);
    }
    return writer.commit();
}

} // namespace espalier
