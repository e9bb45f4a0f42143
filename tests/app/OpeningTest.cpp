// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/Background.h"
#include "commands/DocumentProject.h"
#include "commands/GrowGesture.h"
#include "panels/Notice.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"
#include "views/render/PreparedScene.h"

#include <QCoreApplication>
#include <QLabel>
#include <QPushButton>
#include <QSemaphore>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>

using namespace espalier;

/// A person who opens large projects.
class OpeningTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void largeProject_isShownWithWhatTheWorkerMade();
    void escape_keepsTheOldDocument();
    void cancelButton_keepsTheOldDocument();
    void tipForTheFirstStroke_goes();
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
    backgroundThreads().waitForDone();
    QCoreApplication::processEvents();
}

void OpeningTest::largeProject_isShownWithWhatTheWorkerMade()
{
    const QString file = project(12'000);
    const Result<Project> read = loadProject(file);
    QVERIFY(read);

    // The worker's mesh is moved into the view, which has then nothing to mesh.
    bool isTaken = false;
    const QObject listener;
    FileController& files = m_window->files();
    connect(&files, &FileController::scenePrepared, &listener,
            [&isTaken](const std::shared_ptr<PreparedScene>& scene) {
                isTaken = scene && scene->mesh.vertices().empty();
            });
    QSignalSpy opened(&files, &FileController::opened);
    files.openFile(file);
    QVERIFY(opened.count() == 1 || opened.wait(60'000));
    QVERIFY(isTaken);
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

void OpeningTest::cancelButton_keepsTheOldDocument()
{
    const QString file = project(3'000);
    brush();
    document().undoStack().setClean();
    const test::DocumentState before(document());
    // Reading does not begin before all worker threads are free.
    const auto hindrance = std::make_shared<QSemaphore>();
    QThreadPool& pool = backgroundThreads();
    const int threads = pool.maxThreadCount();
    auto release = qScopeGuard([&] { hindrance->release(threads); });
    for (int i = 0; i < threads; ++i)
        pool.start([hindrance] { hindrance->acquire(); });
    m_window->files().openFile(file);
    QTRY_VERIFY(workspace().notice().isVisible() && notice().contains(QStringLiteral("large")));
    const auto buttons = workspace().notice().findChildren<QPushButton*>();
    const auto cancel = std::ranges::find_if(buttons, &QPushButton::isVisible);
    QVERIFY(cancel != buttons.end());
    QTest::mouseClick(*cancel, Qt::LeftButton);
    release.dismiss();
    hindrance->release(threads);
    settle();
    QVERIFY(workspace().notice().isHidden());
    QCOMPARE(test::differenceFrom(before, document()), QString());
    QVERIFY(m_window->files().file().fileName().isEmpty());
}

void OpeningTest::tipForTheFirstStroke_goes()
{
    const QString file = project(300);
    const auto* const tip = workspace().findChild<QLabel*>(QStringLiteral("tip"));
    QVERIFY(!tip->text().isEmpty());
    QSignalSpy opened(&m_window->files(), &FileController::opened);
    m_window->files().openFile(file);
    QVERIFY(opened.count() == 1 || opened.wait(60'000));
    QCOMPARE(tip->text(), QString());
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
