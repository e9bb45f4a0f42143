// SPDX-License-Identifier: GPL-3.0-or-later
// Lets each call that writes, names or brings a file to the disk fail, and each allocation of more than a
// megabyte, one after another, while a tree is saved, kept in a safety copy and exported. With --deaths, the
// process is killed at such a call. Without --all the short runs that are among the tests; "fault_test --all"
// and "fault_test --deaths --all" try every call.
#include "model/base/Memory.h"
#include "model/base/WithinMemory.h"
#include "tests/fault/Deaths.h"
#include "tests/fault/FaultyMemory.h"
#include "tests/fault/Jobs.h"
#include "tests/support/FaultyDisk.h"

#include <QCommandLineParser>
#include <QGuiApplication>

#include <tbb/global_control.h>

#include <cerrno>
#include <cstdio>

namespace espalier::test {

namespace {

/// Allocations above this size may fail, bytes: a megabyte for the textures of an export; the columns of the
/// small tree are as the larger ones of a large tree.
std::size_t largeFor(const Job& job)
{
    return job.isExport() ? 1 << 20 : 1 << 15;
}

class FaultTest {
public:
    explicit FaultTest(bool all) : m_triesOfAKind(all ? 1'000'000 : 4) {}

    /// Returns what went wrong, or nothing.
    QString run();

private:
    QString tryJob(const Job& job);
    /// @p reason: part of the message that is expected.
    /// @p isDead: since a fault, all calls to the disk fail, so that a set of files cannot be put back.
    QString check(const Job& job, const Result<void>& result, const QString& reason, bool isDead);

    const int m_triesOfAKind;
    Jobs m_jobs{9'000, 1024};
    Files m_old;
    Files m_new;
    int m_tries = 0;
};

/// Whether each file is either the old or the new one; what cannot be put back may stay under another name.
bool isEachOldOrNew(const Files& found, const Files& before, const Files& after)
{
    for (auto file = found.begin(); file != found.end(); ++file) {
        const bool isOld = before.contains(file.key()) && before[file.key()] == file.value();
        const bool isNew = after.contains(file.key()) && after[file.key()] == file.value();
        const bool isKept = isTemporary(file.key()) && before.values().contains(file.value());
        if (!isOld && !isNew && !isKept)
            return false;
    }
    return true;
}

QString FaultTest::check(const Job& job, const Result<void>& result, const QString& reason, bool isDead)
{
    ++m_tries;
    const Files found = filesIn(m_jobs.folder());
    const bool isWhole =
        isDead && job.isExport() ? isEachOldOrNew(found, m_old, m_new) : job.isWhole(found, m_old, m_new);
    if (!isWhole)
        return QStringLiteral("the files are a mixture of old and new ones: ") +
               found.keys().join(QLatin1Char(' '));
    if (result) {
        if (found != m_new)
            return QStringLiteral("it says that it succeeded, but did not");
        return {}; // The fault did no harm: the old files could not be kept under other names, for example
    }
    if (!result.error().message.contains(reason))
        return QStringLiteral("the message is “%1”").arg(result.error().message);
    if (m_jobs.hasDocumentChanged())
        return QStringLiteral("the document has changed");
    return {};
}

QString FaultTest::tryJob(const Job& job)
{
    const QString folder = m_jobs.folder();
    const auto work = [&] { return job.work(folder); };
    if (const Result<void> done = m_jobs.prepare(job); !done)
        return done.error().message;
    m_old = filesIn(folder);
    int diskCalls = 0;
    int allocations = 0;
    {
        const FaultyDisk disk(folder, FaultyDisk::kNever, 0);
        const FaultyMemory memory(FaultyMemory::kNever, largeFor(job));
        if (const Result<void> done = work(); !done)
            return done.error().message;
        diskCalls = disk.calls();
        allocations = memory.calls();
    }
    m_new = filesIn(folder);

    const auto step = [this](int calls) { return std::max(1, calls / m_triesOfAKind); };
    for (const bool isOnce : {true, false}) {
        for (int call = 0; call < diskCalls; call += step(diskCalls)) {
            put(folder, m_old);
            const FaultyDisk disk = isOnce ? FaultyDisk(folder, FaultyDisk::Once{call}, ENOSPC)
                                           : FaultyDisk(folder, call, ENOSPC);
            const Result<void> result = withinMemory(work);
            if (const QString fault = check(job, result, QStringLiteral("the disk is full"), !isOnce);
                !fault.isEmpty())
                return QStringLiteral("call %1 of %2 to the disk fails%3: ")
                           .arg(call)
                           .arg(diskCalls)
                           .arg(isOnce ? QString() : QStringLiteral(", and all after it")) +
                       fault;
        }
    }
    for (int call = 0; call < allocations; call += step(allocations)) {
        put(folder, m_old);
        const FaultyMemory memory(call, largeFor(job));
        const Result<void> result = withinMemory(work);
        if (const QString fault = check(job, result, QStringLiteral("memory"), false); !fault.isEmpty())
            return QStringLiteral("allocation %1 of %2 fails: ").arg(call).arg(allocations) + fault;
    }
    std::printf("%s: %d calls to the disk and %d large allocations\n", qPrintable(job.name), diskCalls,
                allocations);
    std::fflush(stdout);
    return {};
}

QString FaultTest::run()
{
    for (const Job& job : m_jobs.all()) {
        if (const QString fault = tryJob(job); !fault.isEmpty())
            return job.name + QStringLiteral(": ") + fault;
    }
    std::printf("%d faults\n", m_tries);
    return {};
}

} // namespace

} // namespace espalier::test

int main(int argc, char** argv)
{
    using namespace espalier::test;
    espalier::keepFreedMemory();
    const QGuiApplication application(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption all(QStringLiteral("all"), QStringLiteral("Tries every call."));
    parser.addHelpOption();
    const QCommandLineOption deaths(QStringLiteral("deaths"), QStringLiteral("Kills the process."));
    parser.addOptions({all, deaths});
    parser.process(application);
    QString fault;
    if (parser.isSet(deaths)) {
        // TBB starts no threads, so that a fork is whole, and the calls come in the same order each time.
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        fault = tryDeaths(parser.isSet(all));
    } else {
        fault = FaultTest(parser.isSet(all)).run();
    }
    if (!fault.isEmpty())
        std::printf("FAIL: %s\n", qPrintable(fault));
    return fault.isEmpty() ? 0 : 1;
}
