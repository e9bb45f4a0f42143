// SPDX-License-Identifier: GPL-3.0-or-later
// Kills a program that edits, saves and exports, at random moments, and looks at what is left. Each fourth
// time it only asks the program to end (SIGTERM). Without options the short run that is one of the tests;
// "kill_test --kills 300" is the long one.
#include "app/files/SafetyCopy.h"
#include "model/io/project/ProjectFile.h"
#include "tests/kill/DocumentDigest.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QHash>
#include <QProcess>
#include <QRandomGenerator>
#include <QTemporaryDir>
#include <QThread>
#include <QtEndian>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace espalier::test {

namespace {

/// What the program said until it was killed.
struct Story {
    std::vector<QString> digests; ///< By number of the operation; 0: the beginning
    std::vector<qint64> times;    ///< ms, at which the operations were finished
    int safe = 0; ///< The last operation that was in the safety copy, if not all of it was undone
    QHash<QString, std::vector<int>> mayBe; ///< By file: operations whose document it may hold
};

Story readStory(const QByteArray& output)
{
    Story story;
    story.digests.emplace_back();
    story.times.push_back(0);
    for (const QByteArray& line : output.split('\n')) {
        const QList<QByteArray> words = line.split(' ');
        if (words[0] == "begins" && words.size() == 2)
            story.digests[0] = QString::fromLatin1(words[1]);
        // The last line may be cut off.
        if (words[0] == "done" && words.size() == 4 && !words[3].isEmpty()) {
            story.digests.push_back(QString::fromLatin1(words[2]));
            story.times.push_back(words[3].toLongLong());
        } else if (words[0] == "safe" && words.size() == 2)
            story.safe = words[1].toInt();
        else if (words[0] == "clean")
            story.safe = 0;
        else if (words[0] == "saving" && words.size() == 3) {
            story.mayBe[QString::fromUtf8(words[2])].push_back(words[1].toInt());
        } else if (words[0] == "saved" && words.size() == 2) {
            std::vector<int>& all = story.mayBe[QString::fromUtf8(words[1])];
            if (!all.empty())
                all = {all.back()};
        }
    }
    return story;
}

class KillTest {
public:
    explicit KillTest(std::uint64_t seed) : m_random(static_cast<quint32>(seed)) {}

    /// Returns what went wrong, or nothing. @p asks: the program is asked to end, and then must lose nothing.
    QString kill(std::uint64_t seed, bool asks);
    void print() const;

private:
    QString check(const Story& story, const QString& folder, const QString& home);
    /// @p kept becomes the last operation that a saved file has, or the safety copy.
    QString checkSaved(const Story& story, const QString& folder, int& kept);
    QString checkCopy(const Story& story, const QString& home, int& kept);
    /// The last operation after @p kept whose document has that digest, or @p kept.
    static int lastWith(const Story& story, const QString& digest, int kept);
    static QString checkGlb(const QString& fileName);

    QRandomGenerator m_random;
    int m_kills = 0;
    int m_operations = 0;
    int m_savedFiles = 0;
    int m_exports = 0;
    int m_copies = 0;
    qint64 m_killedAt = 0; ///< ms
    bool m_isAsked = false;
    std::vector<qint64> m_lost; ///< By kill, ms: what was done for so long before it was in no file
};

QString KillTest::checkGlb(const QString& fileName)
{
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        return QStringLiteral("an export cannot be read");
    const QByteArray bytes = file.readAll();
    if (!bytes.startsWith("glTF") || bytes.size() < 12 ||
        qFromLittleEndian<quint32>(bytes.constData() + 8) != static_cast<quint32>(bytes.size()))
        return QStringLiteral("an export is not whole");
    return {};
}

int KillTest::lastWith(const Story& story, const QString& digest, int kept)
{
    for (int number = static_cast<int>(story.digests.size()) - 1; number > kept; --number) {
        if (story.digests[static_cast<std::size_t>(number)] == digest)
            return number;
    }
    return kept;
}

QString KillTest::checkSaved(const Story& story, const QString& folder, int& kept)
{
    for (const QFileInfo& file : QDir(folder).entryInfoList(QDir::Files | QDir::Hidden)) {
        if (file.suffix() == QLatin1String("glb")) {
            ++m_exports;
            if (const QString fault = checkGlb(file.filePath()); !fault.isEmpty())
                return fault;
        }
        if (file.suffix() != QLatin1String("espalier"))
            continue;
        ++m_savedFiles;
        const Result<Project> project = loadProject(file.filePath());
        if (!project)
            return QStringLiteral("a saved file is damaged: ") + project.error().message;
        const std::vector<int> mayBe = story.mayBe.value(file.filePath());
        const QString digest = digestOf(*project);
        const bool isKnown = std::ranges::any_of(mayBe, [&](int number) {
            return number == 0 || story.digests[static_cast<std::size_t>(number)] == digest;
        });
        if (!isKnown)
            return QStringLiteral("a saved file is neither the old nor the new one");
        kept = lastWith(story, digest, kept);
    }
    return {};
}

QString KillTest::checkCopy(const Story& story, const QString& home, int& kept)
{
    const QDir place(home + QStringLiteral("/data/Espalier/espalier-victim/autosave"));
    const QStringList files = place.entryList({QStringLiteral("*.espalier")}, QDir::Files);
    const int last = static_cast<int>(story.digests.size()) - 1;
    if (!files.isEmpty()) {
        ++m_copies;
        const Result<Project> project = SafetyCopy::ofProject(place.filePath(files.constFirst())).read();
        if (!project)
            return QStringLiteral("a safety copy is damaged: ") + project.error().message;
        kept = lastWith(story, digestOf(*project), kept);
    } else {
        // All may have been undone: there is nothing to keep of a tree that is as it began.
        kept = lastWith(story, story.digests[0], kept);
    }
    if (!m_isAsked)
        m_lost.push_back(kept == last ? 0 : m_killedAt - story.times[static_cast<std::size_t>(kept) + 1]);
    if (kept < story.safe)
        return QStringLiteral("operation %1 was safe, but only %2 can be brought back")
            .arg(story.safe)
            .arg(kept);
    return {};
}

QString KillTest::kill(std::uint64_t seed, bool asks)
{
    m_isAsked = asks;
    QTemporaryDir home;
    home.setAutoRemove(false);
    const QString folder = home.filePath(QStringLiteral("trees"));
    QDir().mkpath(folder);
    QProcess victim;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert(QStringLiteral("HOME"), home.path());
    environment.insert(QStringLiteral("XDG_DATA_HOME"), home.filePath(QStringLiteral("data")));
    environment.insert(QStringLiteral("XDG_CONFIG_HOME"), home.filePath(QStringLiteral("config")));
    environment.insert(QStringLiteral("QT_QPA_PLATFORM"), QStringLiteral("offscreen"));
    victim.setProcessEnvironment(environment);
    victim.setStandardErrorFile(QProcess::nullDevice());
    victim.start(QCoreApplication::applicationDirPath() + QStringLiteral("/kill_victim"),
                 {folder, QString::number(seed)});
    if (!victim.waitForStarted() || !victim.waitForReadyRead(30'000))
        return QStringLiteral("the program does not start");
    QThread::msleep(100 + m_random.bounded(1500));
    QElapsedTimer now;
    now.start();
    m_killedAt = now.msecsSinceReference();
    if (asks)
        victim.terminate();
    else
        victim.kill();
    if (!victim.waitForFinished())
        return QStringLiteral("the program does not end");
    if ((victim.exitStatus() == QProcess::CrashExit) == asks)
        return asks ? QStringLiteral("the program crashed when it was asked to end")
                    : QStringLiteral("the program ended by itself");
    const QByteArray told = victim.readAllStandardOutput();
    const QString fault = check(readStory(told), folder, home.path());
    if (fault.isEmpty()) {
        home.remove();
        return {};
    }
    QFile log(home.filePath(QStringLiteral("told.txt")));
    log.open(QIODevice::WriteOnly);
    log.write(told);
    return QStringLiteral("%1 (what is left is in %2)").arg(fault, home.path());
}

QString KillTest::check(const Story& story, const QString& folder, const QString& home)
{
    ++m_kills;
    m_operations += static_cast<int>(story.digests.size()) - 1;
    int kept = 0;
    if (const QString fault = checkSaved(story, folder, kept); !fault.isEmpty())
        return fault;
    if (const QString fault = checkCopy(story, home, kept); !fault.isEmpty())
        return fault;
    const bool hasLost = story.digests.back() != story.digests[static_cast<std::size_t>(kept)];
    return m_isAsked && hasLost ? QStringLiteral("the program lost something when it was asked to end")
                                : QString();
}

void KillTest::print() const
{
    std::vector<qint64> lost = m_lost;
    std::ranges::sort(lost);
    const auto share = [&lost](double part) {
        return lost.empty() ? qint64{0}
                            : lost[static_cast<std::size_t>(part * static_cast<double>(lost.size() - 1))];
    };
    std::printf("%d kills after %d operations; %d saved files, %d exports and %d safety copies were whole; "
                "what was finished was in no file for: median %lld ms, 90 %% %lld ms, most %lld ms\n",
                m_kills, m_operations, m_savedFiles, m_exports, m_copies, static_cast<long long>(share(0.5)),
                static_cast<long long>(share(0.9)), static_cast<long long>(share(1.0)));
}

} // namespace

} // namespace espalier::test

int main(int argc, char** argv)
{
    using namespace espalier::test;
    QCoreApplication application(argc, argv);
    QCommandLineParser parser;
    const QCommandLineOption kills(QStringLiteral("kills"), QStringLiteral("How many."),
                                   QStringLiteral("count"), QStringLiteral("8"));
    const QCommandLineOption seed(QStringLiteral("seed"), QStringLiteral("Another seed, other moments."),
                                  QStringLiteral("number"), QStringLiteral("1"));
    parser.addHelpOption();
    const QCommandLineOption from(QStringLiteral("from"), QStringLiteral("Leaves out those before."),
                                  QStringLiteral("number"), QStringLiteral("0"));
    parser.addOptions({kills, seed, from});
    parser.process(application);
    const std::uint64_t first = parser.value(seed).toULongLong();
    KillTest test(first);
    for (int i = parser.value(from).toInt(); i < parser.value(kills).toInt(); ++i) {
        const std::uint64_t number = first * 1'000'000 + static_cast<std::uint64_t>(i);
        if (const QString fault = test.kill(number, i % 4 == 3); !fault.isEmpty()) {
            test.print();
            std::printf("FAIL: kill %d: %s\n", i, qPrintable(fault));
            return 1;
        }
    }
    test.print();
    return 0;
}
