// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/MultiplyTool.h"

#include "commands/SketchStroke.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QTest>

using namespace espalier;

/// The user at the real window with the tool that makes more by example.
class MultiplyToolTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void tap_addsABranchLikeItsNeighbours();
    void finger_addsABranch();
    void passOn_givesOthersTheTwigs();
    void dragFromABranch_givesToThoseItCrosses();
    void hover_showsWhatATapWouldDo();
    void tapOnABareBranch_saysWhyNot();
    void escape_dropsTheTap();

private:
    const Tree& tree() { return m_window->document().tree(); }
    int steps() { return m_window->document().undoStack().count(); }
    /// A trunk with two branches, of which the right one has a twig, and the tool in hand.
    void drawTree();
    std::uint32_t axes();
};

void MultiplyToolTest::drawTree()
{
    for (const std::vector<Vec2>& points : std::vector<std::vector<Vec2>>{{{0.0F, 0.0F}, {0.0F, 2.0F}},
                                                                          {{0.0F, 0.8F}, {0.8F, 1.4F}},
                                                                          {{0.0F, 1.5F}, {-0.7F, 2.0F}},
                                                                          {{0.4F, 1.1F}, {0.7F, 1.15F}}})
        QVERIFY(sketchBranch(m_window->document(),
                             {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), points}, .base = {}}));
    action(ActionId::Multiply)->trigger();
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isBusy() && viewport().isAtRest(), 20'000);
    QCOMPARE(axes(), 4U);
}

std::uint32_t MultiplyToolTest::axes()
{
    std::uint32_t count = 0;
    for (InternodeId id = 0; id < tree().size(); ++id)
        count += tree().isAlive(id) && m_window->document().index().axis(id) == id ? 1 : 0;
    return count;
}

void MultiplyToolTest::tap_addsABranchLikeItsNeighbours()
{
    drawTree();
    const int before = steps();
    QTest::mouseMove(handle(), at(0.0F, 0.4F));
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.0F, 0.4F));
    QCOMPARE(steps(), before + 1);
    QVERIFY(axes() >= 5U);
    action(ActionId::Undo)->trigger();
    QCOMPARE(axes(), 4U);
}

void MultiplyToolTest::finger_addsABranch()
{
    drawTree();
    QTest::touchEvent(handle(), m_screen).press(0, at(0.0F, 0.4F));
    QTest::touchEvent(handle(), m_screen).release(0, at(0.0F, 0.4F));
    QTRY_VERIFY(axes() >= 5U);
}

void MultiplyToolTest::passOn_givesOthersTheTwigs()
{
    drawTree();
    m_window->viewSettings().set(&ViewValues::passesOn, true);
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.7F, 1.325F));
    // The other branch gets the twig; so does the twig itself not.
    QCOMPARE(axes(), 5U);
    QCOMPARE(m_window->document().undoStack().undoText(), QStringLiteral("Pass On Branch"));
}

void MultiplyToolTest::dragFromABranch_givesToThoseItCrosses()
{
    drawTree();
    QVERIFY(sketchBranch(
        m_window->document(),
        {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0.0F, 1.0F}, {-0.7F, 1.3F}}}, .base = {}}));
    QTRY_VERIFY_WITH_TIMEOUT(!m_window->isBusy() && viewport().isAtRest(), 20'000);
    m_window->viewSettings().set(&ViewValues::passesOn, true);
    // From the branch with the twig to the upper one on the left, not to the lower one.
    const QPoint from = at(0.7F, 1.325F);
    const QPoint to = at(-0.5F, 1.857F);
    QTest::mouseMove(handle(), from);
    QTest::mousePress(handle(), Qt::LeftButton, {}, from);
    // The way leads over the trunk, which gets nothing.
    for (const QPoint& point : {at(0.3F, 0.5F), at(0.0F, 0.5F), at(-0.3F, 0.5F), to})
        QTest::mouseMove(handle(), point);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, to);
    QCOMPARE(axes(), 6U);
    QVERIFY(m_window->document().index().nodePosition(tree().size() - 1).y() > 1.4F);
}

void MultiplyToolTest::hover_showsWhatATapWouldDo()
{
    drawTree();
    const auto& tool = static_cast<const MultiplyTool&>(viewport().tool());
    QVERIFY(tool.preview().empty());
    QTest::mouseMove(handle(), at(0.0F, 0.4F));
    QTRY_VERIFY(!tool.preview().empty());
    const std::array<Vec3, 2> last = tool.preview().back();
    const std::size_t count = tool.preview().size();
    const std::uint32_t before = tree().size();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(0.0F, 0.4F));
    QCOMPARE(tree().size() - before, count);
    QVERIFY((m_window->document().index().nodePosition(tree().size() - 1) - last[1]).norm() < 1e-5F);
}

void MultiplyToolTest::tapOnABareBranch_saysWhyNot()
{
    drawTree();
    const int before = steps();
    QTest::mouseClick(handle(), Qt::LeftButton, {}, at(-0.5F, 1.857F));
    QCOMPARE(steps(), before);
    QVERIFY2(notice().endsWith(QStringLiteral("carries no branch to imitate.")), qPrintable(notice()));
}

void MultiplyToolTest::escape_dropsTheTap()
{
    drawTree();
    const int before = steps();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(0.0F, 0.4F));
    QTest::keyClick(handle(), Qt::Key_Escape);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(0.0F, 0.4F));
    QCOMPARE(steps(), before);
}

static const test::TestClass<MultiplyToolTest> multiplyToolTest;

#include "MultiplyToolTest.moc"
