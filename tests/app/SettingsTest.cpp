// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/MainWindow.h"
#include "panels/BrushPopOut.h"
#include "panels/HistoryPanel.h"
#include "panels/ParameterRow.h"
#include "panels/PressureCurve.h"
#include "panels/SettingsSheet.h"
#include "panels/Theme.h"
#include "tests/support/TestClasses.h"
#include "views/Viewport.h"

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QDir>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QImage>
#include <QInputDevice>
#include <QLabel>
#include <QPalette>
#include <QPixmap>
#include <QPoint>
#include <QPointF>
#include <QPointingDevice>
#include <QPushButton>
#include <QRect>
#include <QSettings>
#include <QSlider>
#include <QSpinBox>
#include <QTabletEvent>
#include <QTest>
#include <QUndoStack>
#include <QWidget>
#include <QWindow>

namespace espalier {

/// Preferences take effect at once, and are kept for the next start.
class SettingsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init();
    void cleanup();
    void cleanupTestCase()
    {
        m_window.reset();
        theme::apply(*qApp);
    }

    void preferences_areRemembered();
    void nonsense_isTheDefaultOrTheNearest();
    void theme_changesAtOnceAndBack();
    void toolsOnTheRight_areMirrored();
    void units_changeEverywhereAtOnce();
    void curve_isDrawnToThePointer();
    void curve_showsWhatAPenPresses();
    void pressureExponent_reachesTheBrush();
    void stabiliser_calmsTheBrush();
    void mouseScheme_reachesTheCamera();
    void undoSteps_countFromTheNextTreeOn();
    void recipes_areNotHeldToTheUndoSteps();
    void defaults_bringAllBack();
    void settings_lookLikeThis();

private:
    QWindow* handle() { return m_window->windowHandle(); }
    Viewport& viewport() { return m_window->workspace().viewport(); }
    QAction* action(ActionId id) { return m_window->actions()[id]; }
    SettingsSheet& open();
    QComboBox* box(SettingsSheet& sheet, const char* name)
    {
        return sheet.findChild<QComboBox*>(QString::fromLatin1(name));
    }
    void sendPen(QWidget& widget, QEvent::Type type, const QPointF& place, double pressure);

    std::unique_ptr<MainWindow> m_window;
};

namespace {

const test::TestClass<SettingsTest> kSettingsEntered;

} // namespace

void SettingsTest::init()
{
    QSettings().clear();
    if (!m_window)
        m_window = std::make_unique<MainWindow>();
    m_window->resize(1024, 700);
    m_window->workspace().viewport().setBestSamples(1);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    m_window->viewSettings().setValues({});
    SceneLook look;
    look.shadowsShown = false;
    m_window->files().file().setLookOfNewTrees(look);
    m_window->document().setLook(look);
    m_window->files().file().setUnmodified();
    viewport().setFocus();
}

void SettingsTest::cleanup()
{
    if (auto* sheet = m_window->findChild<SettingsSheet*>()) {
        sheet->findChildren<QPushButton*>();
        for (auto* button : sheet->findChildren<QPushButton*>()) {
            if (button->text() == QStringLiteral("Defaults"))
                button->click();
        }
        delete sheet;
    }
    m_window->recipeRunner().stop();
    m_window->files().file().setUnmodified();
    action(ActionId::New)->trigger();
}

SettingsSheet& SettingsTest::open()
{
    QTest::keyClick(handle(), Qt::Key_Comma, Qt::ControlModifier);
    auto* sheet = m_window->findChild<SettingsSheet*>();
    if (!sheet)
        qFatal("Ctrl+, does not open the settings.");
    if (!QTest::qWaitForWindowExposed(sheet))
        qFatal("The settings do not show.");
    return *sheet;
}

void SettingsTest::sendPen(QWidget& widget, QEvent::Type type, const QPointF& place, double pressure)
{
    static const QPointingDevice pen(QStringLiteral("pen"), 9, QInputDevice::DeviceType::Stylus,
                                     QPointingDevice::PointerType::Pen, QInputDevice::Capability::Pressure, 1,
                                     2);
    QTabletEvent event(type, &pen, place, widget.mapToGlobal(place), pressure, 0.0F, 0.0F, 0.0F, 0.0, 0.0F,
                       {}, Qt::LeftButton, type == QEvent::TabletRelease ? Qt::NoButton : Qt::LeftButton);
    QCoreApplication::sendEvent(&widget, &event);
}

void SettingsTest::preferences_areRemembered()
{
    QVERIFY(Settings().preferences() == Preferences());
    SettingsSheet& sheet = open();
    box(sheet, "mouse")->setCurrentIndex(2);
    box(sheet, "side")->setCurrentIndex(1);
    QComboBox* language = box(sheet, "language");
    QCOMPARE(language->count(), 6);
    language->setCurrentIndex(language->findData(QStringLiteral("ja")));
    sheet.findChild<QSpinBox*>(QStringLiteral("undo"))->setValue(40);
    sheet.findChild<QSpinBox*>(QStringLiteral("undoMemory"))->setValue(300);
    sheet.findChild<QSlider*>(QStringLiteral("softness"))->setValue(-50);
    QCOMPARE(Settings().interfaceScale(), 100);
    box(sheet, "scale")->setFocus();
    QTest::keyClick(box(sheet, "scale"), Qt::Key_Down);
    QTest::keyClick(box(sheet, "scale"), Qt::Key_Down);
    QCOMPARE(Settings().interfaceScale(), 150);
    // The next start uses it, unless the environment has a size.
    const QByteArray own = qgetenv("QT_SCALE_FACTOR");
    qunsetenv("QT_SCALE_FACTOR");
    Settings().scaleInterface();
    QCOMPARE(qgetenv("QT_SCALE_FACTOR").toDouble(), 1.5);
    qputenv("QT_SCALE_FACTOR", "1.25");
    Settings().scaleInterface();
    QCOMPARE(qgetenv("QT_SCALE_FACTOR"), QByteArray("1.25"));
    if (own.isNull())
        qunsetenv("QT_SCALE_FACTOR");
    else
        qputenv("QT_SCALE_FACTOR", own);
    const Preferences kept = Settings().preferences();
    QCOMPARE(kept.mouse, MouseScheme::Maya);
    QVERIFY(kept.areToolsRight);
    QCOMPARE(kept.language, QStringLiteral("ja"));
    QCOMPARE(kept.undoSteps, 40);
    QCOMPARE(kept.undoMemory, 300);
    QCOMPARE(kept.pressureExponent, 0.5);
    QVERIFY(kept == sheet.preferences());
    // A second trigger opens no second sheet.
    action(ActionId::Settings)->trigger();
    QCOMPARE(m_window->findChildren<SettingsSheet*>().size(), 1);
}

void SettingsTest::nonsense_isTheDefaultOrTheNearest()
{
    QSettings store;
    store.setValue(QStringLiteral("window/theme"), 17);
    store.setValue(QStringLiteral("hand/mouse"), QStringLiteral("trackball"));
    store.setValue(QStringLiteral("hand/pressureExponent"), QStringLiteral("nan"));
    store.setValue(QStringLiteral("hand/undoSteps"), -5);
    store.setValue(QStringLiteral("hand/undoMemory"), 1);
    store.setValue(QStringLiteral("window/language"), QStringLiteral("klingon"));
    const Preferences read = Settings().preferences();
    QCOMPARE(read.look, Look::Dark);
    QCOMPARE(read.mouse, MouseScheme::Espalier);
    QCOMPARE(read.pressureExponent, 1.0);
    QCOMPARE(read.undoSteps, 0);
    QCOMPARE(read.undoMemory, Preferences::kLeastUndoMemory);
    QVERIFY(read.language.isEmpty());
    store.setValue(QStringLiteral("hand/pressureExponent"), 100.0);
    QCOMPARE(Settings().preferences().pressureExponent, Preferences::kFirmest);
}

void SettingsTest::theme_changesAtOnceAndBack()
{
    const auto barColour = [this] {
        const QImage bar = m_window->workspace().topBar().grab().toImage();
        return bar.pixelColor(bar.width() / 2 - 240, 6);
    };
    const auto iconColour = [this] {
        return action(ActionId::Open)->icon().pixmap(24, 24).toImage().pixelColor(4, 12).lightness();
    };
    SettingsSheet& sheet = open();
    QVERIFY(barColour().lightness() < 80);
    QVERIFY(iconColour() > 150);
    box(sheet, "look")->setCurrentIndex(1);
    QVERIFY(barColour().lightness() > 200);
    QVERIFY(iconColour() < 110);
    QVERIFY(m_window->palette().color(QPalette::WindowText).lightness() < 80);
    box(sheet, "look")->setCurrentIndex(0);
    QVERIFY(barColour().lightness() < 80);
    QVERIFY(iconColour() > 150);
}

void SettingsTest::toolsOnTheRight_areMirrored()
{
    Workspace& workspace = m_window->workspace();
    const auto popOut = workspace.findChild<BrushPopOut*>();
    const auto side = workspace.findChild<SideBar*>();
    const QRect tools = side->geometry();
    const QRect beside = popOut->geometry();
    QVERIFY(tools.right() < beside.left());
    SettingsSheet& sheet = open();
    box(sheet, "side")->setCurrentIndex(1);
    QCOMPARE(side->geometry().right(), workspace.width() - 1 - tools.left());
    QCOMPARE(popOut->geometry().right(), workspace.width() - 1 - beside.left());
    for (int i = 0; i < Workspace::kSheetCount; ++i) {
        action(Actions::sheets()[static_cast<std::size_t>(i)])->trigger();
        QVERIFY(workspace.sheet(i).isVisible());
        QVERIFY(workspace.rect().contains(workspace.sheet(i).geometry()));
        QVERIFY(!workspace.sheet(i).geometry().intersects(side->geometry()));
    }
    action(ActionId::Background)->trigger();
    action(ActionId::History)->setChecked(true);
    QVERIFY(workspace.history().geometry().right() < workspace.width() / 2);
    action(ActionId::History)->setChecked(false);
}

void SettingsTest::units_changeEverywhereAtOnce()
{
    action(ActionId::LeafSheet)->trigger();
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.5);
    const auto length = [this] {
        const auto* row = m_window->findChild<ParameterRow*>(QStringLiteral("leaves.length"));
        return row->findChild<QDoubleSpinBox*>()->text();
    };
    const auto radius = [this] { return m_window->findChild<BrushPopOut*>()->findChild<QLabel*>()->text(); };
    QCOMPARE(length(), QStringLiteral("9.0 cm"));
    QCOMPARE(radius(), QStringLiteral("50 cm"));
    box(open(), "units")->setCurrentIndex(1);
    QTRY_COMPARE(length(), QStringLiteral("3.54 in"));
    QCOMPARE(radius(), QStringLiteral("1 ft 8 in"));
    QCOMPARE(Settings().preferences().units, Units::Imperial);
    QVERIFY(m_window->workspace().sheet(2).isVisible());
    // The sheet of settings is still there.
    auto* sheet = m_window->findChild<SettingsSheet*>();
    QVERIFY(sheet && sheet->isVisible());
    box(*sheet, "units")->setCurrentIndex(0);
    QTRY_COMPARE(length(), QStringLiteral("9.0 cm"));
    action(ActionId::LeafSheet)->trigger();
}

void SettingsTest::curve_isDrawnToThePointer()
{
    SettingsSheet& sheet = open();
    auto* curve = sheet.findChild<PressureCurve*>();
    const QPoint middle = curve->rect().center();
    QTest::mousePress(curve, Qt::LeftButton, {}, middle);
    QVERIFY(std::abs(curve->exponent() - 1.0) < 0.05);
    QTest::mouseMove(curve, middle - QPoint(0, curve->height() / 4));
    QTest::mouseRelease(curve, Qt::LeftButton, {}, middle - QPoint(0, curve->height() / 4));
    QVERIFY2(std::abs(curve->exponent() - std::log(0.75) / std::log(0.5)) < 0.05,
             qPrintable(QString::number(curve->exponent())));
    QVERIFY(sheet.findChild<QSlider*>(QStringLiteral("softness"))->value() < -40);
    QCOMPARE(Settings().preferences().pressureExponent, curve->exponent());
    QTest::mouseClick(curve, Qt::LeftButton, {}, curve->rect().topLeft() + QPoint(2, 2));
    QCOMPARE(curve->exponent(), Preferences::kSoftest);
    // The same by the keyboard.
    auto* slider = sheet.findChild<QSlider*>(QStringLiteral("softness"));
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_End);
    QCOMPARE(curve->exponent(), Preferences::kFirmest);
}

void SettingsTest::curve_showsWhatAPenPresses()
{
    SettingsSheet& sheet = open();
    auto* curve = sheet.findChild<PressureCurve*>();
    const QImage before = curve->grab().toImage();
    sendPen(*curve, QEvent::TabletPress, {40, 60}, 0.3);
    sendPen(*curve, QEvent::TabletMove, {120, 60}, 0.9);
    QCOMPARE(curve->rawPressure(), 0.9);
    QVERIFY(curve->grab().toImage() != before);
    sendPen(*curve, QEvent::TabletRelease, {120, 60}, 0.0);
    QCOMPARE(curve->rawPressure(), 0.0);
    QCOMPARE(curve->exponent(), 1.0);
}

void SettingsTest::pressureExponent_reachesTheBrush()
{
    // With the same pressure, which scales the radius, a soft curve gives the wider tree.
    const auto widthWith = [this](double exponent) {
        viewport().setPressureExponent(exponent);
        const Camera& camera = viewport().mainCamera();
        const QPointF from = camera.project(Vec3(Vec3::Zero())).value_or(QPointF());
        const QPointF to = camera.project(Vec3(1.6F * Vec3::UnitY())).value_or(QPointF());
        for (int i = 0; i <= 26; ++i) {
            const auto type = i == 0    ? QEvent::TabletPress
                              : i == 26 ? QEvent::TabletRelease
                                        : QEvent::TabletMove;
            sendPen(viewport(), type, from + (to - from) * std::min(i, 25) / 25.0, i == 26 ? 0.0 : 0.3);
            QTest::qWait(20);
        }
        const TreeDocument& document = m_window->document();
        Box3 bounds{Vec3(Vec3::Zero())};
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                bounds.extend(document.index().nodePosition(id));
        }
        m_window->document().undoStack().undo();
        return bounds.sizes().x();
    };
    const float firm = widthWith(4.0);
    const float soft = widthWith(0.25);
    viewport().setPressureExponent(1.0);
    QVERIFY2(firm < 0.7F * soft, qPrintable(QStringLiteral("%1 m, %2 m").arg(firm).arg(soft)));
}

void SettingsTest::stabiliser_calmsTheBrush()
{
    m_window->viewSettings().set(&ViewValues::brushRadius, 0.0);
    const auto widthDrawn = [this] {
        const Camera& camera = viewport().mainCamera();
        const QPoint foot = camera.project(Vec3(Vec3::Zero())).value_or(QPointF()).toPoint();
        QTest::mousePress(&viewport(), Qt::LeftButton, Qt::NoModifier, foot);
        for (int i = 1; i <= 30; ++i)
            QTest::mouseMove(&viewport(), foot + QPoint(i % 2 == 0 ? 14 : -14, -8 * i), 10);
        QTest::mouseRelease(&viewport(), Qt::LeftButton, Qt::NoModifier, foot - QPoint(0, 250));
        const TreeDocument& document = m_window->document();
        Box3 bounds{Vec3(Vec3::Zero())};
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                bounds.extend(document.index().nodePosition(id));
        }
        m_window->document().undoStack().undo();
        return bounds.sizes().x();
    };
    const float trembling = widthDrawn();
    SettingsSheet& sheet = open();
    auto* distance = sheet.findChild<QSlider*>(QStringLiteral("stabiliserDistance"));
    distance->setFocus();
    for (int i = 0; i < 30; ++i)
        QTest::keyClick(distance, Qt::Key_Right);
    QCOMPARE(Settings().preferences().stabilising.distance, 30.0);
    sheet.close();
    viewport().setFocus();
    const float calm = widthDrawn();
    QVERIFY2(calm < 0.5F * trembling, qPrintable(QStringLiteral("%1 m, %2 m").arg(trembling).arg(calm)));
}

void SettingsTest::mouseScheme_reachesTheCamera()
{
    const auto drag = [this](Qt::MouseButton button, Qt::KeyboardModifiers modifiers) {
        const Camera before = viewport().mainCamera();
        const QPoint from = viewport().rect().center();
        QTest::mousePress(&viewport(), button, modifiers, from);
        QTest::mouseRelease(&viewport(), button, modifiers, from + QPoint(60, -40));
        const Camera& after = viewport().mainCamera();
        const bool turned = before.azimuth() != after.azimuth();
        const bool zoomed = before.distance() != after.distance();
        viewport().setCamera(before);
        return turned   ? QStringLiteral("turned")
               : zoomed ? QStringLiteral("zoomed")
                        : QStringLiteral("stayed");
    };
    QCOMPARE(drag(Qt::RightButton, {}), QStringLiteral("turned"));
    SettingsSheet& sheet = open();
    box(sheet, "mouse")->setCurrentIndex(1);
    QCOMPARE(drag(Qt::RightButton, {}), QStringLiteral("stayed"));
    QCOMPARE(drag(Qt::MiddleButton, Qt::ControlModifier), QStringLiteral("zoomed"));
    box(sheet, "mouse")->setCurrentIndex(2);
    QCOMPARE(drag(Qt::MiddleButton, {}), QStringLiteral("stayed"));
    QCOMPARE(drag(Qt::RightButton, Qt::AltModifier), QStringLiteral("zoomed"));
}

void SettingsTest::undoSteps_countFromTheNextTreeOn()
{
    SettingsSheet& sheet = open();
    sheet.findChild<QSpinBox*>(QStringLiteral("undo"))->setValue(3);
    m_window->activateWindow();
    action(ActionId::New)->trigger();
    QUndoStack& stack = m_window->document().undoStack();
    for (int i = 0; i < 5; ++i) {
        action(ActionId::GrowStep)->trigger();
        QTRY_COMPARE(m_window->document().tree().step(), static_cast<Step>(i + 1));
        QTRY_VERIFY(!m_window->growRunner().isRunning());
    }
    QCOMPARE(stack.count(), 3);
    while (stack.canUndo())
        stack.undo();
    QCOMPARE(m_window->document().tree().step(), Step{2});
    QVERIFY(m_window->isWindowModified());
}

void SettingsTest::recipes_areNotHeldToTheUndoSteps()
{
    SettingsSheet& sheet = open();
    sheet.findChild<QSpinBox*>(QStringLiteral("undo"))->setValue(2);
    const Result<Recipe> recipe = parseRecipe(R"({"espalier-recipe": 1, "seed": 5, "operations": [
        {"op": "grow", "steps": 1}, {"op": "grow", "steps": 1}, {"op": "grow", "steps": 1},
        {"op": "grow", "steps": 1}, {"op": "undo", "count": 4}]})");
    QVERIFY(recipe);
    m_window->playRecipe(*recipe, RecipeRunner::Pace::Hurried);
    QTRY_VERIFY(!m_window->recipeRunner().isRunning());
    QCOMPARE(m_window->document().tree().step(), Step{0});
    QCOMPARE(m_window->document().undoStack().count(), 4);
}

void SettingsTest::defaults_bringAllBack()
{
    Preferences others{Look::Light, true, 2.0, MouseScheme::Blender, 50, 500, QDir::tempPath()};
    SettingsSheet sheet(others);
    QVERIFY(sheet.preferences() == others);
    for (auto* button : sheet.findChildren<QPushButton*>()) {
        if (button->text() == QStringLiteral("Defaults"))
            QTest::mouseClick(button, Qt::LeftButton);
    }
    QVERIFY(sheet.preferences() == Preferences());
    QCOMPARE(box(sheet, "mouse")->currentIndex(), 0);
    QCOMPARE(sheet.findChild<PressureCurve*>()->exponent(), 1.0);
}

void SettingsTest::settings_lookLikeThis()
{
    SettingsSheet& sheet = open();
    const auto shoot = [this](QWidget& widget, const char* name) {
        QTest::qWait(300);
        QTRY_VERIFY_WITH_TIMEOUT(viewport().isAtRest(), 30000);
        const QPixmap picture = widget.screen()->grabWindow(widget.winId());
        QVERIFY(picture.save(QString::fromLatin1(name)));
        QCOMPARE(picture.size(), widget.size());
    };
    shoot(sheet, "settings-dark.png");
    box(sheet, "look")->setCurrentIndex(1);
    shoot(sheet, "settings-light.png");
    sheet.hide();
    const Result<Recipe> recipe = readRecipe(QStringLiteral(":/recipes/candelabra.json"));
    QVERIFY(recipe);
    RecipePlayer(m_window->document(), *recipe).playAll();
    action(ActionId::FrameAll)->trigger();
    action(ActionId::Architecture)->trigger();
    shoot(*m_window, "light-small.png");
    m_window->resize(1590, 990);
    action(ActionId::History)->setChecked(true);
    shoot(*m_window, "light-architecture.png");
    action(ActionId::BranchSheet)->trigger();
    action(ActionId::History)->setChecked(false);
    action(ActionId::Help)->trigger();
    shoot(*m_window, "light-help.png");
    m_window->workspace().showHelp(false);
    action(ActionId::BranchSheet)->trigger();
    action(ActionId::Library)->setChecked(true);
    QTest::qWait(500);
    shoot(*m_window, "light-library.png");
    action(ActionId::Library)->setChecked(false);
    box(sheet, "side")->setCurrentIndex(1);
    action(ActionId::LeafSheet)->trigger();
    shoot(*m_window, "light-right.png");
    action(ActionId::LeafSheet)->trigger();
    box(sheet, "look")->setCurrentIndex(0);
    action(ActionId::Lasso)->trigger();
    shoot(*m_window, "dark-right.png");
    action(ActionId::Brush)->trigger();
}

} // namespace espalier

#include "SettingsTest.moc"
