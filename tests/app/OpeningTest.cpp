// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "model/base/Parallel.h"
#include "panels/Notice.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"
#include "views/render/PreparedScene.h"

#include <QtTest>

#include <ctime>

using namespace espalier;

namespace {

/// Processor time of this thread, ms.
double threadTime()
{
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

} // namespace

/// A person who opens large projects.
class OpeningTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void largeProject_isShownWithWhatTheWorkerMade();
    void escape_keepsTheOldDocument();
    void newTree_isNotReplacedByAFileThatWasBeingRead();

private:
    TreeDocument& document() { return m_window->document(); }
    /// A file with a tree of @p internodes.
    QString project(std::uint32_t internodes);
    /// Lets everything end that was begun.
    static void settle();
};

QString OpeningTest::project(std::uint32_t internodes)
{
    TreeDocument large;
    GrowGesture growth(large);
    while (large.index().livingCount() < internodes && growth.step()) {
    }
    growth.finish();
    const QString name = m_folder->filePath(QStringLiteral("large.espalier"));
    const Result<void> written = saveProject(projectOf(large, QStringLiteral("Large")), name);
    return written ? name : QString();
}

void OpeningTest::settle()
{
    QThreadPool::globalInstance()->waitForDone();
    QCoreApplication::processEvents();
}

void OpeningTest::largeProject_isShownWithWhatTheWorkerMade()
{
    const QString file = project(12'000);
    const Result<Project> read = loadProject(file);
    QVERIFY(read);

    const double began = threadTime();
    leavingOneThread([&] {
        const PreparedTree tree = prepared(*read);
        const PreparedScene scene(tree.tree, tree.index, tree.growthModel->space());
    });
    const double making = threadTime() - began;

    double before = 0.0;
    double showing = 0.0;
    FileController& files = m_window->files();
    const QObject listener;
    connect(&files, &FileController::aboutToReplace, &listener, [&] { before = threadTime(); });
    connect(&files, &FileController::opened, &listener, [&] { showing = threadTime() - before; });
    QSignalSpy opened(&files, &FileController::opened);
    files.openFile(file);
    QVERIFY(opened.count() == 1 || opened.wait(60'000));
    qInfo("made in %.1f ms, shown in %.1f ms", making, showing);
    QVERIFY2(showing < 0.5 * making, qPrintable(QStringLiteral("%1 of %2 ms").arg(showing).arg(making)));

    QVERIFY(document().tree() == read->tree);
    QCOMPARE(test::indexFault(document()), QString());
}

void OpeningTest::escape_keepsTheOldDocument()
{
    const QString file = project(12'000);
    brush();
    document().undoStack().setClean();
    const test::DocumentState before(document());
    QSignalSpy opened(&m_window->files(), &FileController::opened);
    m_window->files().openFile(file);
    QTest::keyClick(handle(), Qt::Key_Escape);
    settle();
    QTest::qWait(500); // Progress is not shown later, either.
    QCOMPARE(opened.count(), 0);
    QVERIFY(workspace().notice().isHidden());
    QCOMPARE(test::differenceFrom(before, document()), QString());
    QVERIFY(m_window->files().file().fileName().isEmpty());
    // The next file is opened all the same.
    m_window->files().openFile(file);
    QVERIFY(opened.wait(60'000));
    QVERIFY(document().index().livingCount() >= 12'000);
}

void OpeningTest::newTree_isNotReplacedByAFileThatWasBeingRead()
{
    const QString file = project(3'000);
    QSignalSpy opened(&m_window->files(), &FileController::opened);
    m_window->files().openFile(file);
    action(ActionId::New)->trigger();
    settle();
    QCOMPARE(opened.count(), 0);
    QCOMPARE(document().tree().size(), 1U);
}

static const test::TestClass<OpeningTest> openingTest;

#include "OpeningTest.moc"
