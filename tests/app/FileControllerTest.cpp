// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/Background.h"
#include "tests/support/FaultyDisk.h"
#include "tests/support/FilesFixture.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

#include <cerrno>

using namespace espalier;

/// Opening and saving beside other programs, on bad disks, and while growth is under way.
class FileControllerTest : public test::FilesFixture {
    Q_OBJECT

private Q_SLOTS:
    void fullDisk_isNamedAndTheDocumentKeepsItsFile();
    void failedSaving_leavesTheTreeModifiedAndItsSafetyCopy();
    void windowClosedWhileSaving_stillWritesTheFile();
    void secondWindowsSave_asksBeforeItReplacesTheFirst();
    void overwriting_isDoneWhenThePersonWantsIt();
    void leavingWithAChangedFile_asksAndStaysIfCancelled();
    void fileChangedElsewhere_isNoticedOnce();
    void fileTouchedElsewhere_isNoChange();
    void fileRemovedElsewhere_leavesTheTreeUnsaved();
    void fileRemovedElsewhere_isSavedAnewWithoutAQuestion();
    void brokenFile_leavesWorkAloneAndAsksNothing_data();
    void brokenFile_leavesWorkAloneAndAsksNothing();
    void openingDuringWork_asksAndStayingChangesNothing();
    void savingWorkBeforeOpening_finishesIt();
    void fileOpenedLast_isTheOneShown();
    void fullDisk_leavesTheSettings();
    void undoneBackToClean_leavesNoSafetyCopy();
    void savingThatFailsAfterUndo_makesASafetyCopyAnew();

private:
    /// Two windows show the same file, and the first one has saved it since.
    void disagree(test::FilesWindow& first, test::FilesWindow& second);
};

void FileControllerTest::fullDisk_isNamedAndTheDocumentKeepsItsFile()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    window.grow();
    QSignalSpy failed(&window.files->file(), &DocumentFile::saveFailed);
    window.files->file().save(QStringLiteral("/dev/full"), {});
    QVERIFY(failed.wait(30'000));
    QCOMPARE(window.said(), QStringLiteral("Not saved. full: the disk is full"));
    QVERIFY(window.notice.isWarning());
    QVERIFY(window.files->file().isModified());
    QCOMPARE(window.files->file().fileName(), path("oak.espalier"));
    QCOMPARE(window.files->file().displayName(), QStringLiteral("oak.espalier"));
}

void FileControllerTest::failedSaving_leavesTheTreeModifiedAndItsSafetyCopy()
{
    test::FilesWindow window;
    QSignalSpy written(&window.files->autosave(), &Autosave::written);
    window.grow();
    QVERIFY(written.wait(30'000));
    QCOMPARE(copies().size(), 1);
    QSignalSpy failed(&window.files->file(), &DocumentFile::saveFailed);
    window.files->file().save(path("none/oak.espalier"), {});
    QVERIFY(failed.wait(30'000));
    QVERIFY(window.files->file().isModified());
    QVERIFY(window.files->file().fileName().isEmpty());
    QCOMPARE(copies().size(), 1);
}

void FileControllerTest::windowClosedWhileSaving_stillWritesTheFile()
{
    const QString name = path("kept.espalier");
    {
        test::FilesWindow window;
        window.grow(6);
        // This remembers the name until the file is written.
        window.files->keepIn(name);
        QVERIFY(window.files->file().isSaving());
    }
    QVERIFY(loadProject(name));
    QVERIFY(copies().isEmpty());
}

void FileControllerTest::disagree(test::FilesWindow& first, test::FilesWindow& second)
{
    first.grow();
    save(first, path("oak.espalier"));
    open(second, path("oak.espalier"));
    first.grow(1);
    save(first, path("oak.espalier"));
    second.grow(2);
}

void FileControllerTest::secondWindowsSave_asksBeforeItReplacesTheFirst()
{
    test::FilesWindow first;
    test::FilesWindow second;
    disagree(first, second);
    const QByteArray firstBytes = bytesOf(path("oak.espalier"));
    QSignalSpy refused(&second.files->file(), &DocumentFile::saveRefused);
    answer(QMessageBox::Cancel);
    second.files->save();
    QVERIFY(refused.wait(30'000));
    QTRY_COMPARE(questions(), 1);
    QCOMPARE(bytesOf(path("oak.espalier")), firstBytes);
    QVERIFY(second.files->file().isModified());
    QCOMPARE(second.files->file().fileName(), path("oak.espalier"));

    // The first window saves without a question.
    first.grow(1);
    save(first, path("oak.espalier"));
    QCOMPARE(questions(), 1);
}

void FileControllerTest::overwriting_isDoneWhenThePersonWantsIt()
{
    test::FilesWindow first;
    test::FilesWindow second;
    disagree(first, second);
    QSignalSpy saved(&second.files->file(), &DocumentFile::saved);
    answer(QStringLiteral("overwrite"));
    second.files->save();
    QVERIFY(saved.wait(30'000));
    QVERIFY(!second.files->file().isModified());
    const Result<Project> project = loadProject(path("oak.espalier"));
    QVERIFY(project);
    QVERIFY(project->tree == second.document.tree());

    second.grow(1);
    save(second, path("oak.espalier"));
    QCOMPARE(questions(), 1);
}

void FileControllerTest::leavingWithAChangedFile_asksAndStaysIfCancelled()
{
    test::FilesWindow first;
    test::FilesWindow second;
    disagree(first, second);
    const QByteArray firstBytes = bytesOf(path("oak.espalier"));
    answer(QMessageBox::Save);
    QTimer::singleShot(300, this, [this] { answer(QMessageBox::Cancel); });
    QVERIFY(!second.files->mayLeave());
    QCOMPARE(questions(), 2);
    QCOMPARE(bytesOf(path("oak.espalier")), firstBytes);
}

void FileControllerTest::fileChangedElsewhere_isNoticedOnce()
{
    test::FilesWindow first;
    test::FilesWindow second;
    disagree(first, second);
    QSignalSpy changed(&second.files->file(), &DocumentFile::changedOnDisk);
    second.files->lookAtDisk();
    QVERIFY(changed.wait(30'000));
    QVERIFY2(second.said().startsWith(QStringLiteral("oak.espalier was changed by another")),
             qPrintable(second.said()));
    second.files->lookAtDisk();
    QVERIFY(!changed.wait(500));
    QCOMPARE(changed.count(), 1);

    // The window that wrote the file knows its content.
    QSignalSpy own(&first.files->file(), &DocumentFile::changedOnDisk);
    first.files->lookAtDisk();
    QVERIFY(!own.wait(500));

    answer(QMessageBox::Discard);
    QSignalSpy opened(second.files.get(), &FileController::opened);
    second.press(QStringLiteral("Open Again"));
    QVERIFY(opened.wait(30'000));
    QVERIFY(second.document.tree() == first.document.tree());
}

void FileControllerTest::fileTouchedElsewhere_isNoChange()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    QFile file(path("oak.espalier"));
    QVERIFY(file.open(QIODevice::ReadWrite));
    QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFileDevice::FileModificationTime));
    file.close();
    QSignalSpy changed(&window.files->file(), &DocumentFile::changedOnDisk);
    window.files->lookAtDisk();
    QVERIFY(!changed.wait(500));
    window.grow(1);
    save(window, path("oak.espalier"));
    QCOMPARE(questions(), 0);
}

void FileControllerTest::fileRemovedElsewhere_leavesTheTreeUnsaved()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    QVERIFY(QFile::remove(path("oak.espalier")));
    QSignalSpy removed(&window.files->file(), &DocumentFile::removedFromDisk);
    window.files->lookAtDisk();
    QVERIFY(removed.wait(30'000));
    QVERIFY(window.files->file().isModified());
    QVERIFY2(window.said().contains(QStringLiteral("oak.espalier")), qPrintable(window.said()));
}

void FileControllerTest::fileRemovedElsewhere_isSavedAnewWithoutAQuestion()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    QVERIFY(QFile::remove(path("oak.espalier")));
    window.grow(1);
    save(window, path("oak.espalier"));
    QVERIFY(loadProject(path("oak.espalier")));
    QCOMPARE(questions(), 0);
}

void FileControllerTest::brokenFile_leavesWorkAloneAndAsksNothing_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("project") << QStringLiteral("broken.espalier");
    QTest::newRow("recipe") << QStringLiteral("broken.json");
    QTest::newRow("missing project") << QStringLiteral("none.espalier");
    QTest::newRow("missing recipe") << QStringLiteral("none.json");
}

void FileControllerTest::brokenFile_leavesWorkAloneAndAsksNothing()
{
    QFETCH(QString, name);
    test::FilesWindow window;
    bool isFinished = false;
    window.files->setWorkInHand(
        {.isUnderWay = [] { return true; }, .finish = [&isFinished] { isFinished = true; }});
    window.grow();
    for (const char* broken : {"broken.espalier", "broken.json"})
        put(path(broken), "this is no tree");
    const Tree before = window.document.tree();
    QSignalSpy replaced(window.files.get(), &FileController::aboutToReplace);
    window.files->openFile(m_folder->filePath(name));
    QTRY_VERIFY_WITH_TIMEOUT(window.notice.isWarning(), 30'000);
    QVERIFY2(window.said().startsWith(name), qPrintable(window.said()));
    QCOMPARE(replaced.count(), 0);
    QCOMPARE(questions(), 0);
    QVERIFY(!isFinished);
    QVERIFY(window.document.tree() == before);
}

void FileControllerTest::openingDuringWork_asksAndStayingChangesNothing()
{
    test::FilesWindow window;
    bool isFinished = false;
    window.grow();
    save(window, path("oak.espalier"));
    save(window, path("clean.espalier"));
    window.files->setWorkInHand(
        {.isUnderWay = [] { return true; }, .finish = [&isFinished] { isFinished = true; }});
    QSignalSpy replaced(window.files.get(), &FileController::aboutToReplace);
    answer(QMessageBox::Cancel);
    window.files->openFile(path("oak.espalier"));
    QTRY_COMPARE_WITH_TIMEOUT(questions(), 1, 30'000);
    QTest::qWait(50);
    QCOMPARE(replaced.count(), 0);
    QVERIFY(!isFinished);
    QCOMPARE(window.files->file().fileName(), path("clean.espalier"));

    answer(QMessageBox::Discard);
    open(window, path("oak.espalier"));
    QCOMPARE(replaced.count(), 1);
    QVERIFY(!isFinished);
}

void FileControllerTest::savingWorkBeforeOpening_finishesIt()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    save(window, path("grown.espalier"));
    bool isUnderWay = true;
    window.files->setWorkInHand({.isUnderWay = [&isUnderWay] { return isUnderWay; },
                                 .finish =
                                     [&] {
                                         isUnderWay = false;
                                         window.grow(2);
                                     }});
    const Step before = window.document.tree().step();
    answer(QMessageBox::Save);
    open(window, path("oak.espalier"));
    const Result<Project> grown = loadProject(path("grown.espalier"));
    QVERIFY(grown);
    QCOMPARE(grown->tree.step(), before + 2);
}

void FileControllerTest::fileOpenedLast_isTheOneShown()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("a.espalier"));
    window.grow(1);
    save(window, path("b.espalier"));
    QSignalSpy opened(window.files.get(), &FileController::opened);
    window.files->openFile(path("b.espalier"));
    window.files->openFile(path("a.espalier"));
    QVERIFY(opened.wait(30'000));
    QVERIFY(!opened.wait(300));
    QCOMPARE(window.files->file().fileName(), path("a.espalier"));
}

void FileControllerTest::fullDisk_leavesTheSettings()
{
    const QString fileName = QSettings().fileName();
    Settings settings;
    settings.setExportSuffix(QStringLiteral("obj"));
    const QByteArray before = bytesOf(fileName);
    QVERIFY(before.contains("obj"));
    {
        const test::FaultyDisk disk(QFileInfo(fileName).path(), 0, ENOSPC);
        settings.setExportSuffix(QStringLiteral("fbx"));
        settings.addRecentFile(QStringLiteral("/tmp"));
        settings.clearRecentFiles();
        settings.setPreferences({});
        settings.setViewValues({});
    }
    QCOMPARE(bytesOf(fileName), before);
    settings.setExportSuffix(QStringLiteral("csv"));
    QCOMPARE(Settings().exportSuffix(), QStringLiteral("csv"));
}

void FileControllerTest::undoneBackToClean_leavesNoSafetyCopy()
{
    test::FilesWindow window;
    QSignalSpy written(&window.files->autosave(), &Autosave::written);
    window.grow();
    QVERIFY(written.wait(30'000));
    QCOMPARE(copies().size(), 1);
    window.document.undoStack().undo();
    QVERIFY(copies().isEmpty());

    window.document.undoStack().redo();
    QVERIFY(written.wait(30'000));
    QCOMPARE(copies().size(), 1);

    // Undo while a copy is being written.
    window.grow();
    QTest::qWait(1000);
    window.document.undoStack().undo();
    window.document.undoStack().undo();
    backgroundThreads().waitForDone();
    QTest::qWait(50);
    QVERIFY(copies().isEmpty());
}

void FileControllerTest::savingThatFailsAfterUndo_makesASafetyCopyAnew()
{
    test::FilesWindow window;
    window.grow();
    save(window, path("oak.espalier"));
    QVERIFY(copies().isEmpty());
    // No file holds the tree from now on.
    QSignalSpy failed(&window.files->file(), &DocumentFile::saveFailed);
    window.files->file().save(path("none/oak.espalier"), {});
    QVERIFY(failed.wait(30'000));
    QTRY_COMPARE_WITH_TIMEOUT(copies().size(), 1, 30'000);
}

static const test::TestClass<FileControllerTest> fileControllerTest;

#include "FileControllerTest.moc"
