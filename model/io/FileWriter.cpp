// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/FileWriter.h"

#include "model/io/JsonReader.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>

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

// How the names of temporary files begin: those of whole new files that wait for their names, and those of
// old files that are kept until a set of files is complete.
constexpr const char* kNew = ".espalier-new-";
constexpr const char* kOld = ".espalier-old-";

/// A name in the folder of @p target that no file has, and that is short, whatever the target's name.
QByteArray freeName(const QByteArray& target, const char* beginning)
{
    const QByteArray folder = target.first(target.lastIndexOf('/') + 1);
    return folder + beginning + QByteArray::number(QRandomGenerator::global()->generate64(), 36);
}

/// Removes new files that never got their names, since the program was killed just then. Old files stay: such
/// a file may be all that is left of a set.
void removeAbandoned(const QDir& folder)
{
    constexpr int kDays = 1; // Another program may be at work now
    const QDateTime recently = QDateTime::currentDateTime().addDays(-kDays);
    for (const QFileInfo& file :
         folder.entryInfoList({QLatin1String(kNew) + QLatin1Char('*')}, QDir::Files | QDir::Hidden)) {
        if (file.lastModified() < recently)
            QFile::remove(file.filePath());
    }
}

/// Path of the file that @p fileName names, or that it links to.
QByteArray realPath(const QString& fileName)
{
    if (const QString path = QFileInfo(fileName).canonicalFilePath(); !path.isEmpty())
        return QFile::encodeName(path);
    QFileInfo file(fileName);
    constexpr int kMostLinks = 40;
    for (int i = 0; i < kMostLinks && file.isSymLink(); ++i)
        file.setFile(file.symLinkTarget());
    return QFile::encodeName(file.absoluteFilePath());
}

/// Returns false if the source cannot be read.
bool copyContent(QFile& source, FileWriter& target)
{
    while (!source.atEnd()) {
        const QByteArray block = source.read(kBlock);
        if (block.isEmpty() && source.error() != QFileDevice::NoError)
            return false;
        target.write(block);
    }
    return true;
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
    case ELOOP:
        return WriterText::tr("it is a link that leads back to itself");
    case ENXIO:
        return WriterText::tr("no program reads from this pipe");
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
    closeDescriptor();
    if (!m_temporary.isEmpty())
        ::unlink(m_temporary.constData());
    dropOld();
}

void FileWriter::closeDescriptor()
{
    if (m_descriptor >= 0)
        ::close(std::exchange(m_descriptor, -1));
}

void FileWriter::openTarget()
{
    if (m_fileName.isEmpty()) {
        fail(WriterText::tr("a file needs a name"));
        return;
    }
    struct stat status = {};
    const QByteArray path = QFile::encodeName(m_fileName);
    const bool isThere = ::stat(path.constData(), &status) == 0;
    if (!isThere && (errno == ELOOP || errno == ENAMETOOLONG)) {
        fail(errno);
        return;
    }
    m_isDevice = isThere && !S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode);
    if (m_isDevice) {
        // Without a program that reads from it, opening a pipe would wait for ever.
        m_descriptor = ::open(path.constData(), O_WRONLY | O_CLOEXEC | O_NONBLOCK); // NOLINT
        if (m_descriptor < 0)
            fail(errno);
        else
            ::fcntl(m_descriptor, F_SETFL, ::fcntl(m_descriptor, F_GETFL) & ~O_NONBLOCK); // NOLINT
        return;
    }
    if (const QString problem = problemWithPlace(QFileInfo(m_fileName)); !problem.isEmpty()) {
        fail(problem);
        return;
    }
    m_target = realPath(m_fileName);
    openTemporary();
    if (m_descriptor >= 0 && isThere)
        ::fchmod(m_descriptor, status.st_mode & 07777U);
}

void FileWriter::openTemporary()
{
    constexpr mode_t kUsual = 0666; // less the user's mask
    const QByteArray folder = m_target.first(std::max<qsizetype>(m_target.lastIndexOf('/'), 1));
#ifdef O_TMPFILE
    // Such a file gets its name through /proc.
    if (::access("/proc/self/fd", X_OK) == 0)
        m_descriptor = ::open(folder.constData(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kUsual); // NOLINT
    if (m_descriptor >= 0)
        return;
#endif
    // Not every file system has files without a name.
    m_temporary = freeName(m_target, kNew);
    m_descriptor = ::open(m_temporary.constData(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, kUsual); // NOLINT
    if (m_descriptor >= 0)
        return;
    m_temporary.clear();
    fail(errno);
}

void FileWriter::nameTemporary()
{
    if (!m_temporary.isEmpty())
        return;
    const QByteArray link = "/proc/self/fd/" + QByteArray::number(m_descriptor);
    const QByteArray name = freeName(m_target, kNew);
    if (::linkat(AT_FDCWD, link.constData(), AT_FDCWD, name.constData(), AT_SYMLINK_FOLLOW) == 0)
        m_temporary = name;
    else
        fail(errno);
}

void FileWriter::fail(int number)
{
    fail(systemReason(number));
}

void FileWriter::fail(const QString& reason)
{
    if (m_result)
        m_reason = reason;
    if (!m_result)
        return;
    m_result = Error{Error::Kind::Output, inputError(QFileInfo(m_fileName).fileName(), reason).message};
    setErrorString(reason);
}

void FileWriter::writeOut(const char* data, qint64 size)
{
    // Not through QSaveFile, which keeps data in a buffer and does not report if that buffer could not be
    // written in the end (Qt 6.4).
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
    nameTemporary();
    if (m_result && ::close(std::exchange(m_descriptor, -1)) != 0)
        fail(errno);
    if (m_result && ::rename(m_temporary.constData(), m_target.constData()) != 0)
        fail(errno);
    if (!m_result)
        return m_result;
    m_temporary.clear();
    const QFileInfo target(QFile::decodeName(m_target));
    syncFolder(target.path());
    removeAbandoned(target.dir());
    return {};
}

Result<void> FileWriter::keepOld()
{
    if (m_isDevice || ::access(m_target.constData(), F_OK) != 0)
        return {};
    const QByteArray name = freeName(m_target, kOld);
    if (::link(m_target.constData(), name.constData()) == 0) {
        m_old = name;
        return {};
    }
    // Some file systems have no second names for a file: there it is a copy.
    QFile target(QFile::decodeName(m_target));
    FileWriter copy(QFile::decodeName(name));
    struct stat status = {};
    if (!target.open(QIODevice::ReadOnly))
        fail(target.errorString());
    else if (copy.m_descriptor >= 0 && ::fstat(target.handle(), &status) == 0)
        ::fchmod(copy.m_descriptor, status.st_mode & 07777U);
    if (m_result && !copyContent(target, copy))
        fail(target.errorString());
    if (m_result && !copy.commit())
        fail(copy.m_reason);
    if (m_result)
        m_old = name;
    return m_result;
}

void FileWriter::dropOld()
{
    if (!m_old.isEmpty())
        ::unlink(std::exchange(m_old, {}).constData());
}

void FileWriter::restoreOld()
{
    if (m_isDevice)
        return;
    if (m_old.isEmpty()) {
        ::unlink(m_target.constData());
        return;
    }
    // If that fails, the old content stays under the other name.
    static_cast<void>(::rename(m_old.constData(), m_target.constData()));
    m_old.clear();
}

Result<void> FileWriter::commitAll(const std::vector<FileWriter*>& files)
{
    Result<void> done;
    for (FileWriter* file : files) {
        if (done)
            done = file->finish();
    }
    // The last file needs no way back: it stays as it was if its commit() fails.
    for (std::size_t i = 0; done && i + 1 < files.size(); ++i)
        done = files[i]->keepOld();
    std::size_t committed = 0;
    while (done && committed < files.size()) {
        done = files[committed]->commit();
        committed += done ? 1 : 0;
    }
    if (!done) {
        while (committed-- > 0)
            files[committed]->restoreOld();
    }
    for (FileWriter* file : files)
        file->dropOld();
    return done;
}

Result<void> writeFile(const QString& fileName, const QByteArray& bytes)
{
    FileWriter writer(fileName);
    writer.write(bytes);
    return writer.commit();
}

Result<void> appendToFile(const QString& fileName, const QByteArray& bytes, qint64 size)
{
    const auto failed = [&fileName](int number) {
        return Error{Error::Kind::Output,
                     inputError(QFileInfo(fileName).fileName(), systemReason(number)).message};
    };
    const int descriptor =
        ::open(QFile::encodeName(fileName).constData(), // NOLINT
               O_WRONLY | O_APPEND | O_CLOEXEC | (size == 0 ? O_CREAT : 0), S_IRUSR | S_IWUSR);
    if (descriptor < 0)
        return failed(errno);
    const off_t before = ::lseek(descriptor, 0, SEEK_END);
    int fault = before < 0 ? errno : 0;
    if (fault == 0 && before != size) {
        ::close(descriptor);
        return Error{Error::Kind::Output, inputError(QFileInfo(fileName).fileName(),
                                                     WriterText::tr("another program has changed it"))
                                              .message};
    }
    const char* data = bytes.constData();
    for (qsizetype left = bytes.size(); fault == 0 && left > 0;) {
        const ssize_t written = ::write(descriptor, data, static_cast<std::size_t>(left));
        if (written > 0) {
            data += written;
            left -= written;
        } else if (written == 0 || errno != EINTR) {
            fault = written == 0 ? ENOSPC : errno;
        }
    }
    if (fault == 0 && ::fdatasync(descriptor) != 0 && !cannotSync(errno))
        fault = errno;
    if (fault != 0 && before >= 0)
        static_cast<void>(::ftruncate(descriptor, before));
    if (::close(descriptor) != 0 && fault == 0)
        fault = errno;
    return fault == 0 ? Result<void>() : failed(fault);
}

Result<void> copyFile(const QString& from, const QString& to)
{
    QFile source(from);
    FileWriter writer(to);
    if (!source.open(QIODevice::ReadOnly) || !copyContent(source, writer))
        return inputError(QFileInfo(from).fileName(), source.errorString());
    return writer.commit();
}

} // namespace espalier
