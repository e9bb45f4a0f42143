// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/FaultyDisk.h"

#include <QByteArray>
#include <QFile>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>

namespace {

QByteArray folderAtRisk; // Empty while the disk is good
int goodCallsLeft = 0;
bool failsOnce = false;
int errorNumber = 0;
std::atomic<int> callCount = 0;
std::atomic<int> firstNaming = -1;
bool hasLinks = true;
std::atomic<int> goodRenamesLeft = -1; // Below 0 if renames are calls as all others

bool isAtRisk(const QByteArray& path)
{
    return !folderAtRisk.isEmpty() && path.startsWith(folderAtRisk);
}

bool isAtRisk(int descriptor)
{
    struct stat status = {};
    if (folderAtRisk.isEmpty() || ::fstat(descriptor, &status) != 0 || !S_ISREG(status.st_mode))
        return false;
    char link[64];
    char path[4096];
    std::snprintf(link, sizeof link, "/proc/self/fd/%d", descriptor);
    const ssize_t length = ::readlink(link, path, sizeof path);
    return length > 0 && isAtRisk(QByteArray(path, static_cast<qsizetype>(length)));
}

/// Counts a call. Returns whether the call must fail.
bool fails(bool givesName)
{
    const int call = callCount++;
    if (givesName && firstNaming < 0)
        firstNaming = call;
    if (goodCallsLeft == espalier::test::FaultyDisk::kNever || call < goodCallsLeft)
        return false;
    if (failsOnce && call > goodCallsLeft)
        return false;
    errno = errorNumber;
    return true;
}

template <class Function>
Function* real(const char* name)
{
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

} // namespace

extern "C" {

ssize_t write(int descriptor, const void* bytes, std::size_t count)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    static auto* const call = real<ssize_t(int, const void*, std::size_t)>("write");
    return call(descriptor, bytes, count);
}

int fsync(int descriptor)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    static auto* const call = real<int(int)>("fsync");
    return call(descriptor);
}

int fdatasync(int descriptor)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    static auto* const call = real<int(int)>("fdatasync");
    return call(descriptor);
}

int rename(const char* from, const char* to) noexcept
{
    if (isAtRisk(QByteArray(to)) && goodRenamesLeft >= 0 && goodRenamesLeft-- == 0) {
        errno = errorNumber;
        return -1;
    }
    if (isAtRisk(QByteArray(to)) && fails(true))
        return -1;
    static auto* const call = real<int(const char*, const char*)>("rename");
    return call(from, to);
}

int link(const char* from, const char* to) noexcept
{
    if (isAtRisk(QByteArray(to)) && !hasLinks) {
        errno = EPERM;
        return -1;
    }
    if (isAtRisk(QByteArray(to)) && fails(false))
        return -1;
    static auto* const call = real<int(const char*, const char*)>("link");
    return call(from, to);
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept
{
    if (isAtRisk(QByteArray(to)) && fails(true))
        return -1;
    static auto* const call = real<int(int, const char*, int, const char*, int)>("linkat");
    return call(fromFolder, from, toFolder, to, flags);
}

} // extern "C"

namespace espalier::test {

FaultyDisk::FaultyDisk(const QString& folder, int goodCalls, int error)
{
    goodCallsLeft = goodCalls;
    errorNumber = error;
    callCount = 0;
    firstNaming = -1;
    folderAtRisk = QFile::encodeName(folder) + '/';
}

FaultyDisk::FaultyDisk(const QString& folder, Renames renames, int error) : FaultyDisk(folder, kNever, error)
{
    goodRenamesLeft = renames.good;
    hasLinks = renames.hasLinks;
}

FaultyDisk::FaultyDisk(const QString& folder, Once once, int error) : FaultyDisk(folder, once.good, error)
{
    failsOnce = true;
}

FaultyDisk::~FaultyDisk()
{
    failsOnce = false;
    hasLinks = true;
    folderAtRisk.clear();
    goodRenamesLeft = -1;
}

int FaultyDisk::calls() const
{
    return callCount;
}

int FaultyDisk::callsBeforeNaming() const
{
    return firstNaming < 0 ? callCount.load() : firstNaming.load();
}

} // namespace espalier::test
