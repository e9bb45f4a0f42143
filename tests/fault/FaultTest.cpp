// SPDX-License-Identifier: GPL-3.0-or-later
// Lets each call that writes, names or brings a file to the disk fail, and each allocation of more than a
// megabyte, one after another, while a tree is saved, kept in a safety copy and exported. Without options the
// short run that is one of the tests; "fault_test --all" tries every call.
#include "app/files/Outputs.h"
#include "app/files/SafetyCopy.h"
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "commands/HistoryFollower.h"
#include "model/base/Memory.h"
#include "model/base/WithinMemory.h"
#include "model/io/export/ExportFormats.h"
#include "tests/fault/FaultyMemory.h"
#include "tests/support/FaultyDisk.h"

#include <QCommandLineParser>
#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QMap>
#include <QTemporaryDir>

#include <cerrno>
#include <cstdio>
#include <functional>

namespace espalier::test {

namespace {

using Files = QMap<QString, QByteArray>;

Files filesIn(const QString& folder)
{
    Files files;
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden)) {
        QFile bytes(file.filePath());
        files[file.fileName()] = bytes.open(QIODevice::ReadOnly) ? bytes.readAll() : QByteArray("unreadable");
    }
    return files;
}

void put(const QString& folder, const Files& files)
{
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden))
        QFile::remove(file.filePath());
    for (auto file = files.begin(); file != files.end(); ++file) {
        QFile bytes(QDir(folder).filePath(file.key()));
        if (!bytes.open(QIODevice::WriteOnly) || bytes.write(file.value()) != file.value().size())
            qFatal("The test cannot write.");
    }
}

/// One thing that is written, by the code that the program uses.
struct Job {
    QString name;
    std::function<Result<void>(const QString& folder)> work;
    /// Whether the files are those of the document before the job, or after it, and not a mixture.
    std::function<bool(const Files& found, const Files& before, const Files& after)> isWhole;
};

/// Allocations above this size may fail, bytes: a megabyte for the textures of an export; the columns of the
/// small tree are as the larger ones of a large tree.
std::size_t largeFor(const Job& job)
{
    return job.name.startsWith(QLatin1String("export")) ? 1 << 20 : 1 << 15;
}

class FaultTest {
public:
    explicit FaultTest(bool all) : m_triesOfAKind(all ? 1'000'000 : 4)
    {
        m_document.reset(5);
        GrowGesture growing(m_document);
        while (m_document.tree().size() < 9'000 && growing.step()) {
        }
        growing.finish();
        m_before = projectOf(m_document, QStringLiteral("Oak"));
        m_follower.start();
        GrowGesture gesture(m_document);
        for (int i = 0; i < 2; ++i)
            gesture.step();
        gesture.finish();
        m_after = projectOf(m_document, QStringLiteral("Oak"));
        m_bytes = *packProject(m_after);
        const std::optional<HistoryChange> change = m_follower.collect(std::chrono::seconds(10));
        QSet<QString> images;
        m_change = *packChange(*change, images);
    }

    /// Returns what went wrong, or nothing.
    QString run();

private:
    std::vector<Job> jobs();
    QString tryJob(const Job& job);
    /// @p reason: part of the message that is expected.
    /// @p isDead: since a fault, all calls to the disk fail, so that a set of files cannot be put back.
    QString check(const Job& job, const Result<void>& result, const QString& reason, bool isDead);

    const int m_triesOfAKind;
    TreeDocument m_document;
    HistoryFollower m_follower{m_document};
    Project m_before;
    Project m_after;
    QByteArray m_bytes;
    QByteArray m_change;
    QTemporaryDir m_folder;
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
        const bool isKept =
            file.key().startsWith(QLatin1String(".espalier-")) && before.values().contains(file.value());
        if (!isOld && !isNew && !isKept)
            return false;
    }
    return true;
}

bool isOldOrNew(const Files& found, const Files& before, const Files& after)
{
    return found == before || found == after;
}

std::vector<Job> FaultTest::jobs()
{
    std::vector<Job> all;
    all.push_back({QStringLiteral("save"),
                   [this](const QString& folder) {
                       return writeOutput(m_after, folder + QStringLiteral("/oak.espalier"));
                   },
                   isOldOrNew});
    for (const ExportFormat* format : exportFormats()) {
        all.push_back({QStringLiteral("export .") + format->suffix(),
                       [this, format](const QString& folder) {
                           return writeOutput(m_after, folder + QStringLiteral("/oak.") + format->suffix());
                       },
                       isOldOrNew});
    }
    all.push_back({QStringLiteral("begin a safety copy"),
                   [this](const QString& folder) -> Result<void> {
                       const SafetyCopy copy(folder + QStringLiteral("/copy"));
                       if (Result<void> origin = copy.writeOrigin({}); !origin)
                           return origin;
                       const Result<SafetyCopy::Written> written = copy.writeProject(m_after);
                       return written ? Result<void>() : written.error();
                   },
                   [](const Files& found, const Files& before, const Files& after) {
                       const QString project = QStringLiteral("copy.espalier");
                       return found.value(project) == before.value(project) ||
                              found.value(project) == after.value(project);
                   }});
    all.push_back({QStringLiteral("add to a safety copy"),
                   [this](const QString& folder) -> Result<void> {
                       const SafetyCopy copy(folder + QStringLiteral("/copy"));
                       Result<SafetyCopy::Written> written = copy.writeProject(m_before);
                       return written ? copy.addChange(m_change, *written) : written.error();
                   },
                   [this](const Files&, const Files&, const Files&) {
                       const Result<Project> read =
                           SafetyCopy(m_folder.filePath(QStringLiteral("copy"))).read();
                       return read && (read->tree == m_before.tree || read->tree == m_after.tree);
                   }});
    return all;
}

QString FaultTest::check(const Job& job, const Result<void>& result, const QString& reason, bool isDead)
{
    ++m_tries;
    const Files found = filesIn(m_folder.path());
    const bool isWhole = isDead && job.name.startsWith(QLatin1String("export"))
                             ? isEachOldOrNew(found, m_old, m_new)
                             : job.isWhole(found, m_old, m_new);
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
    const Result<QByteArray> bytes = packProject(projectOf(m_document, QStringLiteral("Oak")));
    if (!bytes || *bytes != m_bytes)
        return QStringLiteral("the document has changed");
    return {};
}

QString FaultTest::tryJob(const Job& job)
{
    const QString folder = m_folder.path();
    const auto work = [&] { return job.work(folder); };
    // What stands there before is the same job's result for another tree.
    put(folder, {});
    std::swap(m_before, m_after);
    if (const Result<void> done = work(); !done)
        return done.error().message;
    std::swap(m_before, m_after);
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
    for (const Job& job : jobs()) {
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
    parser.addOption(all);
    parser.process(application);
    FaultTest test(parser.isSet(all));
    const QString fault = test.run();
    if (!fault.isEmpty())
        std::printf("FAIL: %s\n", qPrintable(fault));
    return fault.isEmpty() ? 0 : 1;
}
