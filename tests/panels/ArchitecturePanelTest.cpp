// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/ArchitecturePanel.h"

#include "model/growth/Gravimorphism.h"
#include "panels/ParameterNumber.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterValue.h"
#include "panels/Theme.h"
#include "panels/architecture/DiagramHandle.h"
#include "panels/architecture/DirectionDiagram.h"
#include "panels/architecture/GravimorphismDiagram.h"
#include "panels/architecture/PerceptionDiagram.h"
#include "panels/architecture/TropismDiagram.h"
#include "panels/architecture/ValueField.h"
#include "tests/support/TestClasses.h"

#include <QAccessible>
#include <QtTest>
#include <QtWidgets>

#include <map>
#include <numbers>

using namespace espalier;

/// A person at the drawings: mouse, finger, keys, typed numbers, and a screen reader.
class ArchitecturePanelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { theme::apply(*qApp); }
    void init();
    void cleanup();

    void everyParameterOfGrowth_hasAControlThatShowsIt();
    void everyControl_explainsItself();
    void mouseDrag_isOneUndoStep_data() { handles(); }
    void mouseDrag_isOneUndoStep();
    void finger_dragsAHandleItTouchesBeside_data() { handles(); }
    void finger_dragsAHandleItTouchesBeside();
    void escape_takesADragBack_data() { handles(); }
    void escape_takesADragBack();
    void doubleClick_bringsTheDefaultBack_data() { handles(); }
    void doubleClick_bringsTheDefaultBack();
    void arrows_moveAHandleAsTheyPoint_data() { handles(); }
    void arrows_moveAHandleAsTheyPoint();
    void handle_andParameterFollowFromEachOther_data() { handles(); }
    void handle_andParameterFollowFromEachOther();
    void screenReader_readsAndSetsHandles_data() { handles(); }
    void screenReader_readsAndSetsHandles();
    void typedNumber_movesTheHandle_data() { handles(); }
    void typedNumber_movesTheHandle();

    void press_thatTrembles_changesNothing();
    void growth_isPutInForceWhenTheDragEnds();
    void disabled_dropsTheDrag();
    void undoDuringADrag_endsIt();
    void screenReader_readsAndSetsSlidersInTheirUnits();
    void tab_goesFromHandleToHandle();
    void doubleClickBesideTheHandles_resetsTheDiagram();
    void schematic_isRedrawnWhileAHandleMoves();
    void barycentricWeights_areAWholeEverywhere();
    void triangle_sharesAWholeUnderAnyPull();
    void ellipse_isDrawnByTheModelsRays();
    void ellipse_containsTheAxisUnderAnyPull();
    void cone_growsBeyondItsCard();
    void rows_slidersSwitchesAndMore();
    void panel_fitsWindows();

private:
    /// Each handle, by its first parameter.
    static void handles();
    struct Place {
        Diagram* diagram;
        int number;
        DiagramHandle& handle() const { return diagram->handle(number); }
        QPoint point() const { return diagram->handlePlace(number).toPoint(); }
    };
    Place fetched() const;
    const TreeParameters& parameters() const { return m_document->parameters(); }
    int steps() const { return m_document->undoStack().count(); }
    void drag(const Place& place, const QPoint& by, bool letGo = true) const;
    /// A move that changes the parameter of any handle.
    static QPoint away(const Place& place);

    std::unique_ptr<TreeDocument> m_document;
    std::unique_ptr<ArchitecturePanel> m_panel;
    QPointingDevice* m_screen = QTest::createTouchDevice();
};

void ArchitecturePanelTest::init()
{
    m_document = std::make_unique<TreeDocument>();
    m_panel = std::make_unique<ArchitecturePanel>(*m_document);
    m_panel->fit({1500, 1000});
    m_panel->show();
    m_panel->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_panel.get()));
}

void ArchitecturePanelTest::cleanup()
{
    m_panel.reset();
    m_document.reset();
}

void ArchitecturePanelTest::handles()
{
    QTest::addColumn<QString>("key");
    for (const char* key :
         {"growth.setPointAngle", "growth.ellipseVertical", "growth.ellipseParallel", "growth.ellipseOffset",
          "growth.branchingAngle", "growth.deflectionAngle", "growth.axisWeight", "growth.occupancyRadius",
          "growth.perceptionDepth", "growth.perceptionAngle"})
        QTest::newRow(key) << QString::fromLatin1(key);
}

ArchitecturePanelTest::Place ArchitecturePanelTest::fetched() const
{
    QFETCH(QString, key);
    for (Diagram* diagram : m_panel->diagrams()) {
        for (int i = 0; i < diagram->handleCount(); ++i) {
            if (diagram->handle(i).keys().front() == key)
                return {diagram, i};
        }
    }
    qFatal("no handle for that parameter");
}

QPoint ArchitecturePanelTest::away(const Place& place)
{
    const QString key = place.handle().objectName();
    if (key == QStringLiteral("growth.ellipseParallel"))
        return {-18, 4};
    if (key == QStringLiteral("growth.ellipseOffset") || key == QStringLiteral("growth.perceptionDepth"))
        return {0, 14};
    if (key == QStringLiteral("growth.setPointAngle"))
        return {6, 18};
    return {-12, 16};
}

void ArchitecturePanelTest::drag(const Place& place, const QPoint& by, bool letGo) const
{
    const QPoint from = place.point();
    QTest::mousePress(place.diagram, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 5; ++i)
        QTest::mouseMove(place.diagram, from + by * i / 5);
    if (letGo)
        QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, from + by);
}

namespace {

ParameterSheet sheetOf(std::string_view key)
{
    const auto has = [key](const ParameterSection& section) {
        return std::ranges::any_of(section.parameters,
                                   [key](const ParameterText& text) { return key == text.key; });
    };
    return std::ranges::find_if(parameterSections(), has)->sheet;
}

} // namespace

void ArchitecturePanelTest::everyParameterOfGrowth_hasAControlThatShowsIt()
{
    int shown = 0;
    visitParameters(parameters(), [&](const ParameterInfo& info, const auto& field) {
        if (std::strncmp(info.key, "growth.", 7) != 0 || sheetOf(info.key) != ParameterSheet::Architecture)
            return;
        ++shown;
        const ParameterRow* row = m_panel->row(info.key);
        const ValueField* number = m_panel->field(info.key);
        QVERIFY2((row != nullptr) != (number != nullptr), info.key);
        const double value = surfaceValue(info, field);
        if (row)
            QCOMPARE(row->value(), value);
        else
            QVERIFY2(std::abs(number->number().value() - value) < 0.005, info.key);
    });
    QCOMPARE(shown, 25);
}

void ArchitecturePanelTest::everyControl_explainsItself()
{
    for (const ParameterSection& section : parameterSections()) {
        if (section.sheet != ParameterSheet::Architecture)
            continue;
        for (const ParameterText& text : section.parameters) {
            QVERIFY2(*text.botany != '\0', text.key);
            const QString told = explanation(text);
            QVERIFY2(told.contains(QString::fromUtf8(text.tip)), text.key);
            QVERIFY2(told.contains(QString::fromUtf8(text.botany)), text.key);
            const QWidget* control = m_panel->row(text.key);
            if (!control)
                control = m_panel->field(text.key);
            QCOMPARE(control->toolTip(), told);
            QCOMPARE(control->whatsThis(), told);
        }
    }
    for (const Diagram* diagram : m_panel->diagrams()) {
        QVERIFY(!diagram->toolTip().isEmpty());
        for (int i = 0; i < diagram->handleCount(); ++i)
            QVERIFY(!diagram->handle(i).toolTip().isEmpty() && !diagram->handle(i).whatsThis().isEmpty());
    }
}

void ArchitecturePanelTest::mouseDrag_isOneUndoStep()
{
    const Place place = fetched();
    const double before = place.handle().value();
    drag(place, away(place));
    QCOMPARE(steps(), 1);
    QVERIFY(place.handle().value() != before);
    const TreeParameters after = parameters();
    QVERIFY(after != TreeParameters());
    m_document->undoStack().undo();
    QCOMPARE(parameters(), TreeParameters());
    QCOMPARE(place.handle().value(), before);
    m_document->undoStack().redo();
    QCOMPARE(parameters(), after);
}

void ArchitecturePanelTest::finger_dragsAHandleItTouchesBeside()
{
    const Place place = fetched();
    const QPoint by = away(place);
    // Touches are told by where they are on the screen, and that of the tests is small.
    m_panel->fit({780, 1000});
    m_panel->findChild<QScrollArea*>()->ensureWidgetVisible(place.diagram);
    // Fingers are thick: beside the handle, on the side where no other is.
    const QPoint from = place.point() + QPoint(by.x() < 0 ? 13 : 0, by.x() < 0 ? 0 : -13);
    QTest::touchEvent(place.diagram, m_screen).press(1, from, place.diagram);
    for (int i = 1; i <= 5; ++i)
        QTest::touchEvent(place.diagram, m_screen).move(1, from + by * i / 5, place.diagram);
    QCOMPARE(steps(), 0);
    QTest::touchEvent(place.diagram, m_screen).release(1, from + by, place.diagram);
    QCOMPARE(steps(), 1);
    // As far as the mouse would have dragged it, for the handle does not jump to the finger.
    const TreeParameters touched = parameters();
    m_document->undoStack().undo();
    drag(place, by);
    QCOMPARE(parameters(), touched);
}

void ArchitecturePanelTest::escape_takesADragBack()
{
    const Place place = fetched();
    const double before = place.handle().value();
    const QPointF was = place.point();
    drag(place, away(place), false);
    QVERIFY(place.handle().value() != before);
    QTest::keyClick(&place.handle(), Qt::Key_Escape);
    QCOMPARE(place.handle().value(), before);
    QCOMPARE(QPointF(place.point()), was);
    // What the hand does until it lets go counts for nothing.
    QTest::mouseMove(place.diagram, place.point() + QPoint(30, 30));
    QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, place.point() + QPoint(30, 30));
    QCOMPARE(parameters(), TreeParameters());
    QCOMPARE(steps(), 0);
}

void ArchitecturePanelTest::doubleClick_bringsTheDefaultBack()
{
    const Place place = fetched();
    drag(place, away(place));
    QVERIFY(parameters() != TreeParameters());
    const TreeParameters moved = parameters();
    QTest::mouseClick(place.diagram, Qt::LeftButton, {}, place.point());
    QTest::mouseDClick(place.diagram, Qt::LeftButton, {}, place.point());
    QCOMPARE(parameters(), TreeParameters());
    QCOMPARE(steps(), 2);
    m_document->undoStack().undo();
    QCOMPARE(parameters(), moved);
}

void ArchitecturePanelTest::arrows_moveAHandleAsTheyPoint()
{
    const Place place = fetched();
    const struct {
        Qt::Key key;
        QPointF direction;
    } arrows[] = {
        {Qt::Key_Left, {-1, 0}}, {Qt::Key_Right, {1, 0}}, {Qt::Key_Up, {0, -1}}, {Qt::Key_Down, {0, 1}}};
    int moves = 0;
    for (const auto& [key, direction] : arrows) {
        double ways[2];
        for (const bool isFine : {false, true}) {
            const QPointF before = place.diagram->handlePlace(place.number);
            const double value = place.handle().value();
            QTest::keyClick(&place.handle(), key, isFine ? Qt::ShiftModifier : Qt::NoModifier);
            ways[isFine] = std::abs(place.handle().value() - value);
            if (ways[isFine] == 0.0)
                continue;
            ++moves;
            // The drawing of the cone fits itself to what it shows, so that its handles need not move.
            if (!qobject_cast<PerceptionDiagram*>(place.diagram)) {
                const QPointF way = place.diagram->handlePlace(place.number) - before;
                QVERIFY(QPointF::dotProduct(way, direction) > 0.0);
            }
        }
        QVERIFY(ways[1] <= ways[0]);
    }
    QVERIFY(moves >= 4);
    // They follow each other closely: one gesture.
    QCOMPARE(steps(), parameters() == TreeParameters() ? 0 : 1);

    const double value = place.handle().value();
    QTest::keyClick(&place.handle(), Qt::Key_Plus);
    QVERIFY(place.handle().value() > value);
    QTest::keyClick(&place.handle(), Qt::Key_Home);
    QVERIFY(place.handle().value() < value);
    QTest::keyClick(&place.handle(), Qt::Key_Delete);
    QCOMPARE(parameters(), TreeParameters());
}

void ArchitecturePanelTest::handle_andParameterFollowFromEachOther()
{
    const Place place = fetched();
    const QString key = place.handle().objectName();
    const std::map<QString, double> wanted{
        {QStringLiteral("growth.setPointAngle"), 100.0}, {QStringLiteral("growth.ellipseVertical"), 1.2},
        {QStringLiteral("growth.ellipseParallel"), 0.6}, {QStringLiteral("growth.ellipseOffset"), 0.2},
        {QStringLiteral("growth.branchingAngle"), 95.0}, {QStringLiteral("growth.deflectionAngle"), 30.0},
        {QStringLiteral("growth.axisWeight"), 0.2},      {QStringLiteral("growth.occupancyRadius"), 1.5},
        {QStringLiteral("growth.perceptionDepth"), 2.5}, {QStringLiteral("growth.perceptionAngle"), 140.0}};
    const double value = wanted.at(key);
    const QPointF from = place.diagram->handlePlace(place.number);
    QPointF to;
    if (const auto* cone = qobject_cast<PerceptionDiagram*>(place.diagram)) {
        // Its drawing fits what it shows, but not while a handle is dragged: there r = 2, d = 3.5.
        const double reach = 5.5 * cone->unit();
        if (key == QStringLiteral("growth.occupancyRadius"))
            to = cone->bud() - QPointF(value * cone->unit(), 0.0);
        else if (key == QStringLiteral("growth.perceptionDepth"))
            to = cone->bud() - QPointF(0.0, (2.0 + value) * cone->unit());
        else
            to = cone->bud() + reach * QPointF(std::sin(radians(70)), -std::cos(radians(70)));
    } else {
        place.handle().setValue(value);
        to = place.diagram->handlePlace(place.number);
        m_document->undoStack().undo();
    }
    QVERIFY(QLineF(from, to).length() > 8.0);
    drag(place, (to - from).toPoint(), false);
    // But for a pixel's rounding, and for the digits that are shown.
    const QPointF reached = place.diagram->handlePlace(place.number);
    QVERIFY2(QLineF(reached, to).length() < 1.6, qPrintable(QString::number(QLineF(reached, to).length())));
    QVERIFY2(std::abs(place.handle().value() - value) < std::max(0.04, 0.015 * value),
             qPrintable(QString::number(place.handle().value())));
}

void ArchitecturePanelTest::screenReader_readsAndSetsHandles()
{
    const Place place = fetched();
    QAccessibleInterface* read = QAccessible::queryAccessibleInterface(&place.handle());
    QVERIFY(read && read->isValid());
    QCOMPARE(read->role(), QAccessible::Slider);
    QVERIFY(!read->text(QAccessible::Name).isEmpty());
    QVERIFY(!read->text(QAccessible::Description).isEmpty());
    QCOMPARE(read->text(QAccessible::Value), place.handle().valueText());
    QVERIFY(read->state().focusable && !read->state().invisible);

    QAccessibleValueInterface* value = read->valueInterface();
    QVERIFY(value);
    QCOMPARE(value->currentValue().toDouble(), place.handle().value());
    const double low = value->minimumValue().toDouble();
    const double high = value->maximumValue().toDouble();
    QVERIFY(low < high && value->minimumStepSize().toDouble() > 0.0);
    const QString before = read->text(QAccessible::Value);
    const double middle = place.handle().objectName() == QStringLiteral("growth.ellipseOffset")
                              ? 0.5
                              : place.handle().scale().rounded((low + high) / 2.0 + 0.05 * (high - low));
    value->setCurrentValue(middle);
    QVERIFY(std::abs(value->currentValue().toDouble() - middle) < 1e-9);
    QVERIFY(read->text(QAccessible::Value) != before);
    QCOMPARE(steps(), 1);
}

void ArchitecturePanelTest::typedNumber_movesTheHandle()
{
    const Place place = fetched();
    for (const char* key : place.handle().keys()) {
        const QPointF before = place.diagram->handlePlace(place.number);
        const int stepsBefore = steps();
        ParameterNumber& number = m_panel->field(key)->number();
        QVERIFY(!number.accessibleName().isEmpty());
        const double wanted = number.value() < 1.0 ? 0.7 : number.value() * 1.5;
        QTest::mouseClick(&number, Qt::LeftButton);
        QTest::qWait(1);
        QTest::keyClicks(&number, QString::number(wanted));
        QTest::keyClick(&number, Qt::Key_Return);
        QVERIFY(std::abs(place.diagram->isAncestorOf(&number) ? 0.0 : number.value() - wanted) < 0.51);
        QCOMPARE(steps(), stepsBefore + 1);
        if (!qobject_cast<PerceptionDiagram*>(place.diagram))
            QVERIFY(place.diagram->handlePlace(place.number) != before);
        QCOMPARE(number.value(), m_panel->field(key)->number().value());
    }
}

void ArchitecturePanelTest::press_thatTrembles_changesNothing()
{
    Diagram* diagram = m_panel->diagrams().front();
    const QPoint at = diagram->handlePlace(0).toPoint();
    QTest::mousePress(diagram, Qt::LeftButton, {}, at + QPoint(6, 0));
    QTest::mouseMove(diagram, at + QPoint(7, 1));
    QTest::mouseRelease(diagram, Qt::LeftButton, {}, at + QPoint(7, 1));
    QCOMPARE(steps(), 0);
    QCOMPARE(parameters(), TreeParameters());
}

void ArchitecturePanelTest::growth_isPutInForceWhenTheDragEnds()
{
    const Place place{m_panel->diagrams().front(), 0};
    drag(place, {-20, 30}, false);
    QCOMPARE(parameters(), TreeParameters());
    QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, place.point());
    QVERIFY(parameters() != TreeParameters());
}

void ArchitecturePanelTest::disabled_dropsTheDrag()
{
    // A stroke with another hand begins.
    const Place place{m_panel->diagrams().front(), 0};
    const double before = place.handle().value();
    drag(place, {-20, 30}, false);
    m_panel->setEnabled(false);
    QCOMPARE(place.handle().value(), before);
    m_panel->setEnabled(true);
    QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, place.point());
    QCOMPARE(steps(), 0);
}

void ArchitecturePanelTest::undoDuringADrag_endsIt()
{
    const Place place{m_panel->diagrams().front(), 0};
    drag(place, {-20, 30});
    drag(place, {10, 20}, false);
    m_document->undoStack().undo();
    QCOMPARE(parameters(), TreeParameters());
    QTest::mouseMove(place.diagram, QPoint(20, 20));
    QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, QPoint(20, 20));
    QCOMPARE(parameters(), TreeParameters());

    auto* slider = m_panel->row("growth.shedding")->findChild<QSlider*>();
    const QPoint left(4, slider->height() / 2);
    QTest::mouseClick(slider, Qt::LeftButton, {}, left);
    QTest::mousePress(slider, Qt::LeftButton, {}, left);
    QTest::mouseMove(slider, left + QPoint(60, 0));
    m_document->undoStack().undo();
    QTest::mouseMove(slider, left + QPoint(90, 0));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, left + QPoint(90, 0));
    QCOMPARE(parameters(), TreeParameters());
}

void ArchitecturePanelTest::screenReader_readsAndSetsSlidersInTheirUnits()
{
    for (const char* key : {"growth.phyllotaxis", "growth.apicalDominance", "growth.internodeLength"}) {
        ParameterRow* row = m_panel->row(key);
        QAccessibleInterface* read = QAccessible::queryAccessibleInterface(row->findChild<QSlider*>());
        QVERIFY(read && read->valueInterface());
        QCOMPARE(read->role(), QAccessible::Slider);
        QCOMPARE(read->text(QAccessible::Name), row->accessibleName());
        QCOMPARE(read->valueInterface()->currentValue().toDouble(), row->value());
        const QString before = read->text(QAccessible::Value);
        QVERIFY2(before.contains(QLatin1Char('5')) || before.contains(QLatin1Char('1')), qPrintable(before));
        read->valueInterface()->setCurrentValue(0.25);
        QVERIFY(std::abs(row->value() - 0.25) < 0.06);
        QVERIFY(read->text(QAccessible::Value) != before);
    }
    QCOMPARE(steps(), 3);
}

void ArchitecturePanelTest::tab_goesFromHandleToHandle()
{
    m_panel->fit({780, 1000});
    std::vector<QWidget*> expected;
    for (const Diagram* diagram : m_panel->diagrams()) {
        for (int i = 0; i < diagram->handleCount(); ++i)
            expected.push_back(&diagram->handle(i));
    }
    expected.front()->setFocus(Qt::TabFocusReason);
    std::vector<QWidget*> reached{QApplication::focusWidget()};
    for (int i = 0; i < 60 && reached.size() < expected.size(); ++i) {
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
        if (qobject_cast<DiagramHandle*>(QApplication::focusWidget()))
            reached.push_back(QApplication::focusWidget());
        // What has the focus is scrolled into sight.
        QVERIFY(!QApplication::focusWidget()->visibleRegion().isEmpty());
    }
    QCOMPARE(reached, expected);
}

void ArchitecturePanelTest::doubleClickBesideTheHandles_resetsTheDiagram()
{
    auto* ellipse = m_panel->findChild<GravimorphismDiagram*>();
    drag({ellipse, 0}, {0, -10});
    drag({ellipse, 1}, {-15, 0});
    QCOMPARE(steps(), 2);
    QTest::mouseClick(ellipse, Qt::LeftButton, {}, {3, 3});
    QTest::mouseDClick(ellipse, Qt::LeftButton, {}, {3, 3});
    QCOMPARE(parameters(), TreeParameters());
    QCOMPARE(steps(), 3);
}

void ArchitecturePanelTest::schematic_isRedrawnWhileAHandleMoves()
{
    TropismDiagram& diagram = m_panel->schematic();
    const auto picture = [&] { return diagram.grab().toImage(); };
    QImage before = picture();
    // The sides of a level branch are outside the plane: s_p shows in the ellipse alone.
    for (const char* key : {"growth.setPointAngle", "growth.ellipseVertical", "growth.ellipseOffset",
                            "growth.branchingAngle", "growth.deflectionAngle", "growth.axisWeight",
                            "growth.occupancyRadius", "growth.perceptionDepth", "growth.perceptionAngle"}) {
        for (Diagram* one : m_panel->diagrams()) {
            for (int i = 0; i < one->handleCount(); ++i) {
                const Place place{one, i};
                if (std::strcmp(place.handle().keys().front(), key) != 0)
                    continue;
                const Tree tree = diagram.schematic().tree;
                drag(place, away(place), false);
                QVERIFY2(!(diagram.schematic().tree == tree), key);
                const QImage after = picture();
                QVERIFY2(after != before, key);
                before = after;
                QTest::mouseRelease(place.diagram, Qt::LeftButton, {}, place.point());
            }
        }
    }
    for (const char* key : {"growth.apicalDominance", "growth.lightSensitivity", "growth.shedding",
                            "growth.maxShootLength", "growth.phyllotaxis"}) {
        auto* slider = m_panel->row(key)->findChild<QSlider*>();
        QTest::mousePress(slider, Qt::LeftButton, {}, QPoint(slider->width() - 5, slider->height() / 2));
        const QImage after = picture();
        QVERIFY2(after != before, key);
        QTest::keyClick(slider, Qt::Key_Escape);
        QTest::mouseRelease(slider, Qt::LeftButton, {}, QPoint(slider->width() - 5, slider->height() / 2));
        QVERIFY2(picture() == before, key);
    }
}

void ArchitecturePanelTest::barycentricWeights_areAWholeEverywhere()
{
    const std::array<QPointF, 3> corners{QPointF(50, 0), QPointF(0, 80), QPointF(100, 80)};
    for (int x = -60; x <= 160; x += 7) {
        for (int y = -60; y <= 140; y += 7) {
            const auto weights = barycentricWeights(corners, QPointF(x, y));
            double sum = 0.0;
            QPointF point;
            for (std::size_t i = 0; i < 3; ++i) {
                QVERIFY(weights[i] >= 0.0);
                sum += weights[i];
                point += weights[i] * corners[i];
            }
            QVERIFY(std::abs(sum - 1.0) < 1e-12);
            // Inside, the very point; outside, no corner is nearer.
            const auto away = [&](const QPointF& to) { return std::hypot(to.x() - x, to.y() - y); };
            if (y >= 0 && y <= 80 && std::abs(x - 50) <= 50.0 * y / 80.0)
                QVERIFY(away(point) < 1e-9);
            else
                QVERIFY(std::ranges::all_of(
                    corners, [&](const QPointF& corner) { return away(point) <= away(corner) + 1e-9; }));
        }
    }
}

void ArchitecturePanelTest::triangle_sharesAWholeUnderAnyPull()
{
    auto* triangle = m_panel->findChild<DirectionDiagram*>();
    const Place place{triangle, 0};
    for (const QPointF& corner : triangle->corners()) {
        drag(place, (corner - triangle->handlePlace(0)).toPoint() * 2);
        const GrowthParameters& growth = parameters().growth;
        const double weights[] = {growth.axisWeight, growth.tropismWeight, growth.spaceWeight};
        QVERIFY(std::ranges::min(weights) >= 0.0);
        QVERIFY(std::abs(weights[0] + weights[1] + weights[2] - 1.0) < 1e-12);
        QVERIFY((triangle->handlePlace(0) - corner).manhattanLength() < 2.0);
    }
}

void ArchitecturePanelTest::ellipse_isDrawnByTheModelsRays()
{
    auto* ellipse = m_panel->findChild<GravimorphismDiagram*>();
    drag({ellipse, 2}, {0, -17});
    drag({ellipse, 1}, {9, 0});
    const GrowthParameters& growth = parameters().growth;
    QVERIFY(growth.ellipseOffset > 0.2 && growth.ellipseParallel > 1.1);
    const GravimorphismEllipse model{growth.ellipseVertical, growth.ellipseParallel, growth.ellipseOffset};
    for (double chi = 0.0; chi < 6.3; chi += 0.3) {
        const QPointF ray = ellipse->rayEnd(chi) - ellipse->axis();
        QVERIFY(std::abs(std::hypot(ray.x(), ray.y()) / ellipse->unit() - ellipseDistance(model, chi)) <
                1e-9);
    }
    // The top handle is where the ray to the bud above ends, whatever the handles were pulled to.
    QVERIFY((ellipse->handlePlace(0) - ellipse->rayEnd(0.0)).manhattanLength() < 1e-6);
}

void ArchitecturePanelTest::ellipse_containsTheAxisUnderAnyPull()
{
    auto* ellipse = m_panel->findChild<GravimorphismDiagram*>();
    const auto contained = [&] {
        const GrowthParameters& growth = parameters().growth;
        return std::abs(growth.ellipseOffset) <= 0.951 * growth.ellipseVertical;
    };
    drag({ellipse, 2}, {0, -200});
    QVERIFY(parameters().growth.ellipseOffset > 0.9 && contained());
    drag({ellipse, 0}, {0, 40});
    QVERIFY(parameters().growth.ellipseVertical < 0.8 && contained());
    drag({ellipse, 2}, {0, 200});
    QVERIFY(parameters().growth.ellipseOffset < -0.3 && contained());
    drag({ellipse, 0}, {0, -300});
    QVERIFY(parameters().growth.ellipseVertical > 2.0 && contained());
}

void ArchitecturePanelTest::cone_growsBeyondItsCard()
{
    auto* cone = m_panel->findChild<PerceptionDiagram*>();
    drag({cone, 1}, {0, -90});
    QCOMPARE(parameters().growth.perceptionDepth, 10.0);
    // It fits again afterwards.
    for (int i = 0; i < cone->handleCount(); ++i)
        QVERIFY(QRectF(cone->rect()).contains(cone->handlePlace(i)));
    drag({cone, 2}, {-30, 200});
    QVERIFY(parameters().growth.perceptionAngle > radians(300));
    for (int i = 0; i < cone->handleCount(); ++i)
        QVERIFY(QRectF(cone->rect()).contains(cone->handlePlace(i)));
}

void ArchitecturePanelTest::rows_slidersSwitchesAndMore()
{
    auto* slider = m_panel->row("growth.apicalDominance")->findChild<QSlider*>();
    const QPoint end(slider->width() - 2, slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, end);
    QCOMPARE(parameters(), TreeParameters());
    QTest::mouseRelease(slider, Qt::LeftButton, {}, end);
    QVERIFY(parameters().growth.apicalDominance > 0.9);
    QCOMPARE(steps(), 1);

    m_panel->row("growth.uprightTrunk")->findChild<QAbstractButton*>()->click();
    QCOMPARE(m_panel->row("growth.uprightTrunk")->value(), 1.0);
    QVERIFY(parameters().growth.uprightTrunk);
    QCOMPARE(steps(), 2);

    QVERIFY(!m_panel->row("growth.internodeLength")->isVisible());
    QTest::mouseClick(m_panel->findChild<QAbstractButton*>(QStringLiteral("moreGrowth")), Qt::LeftButton);
    QVERIFY(m_panel->isMoreShown() && m_panel->row("growth.internodeLength")->isVisible());
}

void ArchitecturePanelTest::panel_fitsWindows()
{
    for (const QSize& room : {QSize(908, 650), QSize(1490, 950), QSize(3740, 2110)}) {
        m_panel->fit(room);
        QVERIFY(m_panel->width() <= room.width());
        // Most of the tree stays in sight.
        QVERIFY2(m_panel->height() < 0.42 * room.height(), qPrintable(QString::number(m_panel->height())));
        for (const Diagram* diagram : m_panel->diagrams()) {
            QVERIFY(diagram->height() >= 130 && diagram->width() >= 150);
            for (int i = 0; i < diagram->handleCount(); ++i)
                QVERIFY(QRectF(diagram->rect()).contains(diagram->handlePlace(i)));
        }
    }
}

static const test::TestClass<ArchitecturePanelTest> architecturePanelTest;

#include "ArchitecturePanelTest.moc"
