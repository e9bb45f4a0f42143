// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"

#include "commands/GrowGesture.h"
#include "panels/BackgroundPanel.h"
#include "panels/Bar.h"
#include "panels/GrowPopOut.h"
#include "panels/Notice.h"
#include "panels/RadiusSlider.h"
#include "panels/Theme.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/Diagram.h"
#include "panels/architecture/DiagramHandle.h"
#include "tests/support/OwnImages.h"
#include "views/Viewport.h"
#include "views/render/GlResources.h"

#include <QtTest>
#include <QtWidgets>

using namespace espalier;

/// A person at the real window: events enter where the system's do.
class MainWindowTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void init();
    void cleanup();
    void cleanupTestCase() { m_window.reset(); }

    void mouse_brushesATreeAsOneUndoStep();
    void finger_brushesATree();
    void pen_brushesByItsPressure();
    void escape_takesTheStrokeBack();
    void undoDuringAStroke_isIgnored();
    void brushUndoRedoSaveReopen_givesTheSameDocument();
    void brokenFile_isRefusedInOneSentenceAndTheTreeStays();
    void unsavedChanges_areAskedAbout();
    void holdingGrow_isOneUndoStep();
    void growTool_growsWhileTheHandHolds();
    void manySteps_areStoppedByEscape();
    void strokeDuringGrowth_endsIt();
    void bendAndWidth_areAtHand();
    void timeSlider_ungrowsAndGrowsOn();
    void play_showsTheHistoryAgain();
    void history_goesWhereItIsClicked();
    void keys_changeTheBrushAndWhatIsShown();
    void mouse_drawsALassoThatTheTreeFills();
    void finger_drawsALasso();
    void pen_drawsALasso();
    void escapeDuringLassoGrowth_takesAllBack();
    void pressDuringLassoGrowth_keepsWhatGrew();
    void lassoTooSmall_isSaidInOneSentence();
    void lassoPopOut_regrowsRemovesAndHides();
    void tab_hidesEverythingButTheTree();
    void sheets_opensOneAtATime();
    void f6_leadsTheKeysToThePanelsAndBack();
    void architecture_isDraggedOverTheLiveTree();
    void recipe_isPlayedAndHandedOver();
    void droppedFile_isOpened();
    void droppedImage_becomesLeafOrBark();
    void imageThatIsNone_isRefusedInOneSentence();
    void recentFiles_listWhatWasSaved();
    void crash_losesNothingThatWasFinished();
    void export_writesTheFileInTheBackground();
    void cancelledExport_leavesNothing();
    void window_looksLikeThis();

private:
    Viewport& viewport() { return m_window->workspace().viewport(); }
    QWindow* handle() { return m_window->windowHandle(); }
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    /// A point of the window, given in metres above the tree's base and to the right of it.
    QPoint at(float right, float up);
    /// An upright stroke with the mouse.
    void brush(float fromUp = 0.0F, float toUp = 1.6F, float right = 0.0F);
    /// Takes the lasso, on a tree of few internodes.
    void takeLasso();
    /// Points of a circle in the window, 0.9 m wide, above the seedling, closed.
    std::vector<QPoint> lassoPlaces();
    /// Draws the circle with the mouse; the button is up again.
    void drawLasso();
    QString notice() { return m_window->workspace().notice().text(); }
    /// Presses a button of the next message box.
    void answer(QMessageBox::StandardButton button);
    void save(const QString& fileName);

    std::unique_ptr<MainWindow> m_window;
    std::unique_ptr<QTemporaryDir> m_folder;
    QPointingDevice* m_screen = QTest::createTouchDevice();
};

void MainWindowTest::initTestCase()
{
    theme::apply(*qApp);
}

void MainWindowTest::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    QSettings().clear();
    QSettings().setValue(QStringLiteral("files/autosaveInterval"), 1);
    // A window takes its time to come up where the processor draws it, so that the tests share one.
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(960, 640);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewSettings().setValues({.shadowsShown = false});
    action(ActionId::Brush)->trigger();
    viewport().setFocus();
}

void MainWindowTest::cleanup()
{
    // Nobody is there to answer a question.
    m_window->document().undoStack().setClean();
    m_window->workspace().notice().finish();
    action(ActionId::New)->trigger();
}

QPoint MainWindowTest::at(float right, float up)
{
    const Camera& camera = viewport().camera();
    const auto point = camera.project(right * camera.right() + up * Vec3::UnitY());
    return viewport().mapTo(m_window.get(), point.value_or(QPointF()).toPoint());
}

void MainWindowTest::brush(float fromUp, float toUp, float right)
{
    constexpr int kMoves = 25;
    const QPoint from = at(right, fromUp);
    const QPoint to = at(right, toUp);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= kMoves; ++i) {
        QTest::mouseMove(handle(), from + (to - from) * i / kMoves);
        QTest::qWait(20);
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, to);
    QCoreApplication::processEvents();
}

void MainWindowTest::answer(QMessageBox::StandardButton button)
{
    QTimer::singleShot(100, this, [this, button] {
        auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
        if (!box)
            return answer(button);
        box->button(button)->click();
    });
}

void MainWindowTest::save(const QString& fileName)
{
    DocumentFile& file = m_window->files().file();
    QSignalSpy saved(&file, &DocumentFile::saved);
    file.save(fileName, {});
    QVERIFY(saved.wait());
}

void MainWindowTest::mouse_brushesATreeAsOneUndoStep()
{
    QVERIFY(!action(ActionId::Undo)->isEnabled());
    brush();
    const TreeDocument& document = m_window->document();
    QVERIFY(document.index().livingCount() > 30);
    QCOMPARE(document.undoStack().count(), 1);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(m_window->windowTitle().contains(QStringLiteral("[*] – Espalier")));
    QVERIFY(!viewport().isGestureActive());

    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(document.index().livingCount(), 1U);
    QVERIFY(!m_window->isWindowModified());
}

void MainWindowTest::finger_brushesATree()
{
    const QPoint from = at(0.0F, 0.0F);
    const QPoint to = at(0.0F, 1.6F);
    QTest::touchEvent(handle(), m_screen).press(1, from, handle());
    for (int i = 1; i <= 25; ++i) {
        QTest::touchEvent(handle(), m_screen).move(1, from + (to - from) * i / 25, handle());
        QTest::qWait(20);
    }
    QVERIFY(viewport().isGestureActive());
    QTest::touchEvent(handle(), m_screen).release(1, to, handle());
    QTRY_COMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(m_window->document().index().livingCount() > 30);
}

void MainWindowTest::pen_brushesByItsPressure()
{
    const auto penStroke = [this](double pressure) {
        static const QPointingDevice pen(QStringLiteral("pen"), 7, QInputDevice::DeviceType::Stylus,
                                         QPointingDevice::PointerType::Pen,
                                         QInputDevice::Capability::Pressure, 1, 2);
        const QPoint from = at(0.0F, 0.0F);
        const QPoint to = at(0.0F, 1.6F);
        for (int i = 0; i <= 26; ++i) {
            const auto type = i == 0    ? QEvent::TabletPress
                              : i == 26 ? QEvent::TabletRelease
                                        : QEvent::TabletMove;
            const QPointF place =
                viewport().mapFrom(m_window.get(), from + (to - from) * std::min(i, 25) / 25);
            QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place), i == 26 ? 0.0 : pressure,
                               0.0F, 0.0F, 0.0F, 0.0, 0.0F, {}, Qt::LeftButton,
                               i == 26 ? Qt::NoButton : Qt::LeftButton);
            QCoreApplication::sendEvent(&viewport(), &event);
            QTest::qWait(20);
        }
        QCoreApplication::processEvents();
        const TreeDocument& document = m_window->document();
        const std::uint32_t grown = document.index().livingCount();
        Box3 bounds;
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                bounds.extend(document.index().nodePosition(id));
        }
        m_window->document().undoStack().undo();
        return std::pair(grown, bounds.sizes().x());
    };
    const auto [many, wide] = penStroke(1.0);
    const auto [few, narrow] = penStroke(0.25);
    QVERIFY(many > 30);
    QVERIFY(few > 3);
    QVERIFY2(narrow < 0.8F * wide, qPrintable(QStringLiteral("%1 m, %2 m").arg(narrow).arg(wide)));
}

void MainWindowTest::escape_takesTheStrokeBack()
{
    const QPoint from = at(0.0F, 0.0F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) {
        QTest::mouseMove(handle(), from - QPoint(0, 6 * i));
        QTest::qWait(20);
    }
    QVERIFY(m_window->document().index().livingCount() > 10);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_COMPARE(m_window->document().index().livingCount(), 1U);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QVERIFY(!m_window->isWindowModified());
}

void MainWindowTest::undoDuringAStroke_isIgnored()
{
    brush();
    const std::uint32_t before = m_window->document().index().livingCount();
    const QPoint from = at(0.3F, 1.0F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    QTest::qWait(150);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTest::qWait(50);
    QVERIFY(m_window->document().index().livingCount() >= before);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
    QCoreApplication::processEvents();
    while (m_window->document().undoStack().canUndo())
        m_window->document().undoStack().undo();
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

void MainWindowTest::brushUndoRedoSaveReopen_givesTheSameDocument()
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
    QVERIFY(document.tree() == grown);
    QCOMPARE(document.journal().size(), history);
    QVERIFY(!m_window->isWindowModified());
}

void MainWindowTest::brokenFile_isRefusedInOneSentenceAndTheTreeStays()
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
    QVERIFY(m_window->workspace().notice().isVisible());
    QVERIFY(m_window->workspace().notice().isWarning());
    QVERIFY2(notice().contains(QStringLiteral("bad.espalier")), qPrintable(notice()));
    QVERIFY(m_window->document().tree() == before);
    QCOMPARE(m_window->files().file().fileName(), good);

    m_window->files().openFile(m_folder->filePath(QStringLiteral("none.json")));
    QVERIFY2(notice().contains(QStringLiteral("none.json")), qPrintable(notice()));
    QVERIFY(m_window->document().tree() == before);
}

void MainWindowTest::unsavedChanges_areAskedAbout()
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

void MainWindowTest::holdingGrow_isOneUndoStep()
{
    QTest::keyClick(handle(), Qt::Key_G, Qt::ShiftModifier);
    auto* button = m_window->workspace().growPopOut().findChild<QPushButton*>(QStringLiteral("holdToGrow"));
    QTRY_VERIFY(button->isVisible());
    const QPoint place = button->mapTo(m_window.get(), button->rect().center());
    QTest::mousePress(handle(), Qt::LeftButton, {}, place);
    QTRY_VERIFY(m_window->document().tree().step() >= 4);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, place);
    QCoreApplication::processEvents();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().undoStack().count(), 1);
    const Step grown = m_window->document().tree().step();
    QTest::qWait(200);
    QCOMPARE(m_window->document().tree().step(), grown);

    QTest::keyClick(handle(), Qt::Key_G);
    QTRY_COMPARE(m_window->document().undoStack().count(), 2);
    QCOMPARE(m_window->document().tree().step(), grown + 1);
}

void MainWindowTest::growTool_growsWhileTheHandHolds()
{
    action(ActionId::Grow)->trigger();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QTRY_VERIFY(m_window->document().tree().step() >= 3);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QCoreApplication::processEvents();
    QCOMPARE(m_window->document().undoStack().count(), 1);

    QTest::mousePress(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QTest::qWait(200);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.0F, 1.0F));
    QCoreApplication::processEvents();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void MainWindowTest::manySteps_areStoppedByEscape()
{
    m_window->growRunner().run(1000);
    QTRY_VERIFY(m_window->document().tree().step() >= 3);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{0});

    m_window->growRunner().run(3);
    QTRY_VERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{3});
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void MainWindowTest::bendAndWidth_areAtHand()
{
    brush();
    const TreeDocument& document = m_window->document();
    const Tree grown = document.tree();
    InternodeId top = 0;
    for (InternodeId id = 1; id < grown.size(); ++id) {
        if (grown.isAlive(id) &&
            document.index().nodePosition(id).y() > document.index().nodePosition(top).y())
            top = id;
    }
    const auto seen = [&](InternodeId id) {
        return viewport().mapTo(m_window.get(),
                                viewport().camera().project(document.index().nodePosition(id))->toPoint());
    };
    QTest::keyClick(m_window.get(), Qt::Key_B, Qt::ShiftModifier);
    QVERIFY(action(ActionId::Bend)->isChecked());
    auto* stretching = m_window->findChild<QSlider*>(QStringLiteral("stretchingWeight"));
    QVERIFY(stretching && stretching->isVisible());
    stretching->setValue(stretching->maximum());
    QCOMPARE(m_window->viewSettings().values().stretchingWeight, kMostBendWeight);

    // A pin, which Escape takes away before anything else.
    const InternodeId low = document.index().mainChild(0);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, seen(low));
    action(ActionId::Architecture)->trigger();
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QVERIFY(action(ActionId::Architecture)->isChecked());
    QTest::keyClick(m_window.get(), Qt::Key_Escape);
    QVERIFY(!action(ActionId::Architecture)->isChecked());

    const QPoint from = seen(top);
    std::vector<Vec3> before;
    for (InternodeId id = 0; id < grown.size(); ++id)
        before.push_back(document.index().nodePosition(id));
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 10; ++i) {
        QTest::mouseMove(handle(), from + QPoint(8, 3) * i);
        QTest::qWait(16);
    }
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(80, 30));
    // The branch under the pointer: that of the topmost node, or one in front of it.
    float moved = 0.0F;
    for (InternodeId id = 0; id < grown.size(); ++id)
        moved = std::max(moved, (document.index().nodePosition(id) - before[id]).norm());
    QVERIFY2(moved > 0.3F, qPrintable(QStringLiteral("%1, %2").arg(moved).arg(top)));
    QCOMPARE(document.undoStack().count(), 2);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.tree() == grown);

    QTest::keyClick(m_window.get(), Qt::Key_W);
    QVERIFY(action(ActionId::Width)->isChecked());
    QVERIFY(!stretching->isVisible());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, seen(low));
    QCOMPARE(document.tree().widthConstraints().size(), 1U);
    QTest::keyClick(handle(), Qt::Key_Delete);
    QVERIFY(document.tree().widthConstraints().empty());
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(document.tree().widthConstraints().size(), 1U);
    QTest::keyClick(m_window.get(), Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(document.tree() == grown);
}

void MainWindowTest::strokeDuringGrowth_endsIt()
{
    TreeDocument& document = m_window->document();
    m_window->growRunner().run(1000);
    QTRY_VERIFY(document.journal().size() > 2);
    brush();
    QVERIFY(!m_window->growRunner().isRunning());
    QCOMPARE(document.undoStack().count(), 2);
    const Tree whole = document.tree();
    document.undoStack().undo();
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), 1U);
    document.undoStack().redo();
    document.undoStack().redo();
    QVERIFY(document.tree() == whole);
}

void MainWindowTest::timeSlider_ungrowsAndGrowsOn()
{
    brush();
    TreeDocument& document = m_window->document();
    const std::uint32_t grown = document.index().livingCount();
    const auto end = static_cast<int>(document.journal().size());
    action(ActionId::Grow)->trigger();
    auto* slider = m_window->findChild<QSlider*>(QStringLiteral("time"));
    QVERIFY(slider->isVisible());
    QCOMPARE(slider->value(), end);
    const auto place = [&](int value) {
        const double share = static_cast<double>(value) / slider->maximum();
        return QPoint(static_cast<int>(8 + share * (slider->width() - 16)), slider->height() / 2);
    };
    QTest::mousePress(slider, Qt::LeftButton, {}, place(end));
    for (int value = end; value >= end / 2; --value)
        QTest::mouseMove(slider, place(value));
    QVERIFY(document.index().livingCount() < grown);
    QVERIFY(!document.future().empty());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, place(end / 2));
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), grown);
    QCOMPARE(slider->value(), end);
    // Beyond the present it grows.
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_Right);
    QVERIFY(document.index().livingCount() > grown);
    QCOMPARE(static_cast<int>(document.journal().size()), end + 1);
    document.undoStack().undo();
    QCOMPARE(document.index().livingCount(), grown);
}

void MainWindowTest::play_showsTheHistoryAgain()
{
    brush();
    TreeDocument& document = m_window->document();
    const Tree grown = document.tree();
    const int commands = document.undoStack().count();
    action(ActionId::Grow)->trigger();
    auto* play = m_window->findChild<QPushButton*>(QStringLiteral("playTime"));
    QTest::mouseClick(play, Qt::LeftButton);
    QVERIFY(play->isChecked());
    QVERIFY(document.index().livingCount() < 10);
    QTRY_VERIFY_WITH_TIMEOUT(!play->isChecked(), 20000);
    QVERIFY(document.tree() == grown);
    QCOMPARE(document.undoStack().count(), commands);
}

void MainWindowTest::history_goesWhereItIsClicked()
{
    brush();
    brush(1.0F, 1.4F, 0.4F);
    TreeDocument& document = m_window->document();
    QCOMPARE(document.undoStack().count(), 2);
    action(ActionId::History)->trigger();
    auto* list = m_window->findChild<QUndoView*>(QStringLiteral("history"));
    QVERIFY(list->isVisible());
    const auto click = [&](int row) {
        const QRect place = list->visualRect(list->model()->index(row, 0));
        QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, place.center());
    };
    click(0);
    QCOMPARE(document.index().livingCount(), 1U);
    click(2);
    QCOMPARE(document.undoStack().index(), 2);
    QVERIFY(document.index().livingCount() > 1);
    action(ActionId::History)->trigger();
    QVERIFY(!list->isVisible());
}

void MainWindowTest::keys_changeTheBrushAndWhatIsShown()
{
    const ViewSettings& settings = m_window->viewSettings();
    QTest::keyClick(handle(), Qt::Key_BracketLeft);
    QTRY_VERIFY(settings.values().brushRadius < 0.5);
    QTest::keyClick(handle(), Qt::Key_BracketRight);
    QTest::keyClick(handle(), Qt::Key_BracketRight);
    QTRY_VERIFY(settings.values().brushRadius > 0.5);
    auto* slider = m_window->findChild<RadiusSlider*>();
    QCOMPARE(slider->radius(), settings.values().brushRadius);

    const bool markers = settings.values().markersShown;
    QTest::keyClick(handle(), Qt::Key_M);
    QTRY_COMPARE(settings.values().markersShown, !markers);
    QCOMPARE(action(ActionId::Markers)->isChecked(), !markers);
    const bool leaves = settings.values().leavesShown;
    QTest::keyClick(handle(), Qt::Key_L);
    QTRY_COMPARE(settings.values().leavesShown, !leaves);
}

void MainWindowTest::takeLasso()
{
    action(ActionId::Lasso)->trigger();
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    m_window->document().reset(3, parameters);
    QCOMPARE(m_window->document().index().livingCount(), 1U);
}

std::vector<QPoint> MainWindowTest::lassoPlaces()
{
    std::vector<QPoint> places;
    for (int i = 0; i <= 40; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 41.0;
        places.push_back(
            at(static_cast<float>(0.9 * std::cos(angle)), static_cast<float>(1.7 + 0.9 * std::sin(angle))));
    }
    return places;
}

void MainWindowTest::drawLasso()
{
    const std::vector<QPoint> places = lassoPlaces();
    QTest::mousePress(handle(), Qt::LeftButton, {}, places.front());
    for (const QPoint& place : places)
        QTest::mouseMove(handle(), place, 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, places.back());
}

void MainWindowTest::mouse_drawsALassoThatTheTreeFills()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QCOMPARE(document.tree().lassos().inForce.size(), 1U);
    QCOMPARE(document.undoStack().count(), 0); // it is growing still
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
    Box3 crown;
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        if (document.index().tipCount(id) <= 3)
            crown.extend(document.index().nodePosition(id));
    }
    QVERIFY(crown.max().y() < 2.65F && crown.max().y() > 2.2F);
    QVERIFY(crown.max().x() < 0.95F && crown.min().x() > -0.95F && crown.sizes().x() > 1.3F);
    QVERIFY(crown.sizes().z() > 1.2F);
    action(ActionId::Undo)->trigger();
    QCOMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.tree().lassos().inForce.empty());
    action(ActionId::Redo)->trigger();
    QVERIFY(document.index().livingCount() > 100);
}

void MainWindowTest::finger_drawsALasso()
{
    takeLasso();
    const std::vector<QPoint> places = lassoPlaces();
    QTest::touchEvent(handle(), m_screen).press(0, places.front());
    for (const QPoint& place : places)
        QTest::touchEvent(handle(), m_screen).move(0, place);
    QTest::touchEvent(handle(), m_screen).release(0, places.back());
    const TreeDocument& document = m_window->document();
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
    QCOMPARE(document.tree().lassos().inForce.size(), 1U);
}

void MainWindowTest::pen_drawsALasso()
{
    takeLasso();
    static const QPointingDevice pen(
        QStringLiteral("lasso pen"), 8, QInputDevice::DeviceType::Stylus, QPointingDevice::PointerType::Pen,
        QInputDevice::Capability::Position | QInputDevice::Capability::Pressure, 1, 1);
    const auto send = [this](QEvent::Type type, const QPoint& inWindow) {
        const QPointF place = viewport().mapFrom(m_window.get(), inWindow);
        QTabletEvent event(type, &pen, place, viewport().mapToGlobal(place),
                           type == QEvent::TabletRelease ? 0.0 : 0.6, 0, 0, 0, 0, 0, Qt::NoModifier,
                           type == QEvent::TabletMove ? Qt::NoButton : Qt::LeftButton,
                           type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
        QCoreApplication::sendEvent(&viewport(), &event);
    };
    const std::vector<QPoint> places = lassoPlaces();
    send(QEvent::TabletPress, places.front());
    for (const QPoint& place : places)
        send(QEvent::TabletMove, place);
    send(QEvent::TabletRelease, places.back());
    const TreeDocument& document = m_window->document();
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 1, 20000);
    QVERIFY(document.index().livingCount() > 100);
}

void MainWindowTest::escapeDuringLassoGrowth_takesAllBack()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_COMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.tree().lassos().strokes.isEmpty());
    QVERIFY(document.journal().empty());
    QCOMPARE(document.undoStack().count(), 0);
}

void MainWindowTest::pressDuringLassoGrowth_keepsWhatGrew()
{
    takeLasso();
    drawLasso();
    const TreeDocument& document = m_window->document();
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(-2.0F, 0.4F));
    QCOMPARE(document.undoStack().count(), 1);
    const std::uint32_t living = document.index().livingCount();
    QVERIFY(living > 20);
    QTest::qWait(150);
    QCOMPARE(document.index().livingCount(), living);
}

void MainWindowTest::lassoTooSmall_isSaidInOneSentence()
{
    takeLasso();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(0.5F, 1.0F));
    for (int i = 0; i <= 10; ++i)
        QTest::mouseMove(handle(), at(0.5F + 0.1F * static_cast<float>(i), 1.0F), 1);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(1.5F, 1.0F));
    QVERIFY(!notice().isEmpty());
    QVERIFY(m_window->workspace().notice().isVisible());
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QVERIFY(m_window->document().tree().lassos().strokes.isEmpty());
}

void MainWindowTest::lassoPopOut_regrowsRemovesAndHides()
{
    takeLasso();
    auto* regrow = m_window->findChild<QPushButton*>(QStringLiteral("lassoRegrow"));
    auto* remove = m_window->findChild<QPushButton*>(QStringLiteral("lassoRemove"));
    auto* stop = m_window->findChild<QPushButton*>(QStringLiteral("lassoStop"));
    QVERIFY(regrow && remove && stop && regrow->isVisible());
    QVERIFY(!regrow->isEnabled() && !remove->isEnabled() && !stop->isEnabled());
    drawLasso();
    const TreeDocument& document = m_window->document();
    QVERIFY(stop->isEnabled() && !regrow->isEnabled());
    QTRY_VERIFY(document.index().livingCount() > 20);
    QTest::mouseClick(stop, Qt::LeftButton);
    QCOMPARE(document.undoStack().count(), 1);
    QTest::mouseClick(regrow, Qt::LeftButton);
    QCOMPARE(document.index().livingCount(), 1U);
    QTRY_COMPARE_WITH_TIMEOUT(document.undoStack().count(), 2, 20000);
    QVERIFY(document.index().livingCount() > 100);
    auto* show = m_window->findChild<QCheckBox*>(QStringLiteral("lassoShow"));
    QVERIFY(show && show->isChecked());
    show->click();
    QVERIFY(!m_window->viewSettings().values().envelopeShown);
    show->click();
    QTest::mouseClick(remove, Qt::LeftButton);
    QVERIFY(document.tree().lassos().inForce.empty());
    QVERIFY(document.index().livingCount() > 100);
    QCOMPARE(document.undoStack().count(), 3);
}

void MainWindowTest::tab_hidesEverythingButTheTree()
{
    auto* bar = m_window->findChild<TopBar*>();
    auto* tools = m_window->findChild<SideBar*>();
    QVERIFY(bar->isVisible() && tools->isVisible());
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(!bar->isVisible() && !tools->isVisible());
    QVERIFY(viewport().isVisible());
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(bar->isVisible() && tools->isVisible());
}

void MainWindowTest::sheets_opensOneAtATime()
{
    Workspace& workspace = m_window->workspace();
    action(ActionId::Architecture)->trigger();
    QVERIFY(workspace.sheet(0).isVisible());
    action(ActionId::LeafSheet)->trigger();
    QVERIFY(!workspace.sheet(0).isVisible() && workspace.sheet(2).isVisible());
    action(ActionId::Background)->trigger();
    QVERIFY(!workspace.sheet(2).isVisible() && workspace.background().isVisible());
    action(ActionId::LeafSheet)->trigger();
    QVERIFY(!workspace.background().isVisible());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!workspace.sheet(2).isVisible());
}

void MainWindowTest::f6_leadsTheKeysToThePanelsAndBack()
{
    action(ActionId::LeafSheet)->trigger();
    QTest::keyClick(handle(), Qt::Key_F6);
    Bar& sheet = m_window->workspace().sheet(2);
    QTRY_VERIFY(sheet.isAncestorOf(QApplication::focusWidget()));
    QWidget* const first = QApplication::focusWidget();
    QTest::keyClick(handle(), Qt::Key_Tab);
    QTRY_VERIFY(QApplication::focusWidget() != first);
    QVERIFY(sheet.isVisible() && sheet.isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_COMPARE(QApplication::focusWidget(), &viewport());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTRY_VERIFY(!sheet.isVisible());
}

void MainWindowTest::architecture_isDraggedOverTheLiveTree()
{
    brush();
    const std::uint32_t grown = m_window->document().index().livingCount();
    action(ActionId::Architecture)->trigger();
    ArchitecturePanel& panel = m_window->workspace().architecture();
    Diagram* tropism = panel.diagrams().front();
    const QPoint from = tropism->mapTo(m_window.get(), tropism->handlePlace(0).toPoint());
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i)
        QTest::mouseMove(handle(), from + QPoint(0, 8 * i));
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from + QPoint(0, 64));
    const TreeDocument& document = m_window->document();
    QCOMPARE(document.undoStack().count(), 2);
    const double theta = document.parameters().growth.setPointAngle;
    QVERIFY(theta > radians(60));
    // What has grown stays; the arrows are the handle's, and F6 leads back to the tree.
    QCOMPARE(document.index().livingCount(), grown);
    QTest::keyClick(handle(), Qt::Key_Down);
    QVERIFY(document.parameters().growth.setPointAngle > theta);
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_COMPARE(QApplication::focusWidget(), &viewport());
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_VERIFY(qobject_cast<DiagramHandle*>(QApplication::focusWidget()));
    QVERIFY(QApplication::focusWidget()->isVisible());
    // The tree is still there to be brushed.
    brush(0.5F, 1.2F, 0.5F);
    QVERIFY(document.index().livingCount() > grown);
    action(ActionId::Architecture)->trigger();
    QVERIFY(!panel.isVisible());
}

void MainWindowTest::recipe_isPlayedAndHandedOver()
{
    QFile file(m_folder->filePath(QStringLiteral("small.json")));
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(R"({"espalier-recipe": 1, "name": "Small", "seed": 5,
                   "operations": [{"op": "grow", "steps": 4}, {"op": "grow", "steps": 2}]})");
    file.close();
    m_window->files().openFile(file.fileName());
    QVERIFY2(m_window->recipeRunner().isRunning(), qPrintable(notice()));
    QTRY_VERIFY(!m_window->recipeRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{6});
    QCOMPARE(m_window->document().tree().seed(), std::uint64_t{5});
    QCOMPARE(m_window->document().undoStack().count(), 2);
    QVERIFY(m_window->isWindowModified());
    brush(0.2F, 1.2F, 0.3F);
    QCOMPARE(m_window->document().undoStack().count(), 3);
}

namespace {

void dropFile(QWidget& on, const QString& name)
{
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(name)});
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&on, &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    QCoreApplication::sendEvent(&on, &drop);
}

void writeTo(const QString& name, const QByteArray& content)
{
    QFile file(name);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(content);
}

} // namespace

void MainWindowTest::droppedImage_becomesLeafOrBark()
{
    const TreeDocument& document = m_window->document();
    const QString leaf = m_folder->filePath(QStringLiteral("leaf.png"));
    const QString bark = m_folder->filePath(QStringLiteral("Oak_Color.png"));
    writeTo(leaf, test::pngOf(test::drawnLeaf(Qt::white)));
    writeTo(bark, test::pngOf(test::repeatingBark(64, 64)));
    writeTo(m_folder->filePath(QStringLiteral("Oak_NormalGL.png")), test::pngOf(test::repeatingBark(64, 32)));

    // Anywhere on the window: it asks what the image shall be.
    dropFile(*m_window, leaf);
    QVERIFY(notice().contains(QStringLiteral("leaf.png")));
    const auto* const yes = m_window->workspace().notice().findChild<QPushButton*>();
    QVERIFY(yes);
    QTest::mouseClick(const_cast<QPushButton*>(yes), Qt::LeftButton);
    QTRY_VERIFY(!document.parameters().leaves.image.isNull());
    QVERIFY(std::abs(document.parameters().leaves.aspect - 0.5) < 0.05);
    QCOMPARE(document.undoStack().count(), 1);

    // On the sheet of branches: it is bark, with what lies beside it.
    dropFile(m_window->workspace().sheet(2), bark);
    QTRY_VERIFY(!document.parameters().bark.image.isNull());
    QCOMPARE(document.parameters().bark.normalImage.name(), QStringLiteral("Oak_NormalGL.png"));
    QVERIFY(document.parameters().bark.roughnessImage.isNull());
    QCOMPARE(document.undoStack().count(), 2);
    m_window->document().undoStack().undo();
    QVERIFY(document.parameters().bark.image.isNull());
    QVERIFY(!document.parameters().leaves.image.isNull());
}

void MainWindowTest::imageThatIsNone_isRefusedInOneSentence()
{
    const TreeParameters before = m_window->document().parameters();
    const QString name = m_folder->filePath(QStringLiteral("broken.png"));
    writeTo(name, "no image");
    dropFile(m_window->workspace().sheet(1), name);
    QTRY_VERIFY(m_window->workspace().notice().isWarning());
    QCOMPARE(notice(), QStringLiteral("broken.png: it is neither a PNG nor a JPEG image"));
    writeTo(name, test::pngOf(test::repeatingBark(64, 64)));
    dropFile(m_window->workspace().sheet(1), name);
    QTRY_VERIFY(notice().startsWith(QStringLiteral("broken.png: there is no telling the leaf")));
    QVERIFY(m_window->document().parameters() == before);
    QCOMPARE(m_window->document().undoStack().count(), 0);
}

void MainWindowTest::droppedFile_isOpened()
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
    QVERIFY(m_window->document().tree() == tree);

    data.setUrls({QUrl::fromLocalFile(QStringLiteral("/tmp/picture.txt"))});
    QDragEnterEvent other(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
    other.ignore();
    QCoreApplication::sendEvent(m_window.get(), &other);
    QVERIFY(!other.isAccepted());
}

void MainWindowTest::recentFiles_listWhatWasSaved()
{
    for (const char* name : {"a.espalier", "b.espalier", "a.espalier"})
        save(m_folder->filePath(QString::fromLatin1(name)));
    QMenu menu;
    m_window->files().fillRecentFiles(menu);
    QCOMPARE(menu.actions().value(0)->text(), QStringLiteral("a.espalier"));
    QCOMPARE(menu.actions().value(1)->text(), QStringLiteral("b.espalier"));
    QVERIFY(menu.actions().value(2)->isSeparator());
}

void MainWindowTest::crash_losesNothingThatWasFinished()
{
    Autosave& autosave = m_window->files().autosave();
    QSignalSpy written(&autosave, &Autosave::written);
    brush();
    QVERIFY(written.count() > 0 || written.wait());
    QVERIFY(Autosave::leftovers().empty());
    const Tree grown = m_window->document().tree();

    // A crash leaves the files, and no program that holds their lock.
    const QDir place(Autosave::folder());
    const QStringList projects = place.entryList({QStringLiteral("*.espalier")}, QDir::Files);
    QCOMPARE(projects.size(), 1);
    QVERIFY(QFile::copy(place.filePath(projects.constFirst()),
                        place.filePath(QStringLiteral("crashed.espalier"))));
    m_window->document().undoStack().setClean();
    m_window = std::make_unique<MainWindow>();
    m_window->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
    QCOMPARE(Autosave::leftovers().size(), std::size_t{1});

    m_window->files().offerRecovery();
    QTest::mouseClick(m_window->workspace().notice().findChild<QPushButton*>(), Qt::LeftButton);
    QVERIFY(m_window->document().tree() == grown);
    QVERIFY(m_window->isWindowModified());
    QVERIFY(Autosave::leftovers().empty());
    save(m_folder->filePath(QStringLiteral("rescued.espalier")));
    QTRY_VERIFY(place.entryList({QStringLiteral("*.espalier")}, QDir::Files).isEmpty());
}

void MainWindowTest::export_writesTheFileInTheBackground()
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

void MainWindowTest::cancelledExport_leavesNothing()
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

void MainWindowTest::window_looksLikeThis()
{
    m_window->resize(1440, 900);
    m_window->viewSettings().setValues({});
    const auto shoot = [this](const char* name) {
        QTest::qWait(300);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().isAtRest(), 30000);
        const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
        QVERIFY(picture.save(QString::fromLatin1(name)));
        // Bars on top, a tree in the middle.
        const QImage image = picture.toImage();
        QSet<QRgb> colours;
        for (int x = 0; x < image.width(); x += 3)
            colours.insert(image.pixel(x, image.height() / 2));
        QVERIFY2(colours.size() > 50, name);
    };
    shoot("window-empty.png");
    const Result<Recipe> recipe = readRecipe(QStringLiteral(":/recipes/oak.json"));
    QVERIFY(recipe);
    RecipePlayer(m_window->document(), *recipe).playAll();
    action(ActionId::FrameAll)->trigger();
    shoot("window.png");
    action(ActionId::Architecture)->trigger();
    shoot("window-architecture.png");
    m_window->resize(m_window->minimumSize());
    shoot("window-small.png");
    m_window->resize(1440, 900);
    action(ActionId::LeafSheet)->trigger();
    action(ActionId::Grow)->trigger();
    m_window->workspace().notice().showWarning(
        QStringLiteral("old-oak.espalier: journal/died: the column is shorter than the deltas say"));
    shoot("window-leaves.png");
    action(ActionId::BranchSheet)->trigger();
    action(ActionId::Brush)->trigger();
    m_window->workspace().notice().showProgress(QStringLiteral("Writing old-oak.fbx"), 0.4, [] {});
    const QPoint from = at(1.4F, 2.4F);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 12; ++i) {
        QTest::mouseMove(handle(), from + QPoint(7 * i, -5 * i));
        QTest::qWait(20);
    }
    const QPixmap picture = m_window->screen()->grabWindow(m_window->winId());
    QVERIFY(picture.save(QStringLiteral("window-stroke.png")));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, from);
}

int main(int argc, char** argv)
{
    QSurfaceFormat::setDefaultFormat(surfaceFormat());
    QApplication application(argc, argv);
    QCoreApplication::setOrganizationName(QStringLiteral("Espalier"));
    QCoreApplication::setApplicationName(QStringLiteral("espalier-test"));
    MainWindowTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "MainWindowTest.moc"
