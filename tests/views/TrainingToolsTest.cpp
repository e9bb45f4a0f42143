// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"
#include "tests/support/ViewportFixture.h"
#include "views/tools/PruneTool.h"
#include "views/tools/SelectBudTool.h"

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
    void doubleTap_prunesWithTheBrushInHand();
    void longPressOnABud_letsItAloneGrow();
    void altClickOnABud_letsItAloneGrow();
    void budTap_letsItAloneGrow();
    void stripFinger_windsTheTrunk();

private:
    /// A trunk of eight internodes, and a branch of three from its fifth; the branch's first.
    InternodeId plantBranch();
};

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
    m_view->setTool(std::make_unique<SelectBudTool>(m_view->toolContext()));
    const BudRef bud{8, kTerminalSlot};
    const QPoint place = at(budPosition(m_document->tree(), m_document->index(), bud, 0.0F));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QVERIFY(m_document->competitors() == (Competitors{bud.node, bud.slot}));
    sendPen(QEvent::TabletPress, {30.0, 30.0}, 0.5);
    sendPen(QEvent::TabletRelease, {30.0, 30.0}, 0.0);
    QVERIFY(m_document->competitors().areAll());
    QCOMPARE(m_document->undoStack().count(), 0);
}

void TrainingToolsTest::stripFinger_windsTheTrunk()
{
    m_settings->set(&ViewValues::brushRadius, 0.0);
    const int bottom = m_view->height() - Viewport::kStripHeight / 2;
    const float azimuth = m_view->camera().azimuth();
    const QPoint start = at({0.3F, 0.3F, 0.0F});
    const auto touch = [&] { return QTest::touchEvent(m_view.get(), m_touch.get()); };
    touch().press(0, {100, bottom}).press(1, start);
    for (int i = 1; i <= 30; ++i) {
        touch().move(0, {100 + 10 * i, bottom}).move(1, start - QPoint(0, 4 * i));
        QTest::qWait(25);
    }
    touch().release(0, {400, bottom}).release(1, start - QPoint(0, 120));
    QVERIFY(std::abs(m_view->camera().azimuth() - azimuth) > 1.0F);
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
