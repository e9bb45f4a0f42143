// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/FaultyDisk.h"

#include <QByteArray>
#include <QFile>

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>

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

using Moment = espalier::test::FaultyDisk::Moment;

constexpr int kNoDeath = -2;
std::atomic<int> deathCall = kNoDeath; // kNever if the calls are only noted
Moment deathMoment = Moment::Before;
std::array<char, 1 << 16> traced;
std::atomic<int> tracedCount = 0;

[[noreturn]] void die()
{
    ::kill(::getpid(), SIGKILL);
    std::abort();
}

/// One call that changes files. The process may die before it or after it.
class MortalCall {
public:
    MortalCall(bool isAtRisk, char kind) : m_isMortal(isAtRisk && deathCall != kNoDeath)
    {
        if (!m_isMortal)
            return;
        const int number = tracedCount++;
        traced.at(static_cast<std::size_t>(number)) = kind;
        m_isLast = number == deathCall;
        if (isMoment(Moment::Before))
            die();
    }
    ~MortalCall()
    {
        if (m_isLast)
            die();
    }
    MortalCall(const MortalCall&) = delete;
    MortalCall& operator=(const MortalCall&) = delete;

    /// Whether the process dies in this call, at @p moment.
    bool isMoment(Moment moment) const { return m_isLast && deathMoment == moment; }

private:
    bool m_isMortal;
    bool m_isLast = false;
};

template <class Function>
Function* real(const char* name)
{
    return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool isWritten(int descriptor)
{
    const int flags = ::fcntl(descriptor, F_GETFL); // NOLINT
    return flags >= 0 && (flags & O_ACCMODE) != O_RDONLY;
}

int openAnyhow(const char* name, const char* path, int flags, mode_t mode)
{
    // O_TMPFILE has the bits of O_DIRECTORY, which do not make a file.
    const bool makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE || (flags & O_TRUNC) != 0;
    const QByteArray place = QByteArray(path) + '/'; // the folder itself, with O_TMPFILE
    const MortalCall call(makes && isAtRisk(place), 'o');
    return real<int(const char*, int, ...)>(name)(path, flags, mode);
}

} // namespace

extern "C" {

int open(const char* path, int flags, ...) // NOLINT
{
    va_list more;
    va_start(more, flags);
    const auto mode = static_cast<mode_t>(va_arg(more, unsigned)); // read also if there is none
    va_end(more);
    return openAnyhow("open", path, flags, mode);
}

int open64(const char* path, int flags, ...) // NOLINT
{
    va_list more;
    va_start(more, flags);
    const auto mode = static_cast<mode_t>(va_arg(more, unsigned));
    va_end(more);
    return openAnyhow("open64", path, flags, mode);
}

int close(int descriptor)
{
    const MortalCall mortal(isAtRisk(descriptor) && isWritten(descriptor), 'c');
    static auto* const call = real<int(int)>("close");
    return call(descriptor);
}

int unlink(const char* path) noexcept
{
    const MortalCall mortal(isAtRisk(QByteArray(path)), 'u');
    static auto* const call = real<int(const char*)>("unlink");
    return call(path);
}

int ftruncate(int descriptor, off_t size) noexcept
{
    const MortalCall mortal(isAtRisk(descriptor), 't');
    static auto* const call = real<int(int, off_t)>("ftruncate");
    return call(descriptor, size);
}

int ftruncate64(int descriptor, off64_t size) noexcept
{
    const MortalCall mortal(isAtRisk(descriptor), 't');
    static auto* const call = real<int(int, off64_t)>("ftruncate64");
    return call(descriptor, size);
}

int fchmod(int descriptor, mode_t mode) noexcept
{
    const MortalCall mortal(isAtRisk(descriptor), 'm');
    static auto* const call = real<int(int, mode_t)>("fchmod");
    return call(descriptor, mode);
}

ssize_t write(int descriptor, const void* bytes, std::size_t count)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    const MortalCall mortal(isAtRisk(descriptor), 'w');
    static auto* const call = real<ssize_t(int, const void*, std::size_t)>("write");
    return call(descriptor, bytes, mortal.isMoment(Moment::HalfWay) ? count / 2 : count);
}

int fsync(int descriptor)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    const MortalCall mortal(isAtRisk(descriptor), 's');
    static auto* const call = real<int(int)>("fsync");
    return call(descriptor);
}

int fdatasync(int descriptor)
{
    if (isAtRisk(descriptor) && fails(false))
        return -1;
    const MortalCall mortal(isAtRisk(descriptor), 's');
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
    const MortalCall mortal(isAtRisk(QByteArray(to)), 'r');
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
    const MortalCall mortal(isAtRisk(QByteArray(to)), 'l');
    static auto* const call = real<int(const char*, const char*)>("link");
    return call(from, to);
}

int linkat(int fromFolder, const char* from, int toFolder, const char* to, int flags) noexcept
{
    if (isAtRisk(QByteArray(to)) && fails(true))
        return -1;
    const MortalCall mortal(isAtRisk(QByteArray(to)), 'l');
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

FaultyDisk::FaultyDisk(const QString& folder, Death death) : FaultyDisk(folder, kNever, 0)
{
    tracedCount = 0;
    deathMoment = death.moment;
    deathCall = death.call;
}

FaultyDisk::~FaultyDisk()
{
    deathCall = kNoDeath;
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

QByteArray FaultyDisk::trace() const
{
    return QByteArray(traced.data(), tracedCount);
}

} // namespace espalier::test
