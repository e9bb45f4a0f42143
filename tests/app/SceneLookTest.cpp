// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/BackgroundPanel.h"
#include "panels/Notice.h"
#include "panels/ViewRow.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCheckBox>
#include <QFile>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// The user sets the background, the ground, the light and the reference picture of a tree. They belong to
/// the document.
class SceneLookTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void sun_comesBackWithItsTree();
    void lookThatHasChanged_isAskedAbout();
    void picture_travelsInTheFile();
    void pictureOfAnyFormat_isTaken();
    void pictureForAnotherTree_isDropped();
    void useForNewTrees_keepsTheLookButNotThePicture();
    void pinnedSun_staysWhereItWasSaved();
    void oldFile_hasTheLookOfNewTrees();

private:
    SceneLook look() { return m_window->document().look(); }
    SceneLook shown() { return m_window->viewSettings().values(); }
    bool isModified() { return m_window->files().file().isModified(); }
    QString path(const char* name) { return m_folder->filePath(QLatin1String(name)); }
    void dragSun(const QPoint& by);
    void open(const QString& fileName);
    void take(const QString& fileName);
    void pressNew();
};

void SceneLookTest::dragSun(const QPoint& by)
{
    QTRY_VERIFY(viewport().isAtRest());
    const QPoint sun = viewport().mapTo(m_window.get(), viewport().sunPlace().toPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, sun);
    QTest::mouseMove(handle(), sun + by / 2);
    QTest::mouseMove(handle(), sun + by);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, sun + by);
    QCoreApplication::processEvents();
}

void SceneLookTest::open(const QString& fileName)
{
    QSignalSpy opened(&m_window->files(), &FileController::opened);
    m_window->files().openFile(fileName);
    QVERIFY(opened.wait(30'000));
}

void SceneLookTest::take(const QString& fileName)
{
    QSignalSpy taken(&m_window->scene(), &SceneController::pictureTaken);
    m_window->scene().takePicture(fileName);
    QVERIFY(taken.wait(30'000));
}

void SceneLookTest::pressNew()
{
    QTest::keyClick(handle(), Qt::Key_N, Qt::ControlModifier);
    QCOMPARE(m_window->document().undoStack().count(), 0);
}

void SceneLookTest::sun_comesBackWithItsTree()
{
    const SceneLook before = look();
    dragSun({-120, 60});
    const SceneLook dragged = look();
    QVERIFY(dragged.sunAzimuth != before.sunAzimuth);
    QVERIFY(isModified() && m_window->isWindowModified());
    // It is no step of the tree.
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(look() == dragged);
    save(path("oak.espalier"));
    QVERIFY(!isModified() && !m_window->isWindowModified());

    pressNew();
    QVERIFY(look() == before);
    QVERIFY(shown() == before);
    open(path("oak.espalier"));
    QVERIFY(look() == dragged);
    QVERIFY(shown() == dragged);
    QVERIFY(!isModified());
}

void SceneLookTest::lookThatHasChanged_isAskedAbout()
{
    const SceneLook before = look();
    dragSun({-80, 40});
    const SceneLook dragged = look();
    QVERIFY2(dragged != before, "the sun was not dragged");
    answer(QMessageBox::Cancel);
    QTest::keyClick(handle(), Qt::Key_N, Qt::ControlModifier);
    QVERIFY(look() == dragged);
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    answer(QMessageBox::Discard);
    QTest::keyClick(handle(), Qt::Key_N, Qt::ControlModifier);
    QVERIFY(look() != dragged);
}

void SceneLookTest::picture_travelsInTheFile()
{
    const QByteArray bytes = test::pngOf(test::drawnLeaf(Qt::white));
    QFile file(path("sketch.png"));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(bytes);
    file.close();
    take(file.fileName());
    QVERIFY(isModified());
    save(path("oak.espalier"));
    QVERIFY(file.remove());

    pressNew();
    QVERIFY(look().tracing.image.isNull());
    QVERIFY(shown().tracing.image.isNull());
    open(path("oak.espalier"));
    QCOMPARE(look().tracing.image.file(), bytes);
    QCOMPARE(shown().tracing.image.name(), QStringLiteral("sketch.png"));
    QVERIFY(!isModified());
}

void SceneLookTest::pictureOfAnyFormat_isTaken()
{
    QImage large(2 * ImageAsset::kLargestEdge, 40, QImage::Format_RGB32);
    large.fill(Qt::darkGreen);
    QVERIFY(large.save(path("scan.bmp")));
    take(path("scan.bmp"));
    const QImage pixels = look().tracing.image.pixels();
    QCOMPARE(pixels.size(), QSize(ImageAsset::kLargestEdge, 20));
    QVERIFY(std::abs(pixels.pixelColor(9, 9).green() - QColor(Qt::darkGreen).green()) < 3);

    QFile text(path("text.png"));
    QVERIFY(text.open(QIODevice::WriteOnly));
    text.write("no picture");
    text.close();
    take(path("text.png"));
    QCOMPARE(notice(), QStringLiteral("text.png: it is not a picture that can be read"));
    QCOMPARE(look().tracing.image.name(), QStringLiteral("scan.bmp"));
}

void SceneLookTest::pictureForAnotherTree_isDropped()
{
    QVERIFY(test::drawnLeaf(Qt::white).save(path("sketch.png")));
    QSignalSpy taken(&m_window->scene(), &SceneController::pictureTaken);
    m_window->scene().takePicture(path("sketch.png"));
    pressNew();
    QTRY_COMPARE_WITH_TIMEOUT(taken.count(), 1, 30'000);
    QVERIFY(look().tracing.image.isNull());
    QVERIFY(!isModified());
}

void SceneLookTest::useForNewTrees_keepsTheLookButNotThePicture()
{
    action(ActionId::Background)->trigger();
    BackgroundPanel& panel = workspace().background();
    auto* use = panel.findChild<QPushButton*>(QStringLiteral("lookForNewTrees"));
    QVERIFY(use->isVisible() && !use->isEnabled());
    QTest::mouseClick(panel.row("view.gridShown")->findChild<QCheckBox*>(), Qt::LeftButton);
    QVERIFY(test::drawnLeaf(Qt::white).save(path("sketch.png")));
    take(path("sketch.png"));
    QVERIFY(use->isEnabled());
    QTest::mouseClick(use, Qt::LeftButton);
    QVERIFY(!use->isEnabled());
    QCOMPARE(notice(), QStringLiteral("New trees will have this background, ground and light."));
    answer(QMessageBox::Discard);
    QTest::keyClick(handle(), Qt::Key_N, Qt::ControlModifier);
    QVERIFY(look().gridShown && look().tracing.image.isNull());
    QVERIFY(!isModified());
    // The next start of the program, too.
    QVERIFY(Settings().lookOfNewTrees().gridShown);
}

void SceneLookTest::pinnedSun_staysWhereItWasSaved()
{
    Camera camera = viewport().mainCamera();
    camera.orbit(0.7F, 0.0F);
    viewport().setCamera(camera);
    action(ActionId::Background)->trigger();
    QTest::mouseClick(workspace().background().row("view.sunPinned")->findChild<QCheckBox*>(),
                      Qt::LeftButton);
    const SceneLook pinned = look();
    QVERIFY(pinned.sunPinned);
    save(path("oak.espalier"));
    pressNew();
    QVERIFY(!look().sunPinned);
    open(path("oak.espalier"));
    QVERIFY(look() == pinned);
    QVERIFY(!isModified());
}

void SceneLookTest::oldFile_hasTheLookOfNewTrees()
{
    Project old;
    QVERIFY(saveProject(old, path("old.espalier")));
    dragSun({-120, 60});
    save(path("oak.espalier"));
    open(path("old.espalier"));
    QVERIFY(look() == m_window->files().file().lookOfNewTrees());
    QVERIFY(!isModified());
}

static const test::TestClass<SceneLookTest> sceneLookTest;

#include "SceneLookTest.moc"
