// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileLock.h"

#include <QFile>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace espalier {

std::shared_ptr<FileLock> FileLock::taken(const QString& fileName)
{
    const int descriptor = ::open(QFile::encodeName(fileName).constData(), // NOLINT
                                  O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
    if (descriptor < 0)
        return nullptr;
    // Another process may have removed the file between the two calls; a lock on it would be seen by none.
    struct stat locked = {};
    struct stat named = {};
    const bool isLocked = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor, &locked) == 0 &&
                          ::stat(QFile::encodeName(fileName).constData(), &named) == 0 &&
                          locked.st_ino == named.st_ino && locked.st_dev == named.st_dev;
    if (!isLocked) {
        ::close(descriptor);
        return nullptr;
    }
    return std::shared_ptr<FileLock>(new FileLock(descriptor));
}

FileLock::~FileLock()
{
    ::close(m_descriptor);
}

} // namespace espalier
