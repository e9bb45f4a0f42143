// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fault/Deaths.h"

#include "tests/fault/Jobs.h"
#include "tests/support/FaultyDisk.h"

#include <QDir>
#include <QFile>
#include <QRandomGenerator>

#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <functional>

namespace espalier::test {

namespace {

using Moment = FaultyDisk::Moment;

/// Where a process dies.
struct Point {
    int call;
    Moment moment;
};

QString textOf(Moment moment)
{
    switch (moment) {
    case Moment::Before:
        return QStringLiteral("before");
    case Moment::HalfWay:
        return QStringLiteral("half-way through");
    case Moment::After:
        break;
    }
    return QStringLiteral("after");
}

/// Threads of a process do not live on in its fork, and what they hold is held there for ever.
bool hasOtherThreads()
{
    return QDir(QStringLiteral("/proc/self/task")).entryList(QDir::Dirs | QDir::NoDotAndDotDot).size() != 1;
}

/// All calls, or the first and the last one of each kind.
std::vector<Point> pointsIn(const QByteArray& trace, bool all)
{
    std::vector<Point> points;
    for (int call = 0; call < trace.size(); ++call) {
        const char kind = trace[call];
        const bool isFirst = trace.indexOf(kind) == call;
        const bool isLast = trace.lastIndexOf(kind) == call;
        if (!all && !isFirst && !isLast)
            continue;
        points.push_back({call, Moment::Before});
        if (kind == 'w')
            points.push_back({call, Moment::HalfWay});
        if (all || isLast)
            points.push_back({call, Moment::After});
    }
    return points;
}

/// Some work in a fork of this process. The work may start threads, of Qt for example, which this process may
/// not.
class Fork {
public:
    /// Waits until the fork has ended. @p work: returns what the fork has to say.
    explicit Fork(const std::function<QByteArray()>& work)
    {
        std::array<int, 2> pipe{};
        std::fflush(stdout);
        if (hasOtherThreads() || ::pipe(pipe.data()) != 0)
            qFatal("This process cannot fork.");
        const pid_t child = ::fork();
        if (child < 0)
            qFatal("This process cannot fork.");
        if (child == 0) {
            // Each fork would choose the same names for its temporary files as the next one.
            QRandomGenerator::global()->discard(static_cast<unsigned long long>(::getpid()) * 1'000);
            const QByteArray said = work();
            const bool isSaid =
                ::write(pipe[1], said.constData(), static_cast<std::size_t>(said.size())) == said.size();
            ::_exit(isSaid ? 0 : 1);
        }
        ::close(pipe[1]);
        QFile answer;
        if (answer.open(pipe[0], QIODevice::ReadOnly, QFileDevice::AutoCloseHandle))
            m_said = answer.readAll();
        while (::waitpid(child, &m_status, 0) < 0 && errno == EINTR) {
        }
    }

    bool isKilled() const { return WIFSIGNALED(m_status) && WTERMSIG(m_status) == SIGKILL; }
    bool isDone() const { return WIFEXITED(m_status) && WEXITSTATUS(m_status) == 0; }
    const QByteArray& said() const { return m_said; }

private:
    QByteArray m_said;
    int m_status = 0;
};

/// Does some work in a fork. Returns the message of an error.
QString resultInFork(const std::function<Result<void>()>& work)
{
    const Fork fork([&work] {
        const Result<void> result = work();
        return result ? QByteArray() : result.error().message.toUtf8();
    });
    return fork.isDone() ? QString::fromUtf8(fork.said())
                         : QStringLiteral("a fork of this process ended early");
}

class DeathTest {
public:
    DeathTest(Jobs& jobs, const Job& job) : m_jobs(jobs), m_job(job) {}

    QString run(bool all);
    int deaths() const { return m_deaths; }

private:
    /// Does the job in a process that dies there. Returns what went wrong.
    QString die(Point point) const;
    QString check(Point point, bool all);
    /// What is wrong with the files of a set.
    QString checkSet(const Files& found, int renames);
    QString checkSecondRun() const;

    Jobs& m_jobs;
    const Job& m_job;
    QByteArray m_trace;
    Files m_old;
    Files m_new;
    int m_deaths = 0;
    int m_mixtures = 0;
    int m_leftovers = 0;
};

QString DeathTest::die(Point point) const
{
    const Fork fork([&] {
        const FaultyDisk disk(m_jobs.folder(), FaultyDisk::Death{point.call, point.moment});
        static_cast<void>(m_job.work(m_jobs.folder()));
        return QByteArray();
    });
    return fork.isKilled() ? QString() : QStringLiteral("the process does not come to this call");
}

QString DeathTest::checkSet(const Files& found, int renames)
{
    bool hasOld = false;
    bool hasNew = false;
    for (auto file = m_new.begin(); file != m_new.end(); ++file) {
        const QByteArray old = m_old.value(file.key());
        if (old == file.value())
            continue;
        hasNew = hasNew || found.value(file.key()) == file.value();
        hasOld = hasOld || found.value(file.key()) == old;
    }
    if (hasNew && renames == 0)
        return QStringLiteral("a file is new before the first rename");
    if (hasOld && renames == m_trace.count('r'))
        return QStringLiteral("a file is old after the last rename");
    m_mixtures += hasOld && hasNew ? 1 : 0;
    return {};
}

QString DeathTest::checkSecondRun() const
{
    const QString problem = resultInFork([this] { return m_job.work(m_jobs.folder()); });
    if (!problem.isEmpty())
        return QStringLiteral("the second run fails: ") + problem;
    Files found = filesIn(m_jobs.folder());
    found.removeIf([](Files::iterator file) { return isTemporary(file.key()); });
    if (found != m_new)
        return QStringLiteral("the second run leaves other files: ") + found.keys().join(QLatin1Char(' '));
    return {};
}

QString DeathTest::check(Point point, bool all)
{
    Files found = filesIn(m_jobs.folder());
    if (found.removeIf([](Files::iterator file) { return isTemporary(file.key()); }) > 0)
        ++m_leftovers;
    for (auto file = found.begin(); file != found.end(); ++file) {
        const bool isOld = m_old.contains(file.key()) && m_old[file.key()] == file.value();
        const bool isNew = m_new.contains(file.key()) && m_new[file.key()] == file.value();
        if (!isOld && !isNew && file.key() != m_job.grows)
            return QStringLiteral("%1 is neither the old nor the new file").arg(file.key());
    }
    for (const QString& name : m_old.keys()) {
        if (m_new.contains(name) && name != m_job.grows && !found.contains(name))
            return QStringLiteral("%1 is gone").arg(name);
    }
    if (!m_job.isExport()) {
        if (!m_job.isWhole(found, m_old, m_new))
            return QStringLiteral("the files hold neither the document before nor the one after");
    } else {
        const int done = point.call + (point.moment == Moment::Before ? 0 : 1);
        if (const QString fault = checkSet(found, static_cast<int>(m_trace.first(done).count('r')));
            !fault.isEmpty())
            return fault;
    }
    // What is left after one kind of call: enough for the short run.
    return all || point.moment == Moment::After ? checkSecondRun() : QString();
}

QString DeathTest::run(bool all)
{
    if (const QString problem = resultInFork([this] { return m_jobs.prepare(m_job); }); !problem.isEmpty())
        return problem;
    m_old = filesIn(m_jobs.folder());
    const Fork traced([this] {
        const FaultyDisk disk(m_jobs.folder(), FaultyDisk::Death{FaultyDisk::kNever, Moment::Before});
        return m_job.work(m_jobs.folder()) ? disk.trace() : QByteArray();
    });
    m_trace = traced.said();
    if (m_trace.isEmpty())
        return QStringLiteral("it fails without a fault");
    m_new = filesIn(m_jobs.folder());
    for (const Point point : pointsIn(m_trace, all)) {
        put(m_jobs.folder(), m_old);
        QString fault = die(point);
        if (fault.isEmpty())
            fault = check(point, all);
        if (!fault.isEmpty()) {
            return QStringLiteral("killed %1 call %2 of %3 (%4): ")
                       .arg(textOf(point.moment))
                       .arg(point.call)
                       .arg(m_trace.size())
                       .arg(QLatin1Char(m_trace[point.call])) +
                   fault;
        }
        ++m_deaths;
    }
    std::printf(
        "%s: %lld calls (%s), killed %d times, %d times between the renames of a set, %d times with a "
        "temporary file left\n",
        qPrintable(m_job.name), static_cast<long long>(m_trace.size()), m_trace.constData(), m_deaths,
        m_mixtures, m_leftovers);
    return {};
}

} // namespace

QString tryDeaths(bool all)
{
    // Small, since everything is written many times.
    constexpr std::size_t kInternodes = 300;
    constexpr int kTextureSize = 64;
    Jobs jobs(kInternodes, kTextureSize);
    int deaths = 0;
    for (const Job& job : jobs.all()) {
        DeathTest test(jobs, job);
        if (const QString fault = test.run(all); !fault.isEmpty())
            return job.name + QStringLiteral(": ") + fault;
        deaths += test.deaths();
    }
    std::printf("%d deaths\n", deaths);
    return {};
}

} // namespace espalier::test
