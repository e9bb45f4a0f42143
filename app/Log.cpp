// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Log.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>

#include <execinfo.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <cstring>
#include <exception>
#include <mutex>

namespace espalier {

namespace {

constexpr qint64 kMostBytes = 1 << 20; ///< Of one file
constexpr int kFiles = 3;
constexpr std::array kCrashes{SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT};

std::mutex mutex;
/// The crash handler reads it, too.
std::atomic<int> descriptor = -1;
QtMessageHandler otherHandler = nullptr;
std::array<char, 1024> crashAdvice{};

QString nameOf(int number)
{
    const QString name =
        number == 0 ? QStringLiteral("espalier.log") : QStringLiteral("espalier.%1.log").arg(number);
    return QDir(Log::folder()).filePath(name);
}

void rotate()
{
    QFile::remove(nameOf(kFiles - 1));
    for (int number = kFiles - 1; number > 0; --number)
        QFile::rename(nameOf(number - 1), nameOf(number));
}

/// Opens the file; the caller has the mutex.
void openFile()
{
    if (QFileInfo(nameOf(0)).size() > kMostBytes)
        rotate();
    const int opened = ::open(QFile::encodeName(nameOf(0)).constData(), // NOLINT
                              O_WRONLY | O_APPEND | O_CREAT | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
    const int before = descriptor.exchange(opened);
    if (before >= 0)
        ::close(before);
}

void handleMessage(QtMsgType type, const QMessageLogContext& context, const QString& message)
{
    if (type != QtDebugMsg && type != QtInfoMsg)
        Log::note(QStringLiteral("Qt: ") + message);
    if (otherHandler)
        otherHandler(type, context, message);
}

void writeAll(int to, const char* text)
{
    static_cast<void>(!::write(to, text, std::strlen(text)));
}

/// Only functions that a signal handler may call; backtrace() may since it was called before.
void handleCrash(int number)
{
    // If the loader is at work, the next call may wait for it for ever.
    ::alarm(5);
    std::array<void*, 64> frames{};
    const int count = ::backtrace(frames.data(), static_cast<int>(frames.size()));
    const int file = descriptor;
    for (const int to : {file, STDERR_FILENO}) {
        if (to < 0)
            continue;
        writeAll(to, "Espalier ended because of a fault: signal ");
        const std::array<char, 4> digits{static_cast<char>('0' + number / 10),
                                         static_cast<char>('0' + number % 10), '\n', '\0'};
        writeAll(to, digits.data());
    }
    writeAll(STDERR_FILENO, crashAdvice.data());
    if (file >= 0)
        ::backtrace_symbols_fd(frames.data(), count, file);
    // The handler stands back for one signal only, so this ends the program.
    ::raise(number);
}

} // namespace

QString Log::folder()
{
#ifdef Q_OS_LINUX
    const QString state = qEnvironmentVariable("XDG_STATE_HOME");
    const QString base =
        QDir::isAbsolutePath(state) ? state : QDir::home().filePath(QStringLiteral(".local/state"));
    return base + QStringLiteral("/espalier");
#else
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + QStringLiteral("/log");
#endif
}

QString Log::fileName()
{
    return nameOf(0);
}

void Log::open()
{
    {
        const std::scoped_lock lock(mutex);
        QDir().mkpath(folder());
        openFile();
    }
    otherHandler = qInstallMessageHandler(handleMessage);
}

void Log::close()
{
    qInstallMessageHandler(otherHandler);
    const std::scoped_lock lock(mutex);
    if (const int opened = descriptor.exchange(-1); opened >= 0)
        ::close(opened);
}

void Log::note(const QString& line)
{
    const std::scoped_lock lock(mutex);
    if (descriptor < 0)
        return;
    struct stat status = {};
    if (::fstat(descriptor, &status) == 0 && status.st_size > kMostBytes)
        openFile();
    QString plain = line.left(2000);
    plain.replace(QLatin1Char('\n'), QLatin1Char(' '));
    const QByteArray bytes = (QDateTime::currentDateTime().toString(Qt::ISODateWithMs) + QLatin1Char(' ') +
                              plain + QLatin1Char('\n'))
                                 .toUtf8();
    // One call, so that lines of several programs do not mix.
    static_cast<void>(!::write(descriptor, bytes.constData(), static_cast<std::size_t>(bytes.size())));
}

QString Log::tail(qsizetype bytes)
{
    QByteArray text;
    for (int number = 0; number < kFiles && text.size() < bytes; ++number) {
        QFile file(nameOf(number));
        if (file.open(QIODevice::ReadOnly))
            text.prepend(file.readAll());
    }
    if (text.size() <= bytes)
        return QString::fromUtf8(text);
    return QString::fromUtf8(text.sliced(text.indexOf('\n', text.size() - bytes) + 1));
}

void Log::catchCrashes(const QString& advice)
{
    const QByteArray text = advice.toUtf8().left(static_cast<qsizetype>(crashAdvice.size()) - 2) + '\n';
    std::memcpy(crashAdvice.data(), text.constData(), static_cast<std::size_t>(text.size()) + 1);
    // The first call loads a library, which a signal handler must not do.
    std::array<void*, 2> frames{};
    ::backtrace(frames.data(), static_cast<int>(frames.size()));
    // A stack that has run over has no room for the handler.
    static std::array<char, 64 * 1024> handlersStack;
    const stack_t stack{.ss_sp = handlersStack.data(), .ss_flags = 0, .ss_size = handlersStack.size()};
    ::sigaltstack(&stack, nullptr);
    struct sigaction action = {};
    action.sa_handler = handleCrash;
    action.sa_flags = static_cast<int>(SA_ONSTACK | SA_RESETHAND);
    ::sigemptyset(&action.sa_mask);
    for (const int number : kCrashes)
        ::sigaction(number, &action, nullptr);
}

} // namespace espalier
