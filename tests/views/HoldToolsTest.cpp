// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"
#include "tests/support/ViewportFixture.h"
#include "views/tools/InvigorateTool.h"
#include "views/tools/ReduceTool.h"

using namespace espalier;
using namespace espalier::test;

/// Branches that are invigorated and reduced: by mouse, by finger and by pen.
class HoldToolsTest : public ViewportFixture {
    Q_OBJECT

private Q_SLOTS:
    void heldMouse_growsTheBranchWhileItIsDown();
    void heldMouse_reducesTheBranch();
    void heldFinger_growsTheBranch();
    void heldPen_reducesTheBranch();
    void tap_isTheShortestHold();
    void escape_leavesTheTreeAlone();
    void pressBesideTheTree_doesNothing();
    void rings_showTheTimeHeld();

private:
    /// Grows a tree, shows it, and returns an internode of its trunk.
    InternodeId plant();
    Vec3 middleOf(InternodeId id) const
    {
        return 0.5F * (m_document->index().basePosition(m_document->tree(), id) +
                       m_document->index().nodePosition(id));
    }
};

InternodeId HoldToolsTest::plant()
{
    grow(*m_document, 5);
    m_document->undoStack().clear();
    m_view->frameAll();
    return m_document->index().mainChild(m_document->index().mainChild(0));
}

void HoldToolsTest::heldMouse_growsTheBranchWhileItIsDown()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<InvigorateTool>(m_view->toolContext()));
    const DocumentState before(*m_document);
    const Vec3 place = middleOf(branch);
    press(place);
    QVERIFY(m_view->isGestureActive());
    QTRY_VERIFY(alive() > before.tree.size() + 5); // while the button is down
    const std::uint32_t some = alive();
    QTRY_VERIFY(alive() > some + 5);
    release(place);
    QVERIFY(!m_view->isGestureActive());
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(replayFault(*m_document), QString());
    m_document->undo();
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void HoldToolsTest::heldMouse_reducesTheBranch()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<ReduceTool>(m_view->toolContext()));
    const DocumentState before(*m_document);
    const std::uint32_t living = alive();
    const Vec3 place = middleOf(branch);
    press(place);
    QTRY_VERIFY(alive() < living);
    QTRY_COMPARE(m_document->index().subtreeSize(branch), 1U);
    QTest::qWait(150); // nothing is left to go
    release(place);
    QVERIFY(m_document->tree().isAlive(branch));
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(replayFault(*m_document), QString());
    m_document->undo();
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void HoldToolsTest::heldFinger_growsTheBranch()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<InvigorateTool>(m_view->toolContext()));
    const std::uint32_t living = alive();
    const QPoint place = at(middleOf(branch));
    QTest::touchEvent(m_view.get(), m_touch.get()).press(0, place);
    QTRY_VERIFY(alive() > living + 5);
    QTest::touchEvent(m_view.get(), m_touch.get()).release(0, place);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void HoldToolsTest::heldPen_reducesTheBranch()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<ReduceTool>(m_view->toolContext()));
    const std::uint32_t living = alive();
    const QPointF place = at(middleOf(branch));
    sendPen(QEvent::TabletPress, place, 0.5);
    QTRY_VERIFY(alive() < living);
    sendPen(QEvent::TabletRelease, place, 0.0);
    QCOMPARE(m_document->undoStack().count(), 1);
}

void HoldToolsTest::tap_isTheShortestHold()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<ReduceTool>(m_view->toolContext()));
    const std::uint32_t living = alive();
    QTest::mouseClick(m_view.get(), Qt::LeftButton, {}, at(middleOf(branch)));
    QVERIFY(alive() < living);
    QCOMPARE(m_document->undoStack().count(), 1);
    QCOMPARE(m_document->journal().size(), std::size_t{6});
}

void HoldToolsTest::escape_leavesTheTreeAlone()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<InvigorateTool>(m_view->toolContext()));
    const DocumentState before(*m_document);
    const Vec3 place = middleOf(branch);
    press(place);
    QTRY_VERIFY(alive() > before.tree.size());
    QTest::keyClick(m_view.get(), Qt::Key_Escape);
    QCOMPARE(differenceFrom(before, *m_document), QString());
    release(place);
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void HoldToolsTest::pressBesideTheTree_doesNothing()
{
    plant();
    m_view->setTool(std::make_unique<InvigorateTool>(m_view->toolContext()));
    const DocumentState before(*m_document);
    QTest::mousePress(m_view.get(), Qt::LeftButton, {}, QPoint(8, 8));
    QTest::qWait(150);
    QTest::mouseRelease(m_view.get(), Qt::LeftButton, {}, QPoint(8, 8));
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void HoldToolsTest::rings_showTheTimeHeld()
{
    const InternodeId branch = plant();
    m_view->setTool(std::make_unique<InvigorateTool>(m_view->toolContext()));
    const auto rings = [this] {
        Overlay overlay;
        m_view->tool().paint(overlay);
        return overlay.lines().size();
    };
    QCOMPARE(rings(), std::size_t{0});
    const Vec3 place = middleOf(branch);
    QTest::mouseMove(m_view.get(), at(place));
    QCOMPARE(rings(), std::size_t{1});
    press(place);
    QTRY_COMPARE(rings(), std::size_t{4});
    release(place);
}

static const TestClass<HoldToolsTest> holdToolsTest;

#include "HoldToolsTest.moc"
