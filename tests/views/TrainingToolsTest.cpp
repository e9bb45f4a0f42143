// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/WidthGesture.h"
#include "model/shape/ClearWood.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"
#include "tests/support/ViewportFixture.h"
#include "views/tools/BrushTool.h"
#include "views/tools/PruneTool.h"
#include "views/tools/SelectBudTool.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace espalier;
using namespace espalier::test;

/// Pruning, choosing a bud and growing an existing tree: by mouse, by finger and by pen.
class TrainingToolsTest : public ViewportFixture {
    Q_OBJECT

private Q_SLOTS:
    void pruneTap_takesTheBranchOff();
    void pruneStroke_cutsWhatItCrosses();
    void pruneFinger_takesTheBranchOff();
    void pruneEscape_leavesTheTreeAlone();
    void eraserEnd_prunes();
    void pruneStroke_mayLeaveTheFarSide();
    void hover_showsWhatWouldBeTaken();
    void clearDrag_takesTheShootsBelowAndLetsNoneGrow();
    void clearTap_keepsClearUpToThere();
    void clearRing_draggedDownLetsBudsShoot();
    void clearEscape_leavesTheTreeAlone();
    void eraserStroke_takesTwigsInDepthAndLeavesTheTrunk();
    void eraserPreview_showsWhatGoesBeforeTheRelease();
    void eraserStroke_goesOnWhileTheCameraTurns();
    void eraserEscape_leavesTheTreeAlone();
    void eraserFinger_takesTwigs();
    void thinStroke_takesAShare();
    void brushSpread_turnsLimbsIntoTheWidestGap();
    void brushSymmetry_repeatsAStrokeAroundTheTrunk();
    void brushTrunkPlane_goesOnInTheLimbsOwnPlane();
    void doubleTap_prunesWithTheBrushInHand();
    void longPressOnABud_letsItAloneGrow();
    void altClickOnABud_letsItAloneGrow();
    void budTap_letsItAloneGrow();
    void stripFinger_windsTheTrunk();

private:
    /// A trunk of eight internodes, and a branch of three from its fifth; the branch's first.
    InternodeId plantBranch();
    /// A trunk of 0.05 m and 12 internodes, with a twig at each from the second on, by turns to the right,
    /// toward the viewer, to the left and away; the twig of internode i begins with twigAt(i).
    void plantTwigs();
    static InternodeId twigAt(InternodeId trunk) { return 13 + 2 * (trunk - 1); }
    Vec3 trunkAt(float height) const { return {0.0F, height, 0.0F}; }
    void takePruning(PruneMode mode);
    /// What the tool in hand paints.
    Overlay painted() const;
    /// The living branches on the trunk that begin below @p height, m.
    std::size_t shootsBelowHeight(float height) const
    {
        return shootsBelow(m_document->tree(), m_document->index(), 0, height).size();
    }
};

void TrainingToolsTest::plantTwigs()
{
    TreeParameters parameters = smallTree();
    parameters.widths.baseDiameter = 0.1;
    parameters.widths.tipDiameter = 0.004;
    m_document->reset(7, parameters);
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 12; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    for (InternodeId i = 1; i <= 12; ++i) {
        const Eigen::Quaternionf around(
            Eigen::AngleAxisf(-0.5F * std::numbers::pi_v<float> * static_cast<float>(i - 1), Vec3::UnitY()));
        const Eigen::Quaternionf out(Eigen::AngleAxisf(-1.3F, Vec3::UnitZ()));
        internodes.push_back(
            {.parent = i, .slot = 0, .rotation = Rotation((around * out).normalized()), .length = 0.2F});
        internodes.push_back({.parent = static_cast<InternodeId>(internodes.size()), .length = 0.2F});
    }
    apply(*m_document, births(m_document->tree(), internodes));
    m_document->undoStack().clear();
}

void TrainingToolsTest::takePruning(PruneMode mode)
{
    m_settings->set(&ViewValues::pruneMode, mode);
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
}

Overlay TrainingToolsTest::painted() const
{
    Overlay overlay;
    m_view->tool().paint(overlay);
    return overlay;
}

InternodeId TrainingToolsTest::plantBranch()
{
    std::vector<NewInternode> internodes;
    for (InternodeId i = 0; i < 8; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    internodes.push_back({.parent = 5, .slot = 0, .rotation = branching(radians(60)), .length = 0.2F});
    for (InternodeId i = 9; i < 11; ++i)
        internodes.push_back({.parent = i, .length = 0.2F});
    apply(*m_document, births(m_document->tree(), internodes));
    m_document->undoStack().clear();
    return 9;
}

void TrainingToolsTest::pruneTap_takesTheBranchOff()
{
    const InternodeId branch = plantBranch();
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
    const DocumentState before(*m_document);
    // In the middle of its second internode.
    const Vec3 place =
        0.5F * (m_document->index().nodePosition(branch) + m_document->index().nodePosition(branch + 1));
    QTest::mouseMove(m_view.get(), at(place));
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, at(place));
    QCOMPARE(alive(), 9U);
    QVERIFY(!m_document->tree().isAlive(branch));
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(indexFault(*m_document), QString());
    m_document->undoStack().undo();
    QCOMPARE(differenceFrom(before, *m_document), QString());
    // Beside the tree there is nothing to cut.
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, {20, 20});
    QCOMPARE(alive(), 12U);
}

void TrainingToolsTest::pruneStroke_cutsWhatItCrosses()
{
    const InternodeId branch = plantBranch();
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
    // Across the branch's third internode and the trunk's seventh.
    const auto middle = [&](InternodeId id) {
        return Vec3(0.5F * (m_document->index().nodePosition(m_document->tree().parent(id)) +
                            m_document->index().nodePosition(id)));
    };
    const Vec3 first = middle(7);
    const Vec3 second = middle(branch + 2);
    const Vec3 way = 0.3F * (second - first);
    stroke(first - way, second + way, 200);
    QVERIFY(!m_document->tree().isAlive(7));
    QVERIFY(!m_document->tree().isAlive(branch + 2));
    QVERIFY(m_document->tree().isAlive(6));
    QVERIFY(m_document->tree().isAlive(branch + 1));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::pruneFinger_takesTheBranchOff()
{
    const InternodeId branch = plantBranch();
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
    // A finger is not that precise.
    const QPoint place = at(m_document->index().nodePosition(branch + 1)) + QPoint(10, 0);
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QCOMPARE(alive(), 9U);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::pruneEscape_leavesTheTreeAlone()
{
    plantBranch();
    m_view->setTool(std::make_unique<PruneTool>(m_view->toolContext()));
    press({-0.5F, 1.0F, 0.0F});
    drag({-0.5F, 1.0F, 0.0F}, {0.5F, 1.0F, 0.0F}, 100);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    release({0.5F, 1.0F, 0.0F});
    QCOMPARE(alive(), 12U);
    QCOMPARE(m_document->undoStack().count(), 0);
}

void TrainingToolsTest::eraserEnd_prunes()
{
    const InternodeId branch = plantBranch();
    const QPointF place = at(m_document->index().nodePosition(branch));
    const auto eraser = QPointingDevice::PointerType::Eraser;
    sendPen(QEvent::TabletPress, place, 0.5, eraser);
    sendPen(QEvent::TabletRelease, place, 0.0, eraser);
    QCOMPARE(alive(), 9U);
    QCOMPARE(m_document->undoStack().count(), 1);
    // The pen's tip still brushes.
    sendPen(QEvent::TabletPress, place, 0.5);
    QVERIFY(m_view->isGestureActive());
    sendPen(QEvent::TabletRelease, place, 0.0);
}

void TrainingToolsTest::pruneStroke_mayLeaveTheFarSide()
{
    plantTwigs();
    takePruning(PruneMode::Cut);
    // Twigs 2, 6 and 10 come toward the viewer, 4, 8 and 12 go away; both kinds appear above their nodes.
    m_settings->set(&ViewValues::prunesThrough, false);
    const auto across = [&](InternodeId trunk) {
        const Vec3 place = 0.5F * (m_document->index().nodePosition(twigAt(trunk)) +
                                   m_document->index().nodePosition(twigAt(trunk) + 1));
        const QPoint middle = at(place);
        QTest::mousePress(m_view.get(), Qt::LeftButton, {}, middle - QPoint(15, 0));
        for (int x = -12; x <= 15; x += 3) {
            QMouseEvent event(QEvent::MouseMove, middle + QPoint(x, 0),
                              m_view->mapToGlobal(middle + QPoint(x, 0)), Qt::NoButton, Qt::LeftButton,
                              Qt::NoModifier);
            QCoreApplication::sendEvent(m_view.get(), &event);
        }
        QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, middle + QPoint(15, 0));
    };
    const InternodeId last = 12; // Above it there is no trunk that the stroke would cross.
    across(last);
    QVERIFY(m_document->tree().isAlive(twigAt(last) + 1));
    QCOMPARE(m_document->undoStack().count(), 0);
    m_settings->set(&ViewValues::prunesThrough, true);
    across(last);
    QVERIFY(!m_document->tree().isAlive(twigAt(last) + 1));
}

void TrainingToolsTest::hover_showsWhatWouldBeTaken()
{
    plantTwigs();
    const auto circlesAt = [&](const QPoint& place) {
        QTest::mouseMove(m_view.get(), place);
        return std::ranges::count_if(painted().lines(),
                                     [](const Overlay::Line& line) { return line.count > 20; });
    };
    const QPoint beside(20, 200);
    // Drawing determines the radius of the bark.
    m_view->grabFramebuffer();
    // The brush has a ring around the place where a stroke would begin.
    m_view->setTool(std::make_unique<BrushTool>(m_view->toolContext()));
    m_settings->set(&ViewValues::planeShown, false);
    const auto away = circlesAt(beside);
    QTRY_COMPARE(circlesAt(at(trunkAt(1.1F))), away + 1);
    QTRY_COMPARE(circlesAt(beside), away);
    // Pruning shows the branch that a tap would cut off.
    takePruning(PruneMode::Cut);
    const Vec3 twig = m_document->index().nodePosition(twigAt(1));
    QTest::mouseMove(m_view.get(), at(twig));
    const std::size_t shown = painted().lines().size();
    QTest::mouseMove(m_view.get(), beside);
    QVERIFY(painted().lines().size() < shown);
}

void TrainingToolsTest::clearDrag_takesTheShootsBelowAndLetsNoneGrow()
{
    plantTwigs();
    takePruning(PruneMode::KeepClear);
    const std::uint32_t before = alive();
    QCOMPARE(shootsBelowHeight(1.3F), std::size_t{5});
    press(trunkAt(0.1F));
    drag(trunkAt(0.1F), trunkAt(1.3F), 200);
    // What goes is shown, and nothing has gone yet.
    QCOMPARE(alive(), before);
    QVERIFY(std::ranges::any_of(painted().lines(), [](const Overlay::Line& line) { return line.isBroken; }));
    release(trunkAt(1.3F));
    QCOMPARE(alive(), before - 10);
    QCOMPARE(shootsBelowHeight(1.3F), std::size_t{0});
    QVERIFY(std::abs(m_document->tree().clearLength(0) - 1.3F) < 0.03F);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(indexFault(*m_document), QString());
    grow(*m_document, 4);
    QVERIFY(alive() > before - 10);
    QCOMPARE(shootsBelowHeight(1.25F), std::size_t{0});
    m_document->undoStack().undo();
    m_document->undoStack().undo();
    QCOMPARE(alive(), before);
    QCOMPARE(m_document->tree().clearLength(0), 0.0F);
}

void TrainingToolsTest::clearTap_keepsClearUpToThere()
{
    plantTwigs();
    takePruning(PruneMode::KeepClear);
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, at(trunkAt(0.9F)));
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, at(trunkAt(0.9F)));
    QVERIFY(std::abs(m_document->tree().clearLength(0) - 0.9F) < 0.03F);
    QCOMPARE(shootsBelowHeight(0.85F), std::size_t{0});
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::clearRing_draggedDownLetsBudsShoot()
{
    plantTwigs();
    takePruning(PruneMode::KeepClear);
    stroke(trunkAt(0.1F), trunkAt(1.3F), 100);
    QCOMPARE(m_document->tree().buds(2) & ~kTerminalBud, 0);
    stroke(trunkAt(1.3F), trunkAt(0.5F), 100);
    QVERIFY(std::abs(m_document->tree().clearLength(0) - 0.5F) < 0.03F);
    stroke(trunkAt(0.5F), trunkAt(-0.2F), 100);
    QVERIFY(m_document->tree().content().sparse.clearLength.cells().empty());
    QCOMPARE(m_document->undoStack().count(), 3);
}

void TrainingToolsTest::clearEscape_leavesTheTreeAlone()
{
    plantTwigs();
    takePruning(PruneMode::KeepClear);
    const DocumentState before(*m_document);
    press(trunkAt(0.1F));
    drag(trunkAt(0.1F), trunkAt(1.3F), 100);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    release(trunkAt(1.3F));
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void TrainingToolsTest::eraserStroke_takesTwigsInDepthAndLeavesTheTrunk()
{
    plantTwigs();
    m_settings->set(&ViewValues::brushRadius, 0.15);
    m_settings->set(&ViewValues::eraserThickest, 0.1);
    takePruning(PruneMode::Erase);
    stroke(trunkAt(0.7F), trunkAt(1.5F), 200);
    // All twigs from there, toward the viewer and away from him.
    for (InternodeId i = 3; i <= 6; ++i)
        QVERIFY(!m_document->tree().isAlive(twigAt(i)));
    QVERIFY(m_document->tree().isAlive(twigAt(1)));
    QVERIFY(m_document->tree().isAlive(twigAt(12)));
    for (InternodeId i = 1; i <= 12; ++i)
        QVERIFY(m_document->tree().isAlive(i));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::eraserPreview_showsWhatGoesBeforeTheRelease()
{
    plantTwigs();
    m_settings->set(&ViewValues::brushRadius, 0.15);
    m_settings->set(&ViewValues::eraserThickest, 0.1);
    takePruning(PruneMode::Erase);
    const auto shownPoints = [this] {
        std::size_t points = 0;
        const Overlay overlay = painted();
        for (const Overlay::Line& line : overlay.lines())
            points += line.isBroken ? line.count : 0;
        return points;
    };
    // The brush that hovers shows it as well.
    QTest::mouseMove(m_view.get(), at(trunkAt(1.0F)));
    const std::size_t hovered = shownPoints();
    QVERIFY(hovered > 0);
    press(trunkAt(1.0F));
    drag(trunkAt(1.0F), trunkAt(1.8F), 100);
    const std::size_t dragged = shownPoints();
    QVERIFY(dragged > hovered);
    const std::uint32_t before = alive();
    release(trunkAt(1.8F));
    QCOMPARE(2 * (before - alive()), dragged);
    // Beside the tree, it shows none.
    QTest::mouseMove(m_view.get(), {30, 30});
    QCOMPARE(shownPoints(), std::size_t{0});
}

void TrainingToolsTest::eraserStroke_goesOnWhileTheCameraTurns()
{
    plantTwigs();
    m_settings->set(&ViewValues::brushRadius, 0.1);
    m_settings->set(&ViewValues::eraserThickest, 0.1);
    takePruning(PruneMode::Erase);
    press(trunkAt(0.7F));
    drag(trunkAt(0.7F), trunkAt(0.9F), 60);
    Camera camera = m_view->mainCamera();
    camera.orbit(0.8F, 0.2F);
    m_view->setCamera(camera);
    drag(trunkAt(0.9F), trunkAt(1.5F), 100);
    release(trunkAt(1.5F));
    QVERIFY(!m_document->tree().isAlive(twigAt(4)));
    QVERIFY(!m_document->tree().isAlive(twigAt(6)));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::eraserEscape_leavesTheTreeAlone()
{
    plantTwigs();
    takePruning(PruneMode::Erase);
    const DocumentState before(*m_document);
    press(trunkAt(0.7F));
    drag(trunkAt(0.7F), trunkAt(1.5F), 100);
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    release(trunkAt(1.5F));
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void TrainingToolsTest::eraserFinger_takesTwigs()
{
    plantTwigs();
    m_settings->set(&ViewValues::brushRadius, 0.15);
    m_settings->set(&ViewValues::eraserThickest, 0.1);
    takePruning(PruneMode::Erase);
    const std::uint32_t before = alive();
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, at(trunkAt(0.7F)));
    QTest::touchEvent(m_view.get(), m_touch.get()).move(0, at(trunkAt(1.1F)));
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, at(trunkAt(1.5F)));
    QVERIFY(alive() < before);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::thinStroke_takesAShare()
{
    plantTwigs();
    m_settings->set(&ViewValues::brushRadius, 0.5);
    m_settings->set(&ViewValues::eraserThickest, 0.1);
    m_settings->set(&ViewValues::thinShare, 0.5);
    takePruning(PruneMode::Thin);
    stroke(trunkAt(0.2F), trunkAt(2.6F), 300);
    int left = 0;
    for (InternodeId i = 1; i <= 12; ++i) {
        left += m_document->tree().isAlive(twigAt(i)) ? 1 : 0;
        // A twig goes as a whole.
        QCOMPARE(m_document->tree().isAlive(twigAt(i)), m_document->tree().isAlive(twigAt(i) + 1));
    }
    QVERIFY2(left >= 5 && left <= 7, qPrintable(QString::number(left)));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::brushSpread_turnsLimbsIntoTheWidestGap()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    stroke(trunkAt(0.2F), trunkAt(2.6F), 600);
    m_settings->set(&ViewValues::brushPlane, BrushPlane::Spread);
    for (const float height : {0.9F, 1.3F, 1.7F, 2.1F})
        stroke(trunkAt(height), Vec3(1.4F, height + 0.4F, 0.0F), 400);
    QCOMPARE(m_document->undoStack().count(), 5);
    Box3 box;
    for (InternodeId id = 0; id < m_document->tree().size(); ++id)
        box.extend(m_document->index().nodePosition(id));
    // One to each side, the others toward the viewer or away.
    QVERIFY(box.min().x() < -0.9F);
    QVERIFY(box.max().x() > 0.9F);
    QVERIFY(box.sizes().z() > 1.2F);
}

void TrainingToolsTest::brushSymmetry_repeatsAStrokeAroundTheTrunk()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    stroke(trunkAt(0.2F), trunkAt(2.6F), 600);
    m_settings->set(&ViewValues::brushSymmetry, 3.0);
    stroke(trunkAt(1.3F), Vec3(1.4F, 1.7F, 0.0F), 400);
    QCOMPARE(m_document->undoStack().count(), 2);
    std::size_t limbs = 0;
    for (InternodeId id = 1; id < m_document->tree().size(); ++id)
        limbs += m_document->index().axis(id) == id ? 1 : 0;
    QCOMPARE(limbs, std::size_t{3});
    // They do not lie upon each other: each third of the circle has one.
    std::set<int> thirds;
    for (InternodeId id = 1; id < m_document->tree().size(); ++id) {
        const Vec3 node = m_document->index().nodePosition(id);
        if (std::hypot(node.x(), node.z()) > 1.0F)
            thirds.insert(static_cast<int>(
                std::lround(3.0F * std::atan2(node.z(), node.x()) / (2.0F * std::numbers::pi_v<float>))));
    }
    QCOMPARE(thirds.size(), std::size_t{3});
    m_document->undoStack().undo();
    QVERIFY(shootsBelowHeight(9.0F) == 0);
}

void TrainingToolsTest::brushTrunkPlane_goesOnInTheLimbsOwnPlane()
{
    // A limb toward the right and the back.
    plantBranch();
    const std::vector<NewInternode> limb{{.parent = 4,
                                          .slot = 1,
                                          .rotation = Rotation(Eigen::AngleAxisf(0.8F, Vec3::UnitY()) *
                                                               Eigen::AngleAxisf(-1.2F, Vec3::UnitZ())),
                                          .length = 0.6F}};
    apply(*m_document, births(m_document->tree(), limb));
    const InternodeId id = m_document->tree().size() - 1;
    const Vec3 tip = m_document->index().nodePosition(id);
    QVERIFY(tip.z() < -0.2F);
    m_settings->set(&ViewValues::brushRadius, 0.0);
    m_settings->set(&ViewValues::brushPlane, BrushPlane::Trunk);
    const QPoint from = at(tip);
    const QPoint to = from + QPoint(60, 0);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) {
        const QPoint place = from + (to - from) * i / 20;
        QMouseEvent event(QEvent::MouseMove, place, m_view->mapToGlobal(place), Qt::NoButton, Qt::LeftButton,
                          Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
        QTest::qWait(20);
    }
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, to);
    const Vec3 end = m_document->index().nodePosition(m_document->tree().size() - 1);
    QVERIFY(end.x() > tip.x() + 0.2F);
    // Away from the trunk, and not parallel to the screen.
    QVERIFY(std::abs(std::atan2(end.z(), end.x()) - std::atan2(tip.z(), tip.x())) < 0.06F);
}

void TrainingToolsTest::doubleTap_prunesWithTheBrushInHand()
{
    const InternodeId branch = plantBranch();
    const QPoint place =
        at(0.5F * (m_document->index().nodePosition(branch) + m_document->index().nodePosition(branch + 1)));
    // Drawing during the taps would make them long.
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 20000);
    for (int tap = 0; tap < 2; ++tap) {
        QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
        QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    }
    QVERIFY(!m_document->tree().isAlive(branch));
    QCOMPARE(alive(), 9U);
    QCOMPARE(m_document->undoStack().count(), 1);
    m_document->undoStack().undo();
    QCOMPARE(alive(), 12U);
    QTRY_VERIFY_WITH_TIMEOUT(m_view->isAtRest(), 20000);
    for (const QEvent::Type type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease,
                                    QEvent::MouseButtonDblClick, QEvent::MouseButtonRelease}) {
        const bool isPress = type != QEvent::MouseButtonRelease;
        QMouseEvent event(type, place, m_view->mapToGlobal(place), Qt::LeftButton,
                          isPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_view.get(), &event);
    }
    QVERIFY(!m_document->tree().isAlive(branch));
    QCOMPARE(m_document->undoStack().count(), 1);
}

void TrainingToolsTest::longPressOnABud_letsItAloneGrow()
{
    plantBranch();
    const BudRef bud{8, kTerminalSlot};
    const QPoint place = at(budPosition(m_document->tree(), m_document->index(), bud, 0.0F));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QVERIFY(m_document->competitors().areAll());
    QTRY_VERIFY(m_document->competitors() == (Competitors{bud.node, bud.slot}));
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QCOMPARE(m_document->undoStack().count(), 0);
    // A stroke from a bud is still a stroke.
    m_document->setCompetitors({});
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    for (int i = 1; i <= 20; ++i) {
        QTest::touchEvent(m_view.get(), m_touch.get()).move(0, place - QPoint(0, 3 * i));
        QTest::qWait(25);
    }
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place - QPoint(0, 60));
    QVERIFY(m_document->competitors().areAll());
    QCOMPARE(m_document->undoStack().count(), 1);
    QVERIFY(alive() > 12);
}

void TrainingToolsTest::altClickOnABud_letsItAloneGrow()
{
    plantBranch();
    const BudRef bud{2, 0};
    const Vec3 place = budPosition(m_document->tree(), m_document->index(), bud,
                                   m_view->toolContext().branchRadius(bud.node));
    QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::AltModifier, at(place));
    QVERIFY(m_document->competitors() == (Competitors{bud.node, bud.slot}));
    // New growth starts from it.
    const std::uint32_t rows = m_document->tree().size();
    m_settings->set(&ViewValues::brushRadius, 0.5);
    stroke(place, place + Vec3(0.8F, 0.0F, 0.0F), 600);
    QVERIFY(m_document->tree().size() > rows);
    for (InternodeId id = rows; id < m_document->tree().size(); ++id) {
        InternodeId base = id;
        while (m_document->tree().parent(base) >= rows)
            base = m_document->tree().parent(base);
        QCOMPARE(m_document->tree().parent(base), bud.node);
        QCOMPARE(int(m_document->tree().columns().slot[base]), bud.slot);
    }
    QTest::mouseClick(m_view.get(), Qt::LeftButton, Qt::AltModifier, {20, 20});
    QVERIFY(m_document->competitors().areAll());
}

void TrainingToolsTest::budTap_letsItAloneGrow()
{
    plantBranch();
    QString said;
    m_view->setTool(
        std::make_unique<SelectBudTool>(m_view->toolContext(), [&said](const QString& why) { said = why; }));
    const BudRef bud{8, kTerminalSlot};
    const QPoint place = at(budPosition(m_document->tree(), m_document->index(), bud, 0.0F));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QVERIFY(m_document->competitors() == (Competitors{bud.node, bud.slot}));
    sendPen(QEvent::TabletPress, {30.0, 30.0}, 0.5);
    sendPen(QEvent::TabletRelease, {30.0, 30.0}, 0.0);
    QVERIFY(m_document->competitors().areAll());
    QCOMPARE(m_document->undoStack().count(), 0);
    // That let all buds grow again. A tap that does nothing says why.
    QCOMPARE(said, QString());
    sendPen(QEvent::TabletPress, {30.0, 30.0}, 0.5);
    sendPen(QEvent::TabletRelease, {30.0, 30.0}, 0.0);
    QVERIFY(said.startsWith(QStringLiteral("There is no bud here.")));
    said.clear();
    // Where dots show.
    const QPoint beside = place + QPoint(0, -50);
    sendPen(QEvent::TabletPress, beside, 0.5);
    sendPen(QEvent::TabletRelease, beside, 0.0);
    QVERIFY(m_document->competitors().areAll());
    QVERIFY(!said.isEmpty());
    m_view->setTool(std::make_unique<BrushTool>(m_view->toolContext()));
}

void TrainingToolsTest::stripFinger_windsTheTrunk()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    const int bottom = m_view->height() - Viewport::kStripHeight / 2;
    const float azimuth = m_view->mainCamera().azimuth();
    const QPoint start = at({0.3F, 0.3F, 0.0F});
    const auto touch = [&] { return QTest::touchEvent(m_view.get(), m_touch.get()); };
    touch().press(0, {100, bottom}).press(1, start);
    for (int i = 1; i <= 30; ++i) {
        touch().move(0, {100 + 10 * i, bottom}).move(1, start - QPoint(0, 4 * i));
        QTest::qWait(25);
    }
    touch().release(0, {400, bottom}).release(1, start - QPoint(0, 120));
    QVERIFY(std::abs(m_view->mainCamera().azimuth() - azimuth) > 1.0F);
    QCOMPARE(m_document->undoStack().count(), 1);
    // The finger stayed 0.3 m right of the axis: the trunk goes around it.
    Box3 box;
    for (InternodeId id = 1; id < m_document->tree().size(); ++id)
        box.extend(m_document->index().nodePosition(id));
    QVERIFY(box.sizes().z() > 0.2F);
    QVERIFY(box.sizes().y() > 0.3F);
}

static const TestClass<TrainingToolsTest> trainingToolsTest;

#include "TrainingToolsTest.moc"
