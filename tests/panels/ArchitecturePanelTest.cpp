// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Gravimorphism.h"
#include "model/growth/VigourSpecies.h"
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
#include "tests/panels/ArchitectureFixture.h"
#include "tests/support/TestClasses.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QAccessibleInterface>
#include <QApplication>
#include <QComboBox>
#include <QImage>
#include <QLatin1Char>
#include <QPoint>
#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <QWidget>

#include <map>
#include <numbers>

using namespace espalier;

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

/// The panel of architecture: its controls, and what its drawings show.
class ArchitecturePanelTest : public test::ArchitectureFixture {
    Q_OBJECT

private Q_SLOTS:
    void everyParameterOfGrowth_hasAControlThatShowsIt();
    void everyControl_explainsItself();
    void screenReader_readsAndSetsSlidersInTheirUnits();
    void tab_goesFromHandleToHandle();
    void more_keepsTheSchematicTreeInView();
    void doubleClickBesideTheHandles_resetsTheDiagram();
    void schematic_isRedrawnWhileAHandleMoves();
    void barycentricWeights_areAWholeEverywhere();
    void triangle_sharesAWholeUnderAnyPull();
    void ellipse_isDrawnByTheModelsRays();
    void ellipse_containsTheAxisUnderAnyPull();
    void cone_growsBeyondItsCard();
    void rows_slidersSwitchesAndMore();
    void panel_fitsWindows();
    void model_choosesTheControls();
    void species_isOneUndoStep();
};

void ArchitecturePanelTest::everyParameterOfGrowth_hasAControlThatShowsIt()
{
    int shown = 0;
    visitParameters(parameters(), [&](const ParameterInfo& info, const auto& field) {
        const std::string_view key(info.key);
        if (!(key.starts_with("growth.") || key.starts_with("vigour.")) ||
            sheetOf(info.key) != ParameterSheet::Architecture)
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
    QCOMPARE(shown, 27 + 20);
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
        // The widget with the focus is scrolled into view.
        QVERIFY(!QApplication::focusWidget()->visibleRegion().isEmpty());
    }
    QCOMPARE(reached, expected);
}

void ArchitecturePanelTest::more_keepsTheSchematicTreeInView()
{
    const QSize room(1340, 1000); // Of a window of 1600 px
    m_panel->fit(room);
    connect(m_panel.get(), &ArchitecturePanel::sizeWanted, m_panel.get(), [&] { m_panel->fit(room); });
    auto* more = m_panel->findChild<QToolButton*>(QStringLiteral("moreGrowth"));
    QTest::mouseClick(more, Qt::LeftButton);
    QTest::qWait(50);
    const QWidget& schematic = m_panel->schematic();
    QCOMPARE(schematic.visibleRegion().boundingRect(), schematic.rect());
    for (const char* key : {"growth.internodeLength", "growth.occupancyRadius"}) {
        const ParameterRow* row = m_panel->row(key);
        if (row)
            QCOMPARE(row->visibleRegion().boundingRect(), row->rect());
    }
    QTest::mouseClick(more, Qt::LeftButton);
    QTest::qWait(50);
    for (const Diagram* diagram : m_panel->diagrams())
        QVERIFY(diagram->isVisible());
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
            // Inside, the point itself; outside, no corner is nearer.
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
    // The top handle is at the end of the ray to the bud above, after any drag of the handles.
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

void ArchitecturePanelTest::model_choosesTheControls()
{
    auto* model = m_panel->row("growth.model")->findChild<QComboBox*>();
    QVERIFY(model->isVisible());
    QVERIFY(m_panel->schematic().isVisible());
    QVERIFY(!m_panel->row("vigour.apicalControl")->isVisible() && !m_panel->species().isVisible());
    model->setFocus();
    QTest::keyClick(model, Qt::Key_Down);
    QCOMPARE(parameters().growth.model, GrowthModelKind::Vigour);
    QCOMPARE(steps(), 1);
    // The history names the choice, too.
    QCOMPARE(m_document->undoStack().undoText(), QStringLiteral("Growth model: Vigour"));
    QVERIFY(!m_panel->schematic().isVisible());
    visitParameters(parameters(), [this](const ParameterInfo& info, const auto&) {
        if (std::string_view(info.key).starts_with("vigour."))
            QVERIFY2(m_panel->row(info.key)->isVisible(), info.key);
    });
    QVERIFY(m_panel->species().isVisible());
    m_document->undo();
    QVERIFY(m_panel->schematic().isVisible() && !m_panel->species().isVisible());
}

void ArchitecturePanelTest::species_isOneUndoStep()
{
    TreeParameters vigorous;
    vigorous.growth.model = GrowthModelKind::Vigour;
    m_document->reset(1, vigorous);
    QComboBox& species = m_panel->species();
    QVERIFY(species.isVisible());
    const std::span<const VigourSpecies> all = vigourSpecies();
    QCOMPARE(species.count(), static_cast<int>(all.size()) + 1);
    species.setFocus();
    for (std::size_t i = 0; i < all.size(); ++i) {
        QTest::keyClick(&species, Qt::Key_Down);
        QCOMPARE(species.currentText(), QString::fromLatin1(all[i].name));
        QCOMPARE(parameters().vigour, all[i].parameters);
        QCOMPARE(parameters().growth, vigorous.growth);
        QCOMPARE(steps(), static_cast<int>(i) + 1);
    }
    m_document->undo();
    QCOMPARE(species.currentIndex(), static_cast<int>(all.size()) - 1);
    // Another value is none of the species.
    auto* slider = m_panel->row("vigour.apicalControl")->findChild<QSlider*>();
    QTest::mouseClick(slider, Qt::LeftButton, {}, QPoint(slider->width() - 2, slider->height() / 2));
    QCOMPARE(species.currentIndex(), 0);
}

static const test::TestClass<ArchitecturePanelTest> architecturePanelTest;

#include "ArchitecturePanelTest.moc"
