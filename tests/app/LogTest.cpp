// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/Log.h"

#include "tests/support/TestClasses.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace espalier;

/// The program's log, and what it says of a crash.
class LogTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void lines_areWrittenWithTheTime();
    void fullLog_isRotated();
    void crash_isWrittenDown();

private:
    QByteArray bytes() const
    {
        QFile file(Log::fileName());
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    std::unique_ptr<QTemporaryDir> m_state;
};

void LogTest::init()
{
    m_state = std::make_unique<QTemporaryDir>();
    qputenv("XDG_STATE_HOME", m_state->path().toLocal8Bit());
    Log::open();
}

void LogTest::cleanup()
{
    Log::close();
    qunsetenv("XDG_STATE_HOME");
}

void LogTest::lines_areWrittenWithTheTime()
{
    QCOMPARE(Log::folder(), m_state->filePath(QStringLiteral("espalier")));
    Log::note(QStringLiteral("one\ntwo"));
    QTest::ignoreMessage(QtWarningMsg, "a warning of Qt");
    qWarning("a warning of Qt");
    const QList<QByteArray> lines = bytes().split('\n');
    QCOMPARE(lines.size(), 3);
    QVERIFY(lines[1].endsWith(" Qt: a warning of Qt"));
    QVERIFY(lines[0].endsWith(" one two"));
    QVERIFY(QDateTime::fromString(QString::fromLatin1(lines[0].first(23)), Qt::ISODateWithMs).isValid());
    QVERIFY(Log::tail(1000).contains(QStringLiteral("one two")));
}

void LogTest::fullLog_isRotated()
{
    const QString line(1500, QLatin1Char('x'));
    for (int i = 0; i < 3'500; ++i)
        Log::note(QStringLiteral("%1 ").arg(i) + line);
    const QStringList files = QDir(Log::folder()).entryList(QDir::Files);
    QCOMPARE(files, (QStringList{QStringLiteral("espalier.1.log"), QStringLiteral("espalier.2.log"),
                                 QStringLiteral("espalier.log")}));
    for (const QString& name : files)
        QVERIFY(QFileInfo(QDir(Log::folder()).filePath(name)).size() < (1 << 20) + 4'000);
    QVERIFY(Log::tail(20'000).contains(QStringLiteral(" 3499 x")));
    QVERIFY(Log::tail(20'000).size() <= 20'000);
}

void LogTest::crash_isWrittenDown()
{
    const pid_t child = ::fork();
    if (child == 0) {
        Log::catchCrashes(QStringLiteral("All is in the copy."));
        ::close(STDERR_FILENO);
        ::raise(SIGSEGV);
        ::_exit(0);
    }
    int status = 0;
    QCOMPARE(::waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status));
    QCOMPARE(WTERMSIG(status), SIGSEGV);
    QVERIFY2(bytes().contains("because of a fault: signal 11\n"), bytes().constData());
    QVERIFY(bytes().contains("window_tests"));
}

static const test::TestClass<LogTest> logTest;

#include "LogTest.moc"
