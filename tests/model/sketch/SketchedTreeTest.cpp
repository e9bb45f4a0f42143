// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/SketchedTree.h"

#include "tests/model/sketch/DrawnTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>

namespace espalier::test {

class SketchedTreeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void attach_firstStroke_isTheTrunkFromItsLowerEnd();
    void attach_choosesTheNearestBranchAndTheNearerEnd();
    void attach_movesTheBaseAndKeepsTheTip();
    void attach_loop_isALeafOnTheNearestBranch();
    void attach_dot_addsNothing();
    void attach_secondSide_givesMiddleAndRadii();
    void attach_laterParallelStroke_isABranchOfItsOwn();
    void ofStrokes_inAnyOrder_isTheSameTree();
    void ofStrokes_pairsSidesDrawnOneAfterTheOther();
};

namespace {

/// A trunk of 4 m with a limb at 2 m to the right, which carries a twig, and a limb at 3 m to the left.
struct SmallDrawing {
    SketchedTree tree;
    SketchId trunk = 0;
    SketchId limb = 0;
    SketchId twig = 0;
    SketchId left = 0;

    SmallDrawing()
    {
        trunk = *tree.attach(openStroke({{0.0, 0.0}, {0.0, 1.0}, {0.0, 4.0}}));
        limb = *tree.attach(openStroke({{0.1, 2.0}, {1.0, 2.0}, {2.0, 2.0}}));
        twig = *tree.attach(openStroke({{1.5, 2.1}, {1.5, 3.0}}));
        left = *tree.attach(openStroke({{-0.1, 3.0}, {-1.0, 3.0}}));
    }
};

/// What a drawing consists of, without ids: each branch by its base and tip, sorted.
std::vector<std::array<double, 4>> endsOf(const SketchedTree& tree)
{
    std::vector<std::array<double, 4>> ends;
    for (const SketchedBranch& branch : tree.branches()) {
        ends.push_back({branch.line.front().x(), branch.line.front().y(), branch.line.back().x(),
                        branch.line.back().y()});
    }
    std::ranges::sort(ends);
    return ends;
}

} // namespace

void SketchedTreeTest::attach_firstStroke_isTheTrunkFromItsLowerEnd()
{
    SketchedTree tree;
    const auto id = tree.attach(openStroke({{0.5, 4.0}, {0.0, 0.0}}));
    QVERIFY(id);
    const SketchedBranch* trunk = tree.branch(*id);
    QVERIFY(trunk != nullptr);
    QVERIFY(!trunk->parent);
    QCOMPARE(trunk->line.front(), Eigen::Vector2d(0.0, 0.0));
    QCOMPARE(trunk->line.back(), Eigen::Vector2d(0.5, 4.0));
}

void SketchedTreeTest::attach_choosesTheNearestBranchAndTheNearerEnd()
{
    SmallDrawing small;
    // Drawn toward the limb, so its last point is the base.
    const auto id = small.tree.attach(openStroke({{1.0, 0.5}, {1.2, 1.9}}));
    QVERIFY(id);
    const SketchedBranch* branch = small.tree.branch(*id);
    QVERIFY(branch->parent == small.limb);
    QVERIFY((branch->line.front() - Eigen::Vector2d(1.2, 2.0)).norm() < 1e-12);
    QVERIFY(std::abs(branch->along - 0.6) < 1e-12);
    QVERIFY(small.tree.branch(small.twig)->parent == small.limb);
    QVERIFY(small.tree.branch(small.left)->parent == small.trunk);
    QVERIFY(std::abs(small.tree.branch(small.left)->along - 0.75) < 1e-12);
}

void SketchedTreeTest::attach_movesTheBaseAndKeepsTheTip()
{
    SketchedTree tree;
    tree.attach(openStroke({{0.0, 0.0}, {0.0, 4.0}}));
    const SketchLine drawn = bentLine({0.3, 2.0}, 0.4, 2.0, 0.5, 21);
    const SketchLine line = tree.branch(*tree.attach(openStroke(drawn)))->line;
    QCOMPARE(line.size(), drawn.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double share = static_cast<double>(i) / 20.0; // The drawn points are at even distances
        const Eigen::Vector2d shift = line[i] - drawn[i];
        QVERIFY((shift - (1.0 - share) * Eigen::Vector2d(-0.3, 0.0)).norm() < 1e-9);
    }
    QCOMPARE(line.back(), drawn.back());
}

void SketchedTreeTest::attach_loop_isALeafOnTheNearestBranch()
{
    SmallDrawing small;
    const SketchStroke loop{.kind = SketchStroke::Kind::Closed, .line = {{0.8, 1.2}, {1.2, 1.2}, {1.0, 1.9}}};
    const auto id = small.tree.attach(loop);
    QVERIFY(id);
    QCOMPARE(small.tree.branches().size(), std::size_t{4});
    QCOMPARE(small.tree.leaves().size(), std::size_t{1});
    const SketchedLeaf& leaf = small.tree.leaves().front();
    QCOMPARE(leaf.id, *id);
    QCOMPARE(leaf.branch, small.limb);
    QVERIFY(std::abs(leaf.along - 0.5) < 1e-12);
    QVERIFY((leaf.outline.front() - Eigen::Vector2d(1.0, 2.0)).norm() < 1e-12);
    QCOMPARE(leaf.outline.size(), std::size_t{3});
    QCOMPARE(leaf.outline[1], Eigen::Vector2d(0.8, 1.2)); // The farthest points stay
    QVERIFY(!SketchedTree().attach(loop));                // There is no branch that could carry it
}

void SketchedTreeTest::attach_dot_addsNothing()
{
    SmallDrawing small;
    const SketchedTree before = small.tree;
    QVERIFY(!small.tree.attach({.kind = SketchStroke::Kind::Dot, .line = {{1.0, 1.0}}}));
    QVERIFY(small.tree.branches() == before.branches());
    QVERIFY(small.tree.leaves().empty());
}

void SketchedTreeTest::attach_secondSide_givesMiddleAndRadii()
{
    SketchedTree tree;
    const auto first = tree.attach(openStroke({{-0.3, 0.0}, {-0.1, 4.0}}));
    const auto second = tree.attach(openStroke({{0.1, 4.0}, {0.3, 0.0}})); // Drawn downward
    QCOMPARE(*second, *first);
    QCOMPARE(tree.branches().size(), std::size_t{1});
    const SketchedBranch& trunk = tree.branches().front();
    QVERIFY((trunk.line.front() - Eigen::Vector2d(0.0, 0.0)).norm() < 1e-12);
    QVERIFY((trunk.line.back() - Eigen::Vector2d(0.0, 4.0)).norm() < 1e-12);
    QVERIFY(std::abs(trunk.radii.front() - 0.3) < 1e-12);
    QVERIFY(std::abs(trunk.radii.back() - 0.1) < 1e-12);
    // A third stroke beside them is no third side.
    QVERIFY(*tree.attach(openStroke({{0.5, 0.0}, {0.4, 4.0}})) != *first);
    QCOMPARE(tree.branches().size(), std::size_t{2});
}

void SketchedTreeTest::attach_laterParallelStroke_isABranchOfItsOwn()
{
    SketchedTree tree;
    tree.attach(openStroke({{0.0, 0.0}, {0.0, 4.0}}));
    tree.attach(openStroke({{0.1, 1.0}, {2.0, 1.5}}));
    tree.attach(openStroke({{-0.1, 1.0}, {-2.0, 1.5}}));
    tree.attach(openStroke({{0.1, 1.1}, {2.0, 1.6}}));
    QCOMPARE(tree.branches().size(), std::size_t{4});
    for (const SketchedBranch& branch : tree.branches())
        QVERIFY(branch.radii.empty());
}

void SketchedTreeTest::ofStrokes_inAnyOrder_isTheSameTree()
{
    std::vector<SketchStroke> strokes = drawnTree(3, 30);
    const auto expected = endsOf(SketchedTree::ofStrokes(strokes));
    QCOMPARE(expected.size(), std::size_t{30});
    Random random(1, 0, 0, Purpose::Texture);
    for (int round = 0; round < 5; ++round) {
        for (std::size_t i = strokes.size() - 1; i > 0; --i)
            std::swap(strokes[i], strokes[random.bits() % (i + 1)]);
        for (SketchStroke& stroke : strokes) {
            if (random.uniform() < 0.5)
                std::ranges::reverse(stroke.line);
        }
        const auto found = endsOf(SketchedTree::ofStrokes(strokes));
        QCOMPARE(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            for (std::size_t j = 0; j < 4; ++j)
                QVERIFY(std::abs(found[i][j] - expected[i][j]) < 1e-9);
        }
    }
}

void SketchedTreeTest::ofStrokes_pairsSidesDrawnOneAfterTheOther()
{
    const std::vector<SketchStroke> strokes{openStroke({{0.2, 2.0}, {1.5, 2.5}}),
                                            openStroke({{-0.2, 0.0}, {-0.1, 4.0}}),
                                            openStroke({{0.2, 0.0}, {0.1, 4.0}})};
    const SketchedTree tree = SketchedTree::ofStrokes(strokes);
    QCOMPARE(tree.branches().size(), std::size_t{2});
    QVERIFY(!tree.branches()[0].radii.empty());
    QVERIFY(tree.branches()[1].radii.empty());
    QVERIFY(SketchedTree::ofStrokes({}).isEmpty());
}

const TestClass<SketchedTreeTest> sketchedTreeTest;

} // namespace espalier::test

#include "SketchedTreeTest.moc"
