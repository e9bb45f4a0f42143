// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/PictureSheet.h"
#include "tests/support/OwnImages.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QPushButton>
#include <QSettings>
#include <QSignalSpy>
#include <QSpinBox>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace espalier;

namespace {

/// Mean difference of the colours, 0...255.
double meanDifference(const QImage& a, const QImage& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor one = a.pixelColor(x, y);
            const QColor other = b.pixelColor(x, y);
            sum += std::abs(one.red() - other.red()) + std::abs(one.green() - other.green()) +
                   std::abs(one.blue() - other.blue());
        }
    }
    return sum / (3.0 * a.width() * a.height());
}

/// The rectangle of pixels that are not transparent.
QRect coveredPart(const QImage& image)
{
    QRect covered;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            if (image.pixelColor(x, y).alpha() > 0)
                covered |= QRect(x, y, 1, 1);
        }
    }
    return covered;
}

} // namespace

/// The user saves pictures of the tree, and copies them.
class PictureTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void copyKey_putsWhatIsShownOnTheClipboard();
    void sheet_asksForSizeViewAndBackground();
    void typedSize_isAnotherSizeOrTheOneOfThatName();
    void sheet_remembersTheLastPicture();
    void savedPicture_isTransparentAndHasItsSize();
    void namedView_doesNotDependOnTheWindow();
    void narrowPicture_showsAllThatTheWindowShows();
    void documentGoesOn_whileThePictureIsDrawn();
    void referencePicture_isNotInIt();
    void fileThatCannotBeWritten_isNamed();

private:
    QString path(const char* name) { return m_folder->filePath(QLatin1String(name)); }
    PictureSheet* openSheet();
    QImage copied();
    QImage savedAs(const PictureSettings& settings);
};

PictureSheet* PictureTest::openSheet()
{
    QTest::keyClick(handle(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
    auto* sheet = m_window->findChild<PictureSheet*>();
    if (!sheet || !QTest::qWaitForWindowActive(sheet))
        qFatal("The sheet does not open.");
    return sheet;
}

QImage PictureTest::copied()
{
    return QGuiApplication::clipboard()->image();
}

QImage PictureTest::savedAs(const PictureSettings& settings)
{
    QSignalSpy finished(&m_window->pictures(), &PictureController::finished);
    m_window->pictures().saveTo(settings, path("oak.png"));
    if (!finished.wait(60'000))
        return {};
    return QImage(path("oak.png"));
}

void PictureTest::copyKey_putsWhatIsShownOnTheClipboard()
{
    makeTree();
    const QImage shown = viewport().grabPicture();
    QSignalSpy finished(&m_window->pictures(), &PictureController::finished);
    QTest::keyClick(handle(), Qt::Key_C, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(finished.wait(60'000));
    QCOMPARE(notice(), QStringLiteral("The picture is on the clipboard."));
    QCOMPARE(copied().size(), shown.size());
    const double difference = meanDifference(copied(), shown);
    QVERIFY2(difference < 3.0, qPrintable(QString::number(difference)));
    // It is no change of the tree.
    QVERIFY(m_window->document().undoStack().isClean() || m_window->document().undoStack().count() == 25);
}

void PictureTest::sheet_asksForSizeViewAndBackground()
{
    makeTree();
    PictureSheet* sheet = openSheet();
    auto* size = sheet->findChild<QComboBox*>(QStringLiteral("pictureSize"));
    auto* view = sheet->findChild<QComboBox*>(QStringLiteral("pictureView"));
    auto* transparent = sheet->findChild<QCheckBox*>(QStringLiteral("pictureTransparent"));
    auto* shadow = sheet->findChild<QCheckBox*>(QStringLiteral("pictureShadow"));
    auto* width = sheet->findChild<QSpinBox*>(QStringLiteral("pictureWidth"));
    QCOMPARE(size->currentIndex(), 0);
    QVERIFY(!shadow->isEnabled());
    size->setFocus();
    for (int i = 0; i < 3; ++i)
        QTest::keyClick(size, Qt::Key_Down);
    QCOMPARE(width->value(), 1080);
    view->setFocus();
    QTest::keyClick(view, Qt::Key_Down);
    QTest::mouseClick(transparent, Qt::LeftButton, {}, QPoint(10, transparent->height() / 2));
    QVERIFY(shadow->isEnabled());
    QTest::mouseClick(shadow, Qt::LeftButton, {}, QPoint(10, shadow->height() / 2));
    QSignalSpy finished(&m_window->pictures(), &PictureController::finished);
    QTest::mouseClick(sheet->findChild<QPushButton*>(QStringLiteral("pictureCopy")), Qt::LeftButton);
    QVERIFY(finished.wait(60'000));
    const QImage picture = copied();
    QCOMPARE(picture.size(), QSize(1080, 1080));
    QCOMPARE(picture.pixelColor(0, 0).alpha(), 0);
    // All of the tree, in the middle.
    const QRect tree = coveredPart(picture);
    QVERIFY(tree.height() > 700 && tree.top() > 0 && tree.bottom() < 1079);
}

void PictureTest::typedSize_isAnotherSizeOrTheOneOfThatName()
{
    PictureSheet sheet({}, {800, 600});
    sheet.show();
    QVERIFY(QTest::qWaitForWindowExposed(&sheet));
    auto* size = sheet.findChild<QComboBox*>(QStringLiteral("pictureSize"));
    const auto type = [&](const char* name, const char* digits) {
        auto* edge = sheet.findChild<QSpinBox*>(QString::fromLatin1(name));
        edge->setFocus();
        edge->selectAll();
        QTest::keyClicks(edge, QString::fromLatin1(digits));
        QTest::keyClick(edge, Qt::Key_Tab);
    };
    QVERIFY(sheet.settings().size.isEmpty());
    type("pictureWidth", "3840");
    QCOMPARE(size->currentIndex(), size->count() - 1);
    QCOMPARE(sheet.settings().size, QSize(3840, 600));
    type("pictureHeight", "2160");
    QCOMPARE(size->currentIndex(), 2);
    type("pictureHeight", "99999");
    QVERIFY(sheet.settings().size.height() <= PictureSettings::kMostEdge);
}

void PictureTest::sheet_remembersTheLastPicture()
{
    const PictureSettings settings{
        .size = {300, 200}, .view = PictureSettings::View::Top, .transparent = true, .shadow = false};
    Settings().setPictureSettings(settings);
    PictureSheet* sheet = openSheet();
    QCOMPARE(sheet->settings(), settings);
    QTest::keyClick(sheet, Qt::Key_Escape);
    QVERIFY(!sheet->isVisible());
    QSettings().setValue(QStringLiteral("picture/size"), QSize(1, 1'000'000));
    QSettings().setValue(QStringLiteral("picture/view"), 77);
    QVERIFY(Settings().pictureSettings().size.isEmpty());
    QCOMPARE(Settings().pictureSettings().view, PictureSettings::View::Shown);
}

void PictureTest::savedPicture_isTransparentAndHasItsSize()
{
    makeTree();
    const QImage picture = savedAs({.size = {320, 400}, .transparent = true, .shadow = false});
    QCOMPARE(notice(), QStringLiteral("Saved oak.png"));
    QCOMPARE(picture.size(), QSize(320, 400));
    QVERIFY(picture.hasAlphaChannel());
    QCOMPARE(picture.pixelColor(2, 2).alpha(), 0);
    QVERIFY(!coveredPart(picture).isEmpty());
    // A plain background is the one of the window.
    const QImage plain = savedAs({.size = {320, 400}});
    QCOMPARE(plain.pixelColor(2, 2), m_window->document().look().backgroundColour);
}

void PictureTest::namedView_doesNotDependOnTheWindow()
{
    makeTree();
    const PictureSettings front{.size = {240, 240}, .view = PictureSettings::View::Front};
    const QImage before = savedAs(front);
    Camera camera = viewport().mainCamera();
    camera.orbit(1.3F, 0.2F);
    viewport().setCamera(camera);
    QCOMPARE(savedAs(front), before);
    const QImage side = savedAs({.size = {240, 240}, .view = PictureSettings::View::Side});
    QVERIFY(meanDifference(side, before) > 1.0);
}

void PictureTest::narrowPicture_showsAllThatTheWindowShows()
{
    makeTree();
    action(ActionId::FrameAll)->trigger();
    QTRY_VERIFY(viewport().mainCamera() == viewport().cameraAtRest());
    const QImage picture = savedAs({.size = {200, 600}, .transparent = true, .shadow = false});
    const QRect tree = coveredPart(picture);
    QVERIFY(tree.left() > 0 && tree.right() < picture.width() - 1);
}

void PictureTest::documentGoesOn_whileThePictureIsDrawn()
{
    makeTree();
    const PictureSettings front{.size = {240, 240}, .view = PictureSettings::View::Front};
    const QImage before = savedAs(front);
    QSignalSpy finished(&m_window->pictures(), &PictureController::finished);
    m_window->pictures().saveTo(front, path("oak.png"));
    while (m_window->document().undoStack().canUndo())
        m_window->document().undo();
    QVERIFY(finished.wait(60'000));
    QCOMPARE(QImage(path("oak.png")), before);
}

void PictureTest::referencePicture_isNotInIt()
{
    const PictureSettings settings{.size = {240, 240}};
    const QImage before = savedAs(settings);
    QImage red(40, 40, QImage::Format_RGB32);
    red.fill(Qt::red);
    m_window->viewSettings().set(
        &SceneLook::tracing,
        {.image = ImageAsset(test::pngOf(red), QStringLiteral("red.png")), .opacity = 1.0});
    QCOMPARE(savedAs(settings), before);
}

void PictureTest::fileThatCannotBeWritten_isNamed()
{
    QSignalSpy finished(&m_window->pictures(), &PictureController::finished);
    m_window->pictures().saveTo({.size = {64, 64}}, path("none/oak.png"));
    QVERIFY(finished.wait(60'000));
    QVERIFY2(notice().startsWith(QStringLiteral("Not saved. ")), qPrintable(notice()));
}

static const test::TestClass<PictureTest> pictureTest;

#include "PictureTest.moc"
