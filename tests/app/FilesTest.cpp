// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"
#include "panels/Notice.h"
#include "panels/RecoverySheet.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCoreApplication>
#include <QDialog>
#include <QDir>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QIODevice>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QMimeData>
#include <QPoint>
#include <QPointF>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QUrl>

using namespace espalier;

/// The user saves, opens and exports, and the program crashes.
class FilesTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void unsavedQuestion_hasKeysAndNoStockIcons();
    void brushUndoRedoSaveReopen_givesTheSameDocument();
    void brokenFile_isRefusedInOneSentenceAndTheTreeStays();
    void brokenFile_leavesGrowthRunning();
    void closingInMidGrowth_asksAndKeepsWhatHasGrown();
    void unsavedChanges_areAskedAbout();
    void recipe_isPlayedAndHandedOver();
    void recipe_tellsAtTheEndWhatItDidNotFind();
    void droppedFile_isOpened();
    void recentFiles_listWhatWasSaved();
    void crash_losesNothingThatWasFinished();
    void export_writesTheFileInTheBackground();
    void secondExport_followsTheFirst();
    void cancelledExport_leavesNothing();
    void saveAsRecipe_writesWhatWasDone();
    void saveAsRecipe_saysWhatIsNotKnownOfAnOldTree();
};

void FilesTest::unsavedQuestion_hasKeysAndNoStockIcons()
{
    makeTree();
    QStringList texts;
    bool hasIcon = false;
    QTimer::singleShot(200, this, [&] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return;
        for (const QAbstractButton* button : box->buttons()) {
            texts << button->text();
            hasIcon |= !button->icon().isNull();
        }
        QTest::keyClick(box, Qt::Key_C, Qt::AltModifier);
    });
    action(ActionId::New)->trigger();
    texts.sort();
    QCOMPARE(texts,
             QStringList({QStringLiteral("&Cancel"), QStringLiteral("&Discard"), QStringLiteral("&Save")}));
    QVERIFY(!hasIcon);
    QVERIFY(m_window->document().index().livingCount() > 1);
}

void FilesTest::brushUndoRedoSaveReopen_givesTheSameDocument()
{
    brush();
    brush(0.8F, 1.5F, 0.5F);
    TreeDocument& document = m_window->document();
    QCOMPARE(document.undoStack().count(), 2);
    const Tree grown = document.tree();

    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(document.index().livingCount(), 1U);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTest::keyClick(handle(), Qt::Key_Y, Qt::ControlModifier);
    QTRY_COMPARE(document.undoStack().index(), 2);
    QVERIFY(document.tree() == grown);

    const QString name = m_folder->filePath(QStringLiteral("brushed.espalier"));
    save(name);
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(m_window->windowTitle(), QStringLiteral("brushed.espalier[*] – Espalier"));
    const std::size_t history = document.journal().size();

    action(ActionId::New)->trigger();
    QCOMPARE(document.index().livingCount(), 1U);
    m_window->files().openFile(name);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree() == grown, 30'000);
    QCOMPARE(document.journal().size(), history);
    QVERIFY(!m_window->isWindowModified());

    // Its steps are there again.
    const auto* steps = workspace().findChild<QAbstractItemView*>(QStringLiteral("history"));
    QCOMPARE(steps->model()->rowCount(), 3);
    for (int row = 1; row < 3; ++row)
        QVERIFY(steps->model()->index(row, 0).data().toString().startsWith(QStringLiteral("Brush Stroke")));
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(document.undoStack().index(), 1);
    QVERIFY(m_window->isWindowModified());
    QTest::keyClick(handle(), Qt::Key_Y, Qt::ControlModifier);
    QTRY_VERIFY(!m_window->isWindowModified());
    QVERIFY(document.tree() == grown);
}

void FilesTest::brokenFile_isRefusedInOneSentenceAndTheTreeStays()
{
    brush();
    const QString good = m_folder->filePath(QStringLiteral("good.espalier"));
    save(good);
    const Tree before = m_window->document().tree();

    const QString bad = m_folder->filePath(QStringLiteral("bad.espalier"));
    QFile file(good);
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QByteArray whole = file.readAll();
    QFile half(bad);
    QVERIFY(half.open(QIODevice::WriteOnly));
    half.write(whole.left(whole.size() / 2));
    half.close();

    m_window->files().openFile(bad);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().notice().isWarning(), 30'000);
    QVERIFY(m_window->workspace().notice().isVisible());
    QVERIFY2(notice().contains(QStringLiteral("bad.espalier")), qPrintable(notice()));
    QVERIFY(m_window->document().tree() == before);
    QCOMPARE(m_window->files().file().fileName(), good);

    m_window->files().openFile(m_folder->filePath(QStringLiteral("none.json")));
    QTRY_VERIFY2(notice().contains(QStringLiteral("none.json")), qPrintable(notice()));
    QVERIFY(m_window->document().tree() == before);
}

void FilesTest::brokenFile_leavesGrowthRunning()
{
    QFile file(m_folder->filePath(QStringLiteral("bad.espalier")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write("PK no tree");
    file.close();
    GrowRunner& growth = m_window->growRunner();
    growth.begin();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree().step() >= 2, 30'000);
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(file.fileName())});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &drop);
    QTRY_VERIFY2_WITH_TIMEOUT(notice().contains(QStringLiteral("bad.espalier")), qPrintable(notice()),
                              30'000);
    QVERIFY(growth.isRunning());
    const Step step = m_window->document().tree().step();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree().step() > step, 30'000);
    growth.cancel();
}

void FilesTest::closingInMidGrowth_asksAndKeepsWhatHasGrown()
{
    const QString name = m_folder->filePath(QStringLiteral("growing.espalier"));
    save(name);
    QVERIFY(!m_window->isWindowModified());
    GrowRunner& growth = m_window->growRunner();
    growth.begin();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree().step() >= 2, 30'000);

    answer(QMessageBox::Cancel);
    QVERIFY(!m_window->close());
    QVERIFY(growth.isRunning());
    const Step step = m_window->document().tree().step();
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree().step() > step, 30'000);

    // Replacing the tree asks about unsaved changes too.
    answer(QMessageBox::Cancel);
    m_window->files().openFile(name);
    QTRY_VERIFY_WITH_TIMEOUT(!QApplication::activeModalWidget(), 30'000);
    QTest::qWait(300);
    QVERIFY(growth.isRunning());

    answer(QMessageBox::Save);
    QVERIFY(m_window->close());
    QVERIFY(!growth.isRunning());
    const Result<Project> kept = loadProject(name);
    QVERIFY(kept);
    QVERIFY(kept->tree.step() > step);
    QVERIFY(kept->tree == m_window->document().tree());
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
}

void FilesTest::unsavedChanges_areAskedAbout()
{
    brush();
    const std::uint32_t grown = m_window->document().index().livingCount();
    answer(QMessageBox::Cancel);
    action(ActionId::New)->trigger();
    QCOMPARE(m_window->document().index().livingCount(), grown);

    answer(QMessageBox::Cancel);
    QVERIFY(!m_window->close());

    const QString name = m_folder->filePath(QStringLiteral("kept.espalier"));
    save(name);
    brush(1.0F, 1.8F);
    answer(QMessageBox::Save);
    action(ActionId::New)->trigger();
    QCOMPARE(m_window->document().index().livingCount(), 1U);
    const Result<Project> kept = loadProject(name);
    QVERIFY(kept);
    QVERIFY(TreeIndex(kept->tree).livingCount() > grown);
    QVERIFY(!kept->thumbnail.isNull());

    brush();
    answer(QMessageBox::Discard);
    action(ActionId::New)->trigger();
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

void FilesTest::recipe_isPlayedAndHandedOver()
{
    QFile file(m_folder->filePath(QStringLiteral("small.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"espalier-recipe": 1, "name": "Small", "seed": 5,
                   "operations": [{"op": "grow", "steps": 4}, {"op": "grow", "steps": 2}]})");
    file.close();
    m_window->files().openFile(file.fileName());
    QTRY_COMPARE_WITH_TIMEOUT(m_window->document().tree().step(), Step{6}, 30'000);
    QTRY_VERIFY(!m_window->recipeRunner().isRunning());
    QCOMPARE(m_window->document().tree().seed(), std::uint64_t{5});
    QCOMPARE(m_window->document().undoStack().count(), 2);
    QVERIFY(!m_window->isWindowModified());
    brush(0.2F, 1.2F, 0.3F);
    QCOMPARE(m_window->document().undoStack().count(), 3);
    QVERIFY(m_window->isWindowModified());
}

void FilesTest::recipe_tellsAtTheEndWhatItDidNotFind()
{
    QFile file(m_folder->filePath(QStringLiteral("futile.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"espalier-recipe": 1, "operations": [{"op": "prune", "internodes": [712]},
                   {"op": "grow", "steps": 4}, {"op": "regrow"}]})");
    file.close();
    m_window->files().openFile(file.fileName());
    QTRY_VERIFY(notice().contains(QStringLiteral("(2 of 3 operations)")));
    QVERIFY(!m_window->recipeRunner().isRunning());
    QVERIFY2(notice().contains(QStringLiteral("(2 of 3 operations)")) &&
                 notice().contains(QStringLiteral("operations[0]: prune: there is no internode 712")) &&
                 notice().contains(QStringLiteral("operations[2]: regrow: ")),
             qPrintable(notice()));
}

void FilesTest::droppedFile_isOpened()
{
    brush();
    const QString name = m_folder->filePath(QStringLiteral("dropped.espalier"));
    save(name);
    const Tree tree = m_window->document().tree();
    action(ActionId::New)->trigger();

    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(name)});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(m_window.get(), &drop);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree() == tree, 30'000);

    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/tmp/picture.txt"))});
    QDragEnterEvent other(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    other.ignore();
    QCoreApplication::sendEvent(m_window.get(), &other);
    QVERIFY(!other.isAccepted());
}

void FilesTest::recentFiles_listWhatWasSaved()
{
    for (const char* name : {"a.espalier", "b.espalier", "a.espalier"})
        save(m_folder->filePath(QString::fromLatin1(name)));
    QMenu menu;
    m_window->files().fillRecentFiles(menu);
    QCOMPARE(menu.actions().value(0)->text(), QStringLiteral("a.espalier"));
    QCOMPARE(menu.actions().value(1)->text(), QStringLiteral("b.espalier"));
    QVERIFY(menu.actions().value(2)->isSeparator());
}

void FilesTest::crash_losesNothingThatWasFinished()
{
    Autosave& autosave = m_window->files().autosave();
    QSignalSpy written(&autosave, &Autosave::written);
    brush();
    QVERIFY(written.count() > 0 || written.wait(30000));
    QVERIFY(Autosave::leftovers().empty());
    const Tree grown = m_window->document().tree();

    // After a crash the files are there, but no program holds their lock.
    const QDir place(Autosave::folder());
    const QStringList projects = place.entryList({QStringLiteral("*.espalier")}, QDir::Files);
    QCOMPARE(projects.size(), 1);
    const QString base = place.filePath(projects.constFirst().chopped(9));
    const QString crashed = place.filePath(QStringLiteral("crashed"));
    for (const char* suffix : {".espalier", ".changes", ".origin"})
        QVERIFY(QFile::copy(base + QLatin1String(suffix), crashed + QLatin1String(suffix)));
    m_window->document().undoStack().setClean();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QCOMPARE(Autosave::leftovers().size(), std::size_t{1});

    m_window->files().offerRecovery(Recovery::Occasion::Start);
    const auto sheet = [this] { return m_window->findChild<RecoverySheet*>(); };
    QTRY_VERIFY_WITH_TIMEOUT(sheet() && sheet()->isVisible(), 30'000);
    QTest::keyClick(sheet(), Qt::Key_Return);
    QTRY_VERIFY_WITH_TIMEOUT(m_window->document().tree() == grown, 30'000);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(Autosave::leftovers().empty());
    save(m_folder->filePath(QStringLiteral("rescued.espalier")));
    QTRY_VERIFY(place.entryList({QStringLiteral("*.espalier")}, QDir::Files).isEmpty());
}

void FilesTest::export_writesTheFileInTheBackground()
{
    brush();
    const QString name = m_folder->filePath(QStringLiteral("tree.glb"));
    m_window->files().exportTo(name);
    QVERIFY(m_window->workspace().notice().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(notice().startsWith(QStringLiteral("Wrote")), 30000);
    QVERIFY(QFileInfo(name).size() > 1000);

    m_window->files().exportTo(m_folder->filePath(QStringLiteral("no/such/folder/tree.csv")));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().notice().isWarning(), 10000);
    QVERIFY2(notice().contains(QStringLiteral("tree.csv")), qPrintable(notice()));
}

void FilesTest::secondExport_followsTheFirst()
{
    GrowGesture growth(m_window->document());
    for (int i = 0; i < 12; ++i)
        growth.step();
    growth.finish();
    const QString first = m_folder->filePath(QStringLiteral("first.fbx"));
    const QString second = m_folder->filePath(QStringLiteral("second.obj"));
    m_window->files().exportTo(first);
    m_window->files().exportTo(second);
    m_window->files().exportTo(m_folder->filePath(QStringLiteral("no/such/folder/tree.csv")));
    QCOMPARE(notice(), QStringLiteral("Writing first.fbx, then second.obj"));
    QTRY_VERIFY_WITH_TIMEOUT(m_window->workspace().notice().isWarning(), 30'000);
    QVERIFY2(notice().contains(QStringLiteral("Wrote first.fbx, second.obj")), qPrintable(notice()));
    QVERIFY2(notice().contains(QStringLiteral("tree.csv")), qPrintable(notice()));
    QVERIFY(QFileInfo(first).size() > 1000 && QFileInfo(second).size() > 1000);
}

void FilesTest::cancelledExport_leavesNothing()
{
    GrowGesture growth(m_window->document());
    for (int i = 0; i < 15; ++i)
        growth.step();
    growth.finish();
    const QString name = m_folder->filePath(QStringLiteral("tree.glb"));
    m_window->files().exportTo(name);
    QPushButton* cancel = nullptr;
    for (auto* button : m_window->workspace().notice().findChildren<QPushButton*>()) {
        if (button->isVisible())
            cancel = button;
    }
    QVERIFY(cancel);
    QTest::mouseClick(cancel, Qt::LeftButton);
    QTRY_VERIFY_WITH_TIMEOUT(notice().contains(QStringLiteral("was not written")), 30000);
    QVERIFY(!QFileInfo::exists(name));
}

void FilesTest::saveAsRecipe_writesWhatWasDone()
{
    brush();
    brush(0.8F, 1.5F, 0.5F);
    TreeDocument& document = m_window->document();
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().index(), 1, 30'000);
    action(ActionId::GrowStep)->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().index(), 2, 30'000);
    const Tree grown = document.tree();

    const QString name = m_folder->filePath(QStringLiteral("mine.json"));
    QTimer::singleShot(0, this, [&] {
        auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
        QVERIFY(dialog);
        dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(name);
        static_cast<QDialog*>(dialog)->accept(); // protected in QFileDialog
    });
    action(ActionId::SaveRecipe)->trigger();
    QTRY_COMPARE_WITH_TIMEOUT(notice(), QStringLiteral("Saved mine.json"), 30'000);
    QVERIFY(m_window->isWindowModified()); // a recipe is no project

    const Result<Recipe> recipe = readRecipe(name);
    QVERIFY2(recipe, recipe ? "" : qPrintable(recipe.error().message));
    QCOMPARE(recipe->operations.size(), std::size_t{2});
    answer(QMessageBox::Discard);
    m_window->files().openFile(name);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree() == grown, 30'000);
    QTRY_VERIFY(!m_window->recipeRunner().isRunning());
}

void FilesTest::saveAsRecipe_saysWhatIsNotKnownOfAnOldTree()
{
    const QDir old(QStringLiteral(SOURCE_DIR "/tests/model/io/version1"));
    const QStringList projects = old.entryList({QStringLiteral("*.espalier")});
    QVERIFY(!projects.isEmpty());
    m_window->files().openFile(old.filePath(projects.constFirst()));
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->document().journal().empty(), 30'000);
    const QString name = m_folder->filePath(QStringLiteral("old.json"));
    m_window->files().saveRecipeTo(name);
    QTRY_VERIFY2_WITH_TIMEOUT(notice().contains(QStringLiteral("did not record how")), qPrintable(notice()),
                              30'000);
    QVERIFY(m_window->workspace().notice().isWarning());
    QVERIFY(!QFileInfo::exists(name));
}

static const test::TestClass<FilesTest> filesTest;

#include "FilesTest.moc"
