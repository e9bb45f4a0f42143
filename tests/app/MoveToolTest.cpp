// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/InferDepth.h"
#include "commands/SketchStroke.h"
#include "model/sketch/FlatTree.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QTest>

using namespace espalier;

/// The user at the real window with the tool that moves branches.
class MoveToolTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void middle_slidesAlongTheWood();
    void middle_goesToTheOtherSideOfADrawing();
    void middle_goesAroundATreeWithDepth();
    void base_goesToOtherWood();
    void tip_scales();
    void finger_movesABranch();
    void trunk_staysWithASentence();
    void escape_bringsTheBranchBack();
    void tap_movesNothing();

private:
    const Tree& tree() { return m_window->document().tree(); }
    const TreeIndex& index() { return m_window->document().index(); }
    int steps() { return m_window->document().undoStack().count(); }
    /// A trunk, a branch to the right, which carries a twig, one to the left, and the tool in hand.
    void drawTree();
    /// The living branch whose tip is the farthest to the right; none is the trunk.
    InternodeId rightBranch();
    InternodeId tipOf(InternodeId branch)
    {
        while (index().mainChild(branch) != kNoInternode)
            branch = index().mainChild(branch);
        return branch;
    }
    void drag(const QPoint& from, const QPoint& to);
};

void MoveToolTest::drawTree()
{
    for (const std::vector<Vec2>& points : std::vector<std::vector<Vec2>>{{{0.0F, 0.0F}, {0.0F, 2.0F}},
                                                                          {{0.0F, 0.8F}, {0.8F, 1.2F}},
                                                                          {{0.0F, 1.5F}, {-0.7F, 2.0F}},
                                                                          {{0.6F, 1.1F}, {0.8F, 0.9F}}})
        QVERIFY(sketchBranch(m_window->document(),
                             {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), points}, .base = {}}));
    action(ActionId::Move)->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isBusy() && viewport().isAtRest(), 20'000);
}

InternodeId MoveToolTest::rightBranch()
{
    InternodeId found = 0;
    for (InternodeId id = 1; id < tree().size(); ++id) {
        if (tree().isAlive(id) && index().axis(id) == id && index().axis(tree().parent(id)) == 0 &&
            (found == 0 || index().nodePosition(tipOf(id)).x() > index().nodePosition(tipOf(found)).x()))
            found = id;
    }
    return found;
}

void MoveToolTest::drag(const QPoint& from, const QPoint& to)
{
    QTest::mouseMove(handle(), from);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    for (int i = 1; i <= 8; ++i)
        QTest::mouseMove(handle(), from + (to - from) * i / 8);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, to);
}

void MoveToolTest::middle_slidesAlongTheWood()
{
    drawTree();
    const int before = steps();
    const InternodeId branch = rightBranch();
    const Vec3 base = index().basePosition(tree(), branch);
    const std::uint32_t carried = index().subtreeSize(branch);
    const std::uint32_t living = index().livingCount();
    drag(at(0.4F, 1.0F), at(0.4F, 1.4F));
    QCOMPARE(steps(), before + 1);
    QVERIFY(!tree().isAlive(branch));
    const InternodeId moved = rightBranch();
    QCOMPARE(index().subtreeSize(moved), carried);
    QCOMPARE(index().livingCount(), living);
    const Vec3 now = index().basePosition(tree(), moved);
    QVERIFY2(std::abs(now.y() - base.y() - 0.4F) < 0.03F, qPrintable(QString::number(now.y() - base.y())));
    QVERIFY(std::abs(now.x()) < 0.01F);
    action(ActionId::Undo)->trigger();
    QVERIFY(tree().isAlive(branch));
    QCOMPARE(index().basePosition(tree(), branch), base);
    action(ActionId::Redo)->trigger();
    QCOMPARE(index().basePosition(tree(), rightBranch()), now);
}

void MoveToolTest::middle_goesToTheOtherSideOfADrawing()
{
    drawTree();
    const float up = index().nodePosition(tipOf(rightBranch())).y();
    drag(at(0.4F, 1.0F), at(-0.3F, 1.0F));
    QVERIFY(isFlat(tree(), index()));
    const Vec3 tip = index().nodePosition(tipOf(tree().size() - 1));
    QVERIFY(tip.x() < -0.5F);
    float lowest = 10.0F; // The right branch is the lower one, on the left now.
    for (InternodeId id = 1; id < tree().size(); ++id) {
        if (tree().isAlive(id) && index().axis(id) == id && index().axis(tree().parent(id)) == 0)
            lowest = std::min(lowest, index().nodePosition(tipOf(id)).y());
    }
    QVERIFY(std::abs(lowest - up) < 0.02F);
}

void MoveToolTest::middle_goesAroundATreeWithDepth()
{
    drawTree();
    QVERIFY(inferDepth(m_window->document(), {.secondTree = false}));
    // A branch that is nearly in the plane of the picture, at its right end.
    QTRY_VERIFY_WITH_TIMEOUT(viewport().isAtRest(), 20'000);
    const InternodeId branch = rightBranch();
    const InternodeId tip = tipOf(branch);
    const Vec3 middle = 0.5F * (index().basePosition(tree(), branch) + index().nodePosition(tip));
    const Vec3 before = index().nodePosition(tip);
    const QPointF seen = *viewport().mainCamera().project(middle);
    const QPointF target = *viewport().mainCamera().project(Vec3(0.3F * middle.x(), middle.y(), middle.z()));
    const std::uint32_t size = tree().size();
    drag(viewport().mapTo(m_window.get(), seen.toPoint()),
         viewport().mapTo(m_window.get(), target.toPoint()));
    QVERIFY(tree().size() > size);
    const Vec3 after = index().nodePosition(tipOf(size));
    QVERIFY(after.x() < before.x() - 0.2F);
    // It went around the trunk: no nearer to it and no higher.
    const float radius = std::hypot(before.x(), before.z());
    QVERIFY(std::abs(std::hypot(after.x(), after.z()) - radius) < 0.08F);
    QVERIFY(std::abs(after.y() - before.y()) < 0.08F);
}

void MoveToolTest::base_goesToOtherWood()
{
    drawTree();
    const std::uint32_t size = tree().size();
    // From the trunk onto the left branch, by the base.
    drag(at(0.06F, 0.83F), at(-0.3F, 1.74F));
    QVERIFY(tree().size() > size);
    const InternodeId onto = tree().parent(size);
    QVERIFY(index().axis(onto) != 0);
    QVERIFY(index().basePosition(tree(), size).x() < -0.2F);
}

void MoveToolTest::tip_scales()
{
    drawTree();
    const InternodeId branch = rightBranch();
    const Vec3 base = index().basePosition(tree(), branch);
    const float length = (index().nodePosition(tipOf(branch)) - base).norm();
    const std::uint32_t size = tree().size();
    drag(at(0.78F, 1.19F), at(0.39F, 0.995F));
    QVERIFY(tree().size() > size);
    QCOMPARE(index().basePosition(tree(), size), base);
    const float now = (index().nodePosition(tipOf(size)) - base).norm();
    QVERIFY2(std::abs(now / length - 0.5F) < 0.03F, qPrintable(QString::number(now / length)));
}

void MoveToolTest::finger_movesABranch()
{
    drawTree();
    const int before = steps();
    QTest::touchEvent(handle(), m_screen).press(0, at(0.4F, 1.0F));
    for (int i = 1; i <= 6; ++i)
        QTest::touchEvent(handle(), m_screen).move(0, at(0.4F, 1.0F + 0.05F * static_cast<float>(i)));
    QTest::touchEvent(handle(), m_screen).release(0, at(0.4F, 1.3F));
    QTRY_COMPARE(steps(), before + 1);
}

void MoveToolTest::trunk_staysWithASentence()
{
    drawTree();
    const int before = steps();
    drag(at(0.0F, 0.5F), at(0.4F, 0.5F));
    QCOMPARE(steps(), before);
    QCOMPARE(notice(), QStringLiteral("A trunk stays where it stands; drag a branch."));
}

void MoveToolTest::escape_bringsTheBranchBack()
{
    drawTree();
    const int before = steps();
    const Tree unmoved = tree();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(0.4F, 1.0F));
    QTest::mouseMove(handle(), at(0.4F, 1.2F));
    QTest::mouseMove(handle(), at(0.4F, 1.3F));
    QTRY_VERIFY(tree().size() > unmoved.size());
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(tree() == unmoved);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(0.4F, 1.3F));
    QCOMPARE(steps(), before);
}

void MoveToolTest::tap_movesNothing()
{
    drawTree();
    const int before = steps();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.4F, 1.0F));
    QCOMPARE(steps(), before);
}

static const test::TestClass<MoveToolTest> moveToolTest;

#include "MoveToolTest.moc"
