// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TwistGesture.h"

#include "commands/Prune.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <limits>

namespace espalier::test {

class TwistGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void twist_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit();
    void branch_isTwistedFromThePressedNodeToItsTip();
    void subtree_isTwistedWhole();
    void angle_isRoundedAndClamped();
    void zero_takesTheTwistAway();
    void twist_replacesTheOneThatIsThere();
    void cancelledTwist_leavesNoTrace();
    void anotherEdit_finishesTheTwist();
    void deadAndUnknown_haveNoTwist();
    void recipe_givesTheSameDocument();
};

namespace {

/// An internode of the trunk with branches above it.
InternodeId trunkNode(const TreeDocument& document)
{
    InternodeId id = 0;
    for (int i = 0; i < 3; ++i)
        id = document.index().mainChild(id);
    return id;
}

double twistAt(const TreeDocument& document, InternodeId id)
{
    const float* twist = document.tree().content().sparse.twist.find(id);
    return twist ? degrees(static_cast<double>(*twist)) : 0.0;
}

bool isAbout(double value, double wanted)
{
    return std::abs(value - wanted) < 1e-4;
}

} // namespace

void TwistGestureTest::twist_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit()
{
    for (const TwistScope scope : {TwistScope::Branch, TwistScope::Subtree}) {
        TreeDocument document;
        growAtRandom(document, 3, 100, 300);
        const DocumentState before(document);
        TwistGesture gesture(document, 1, scope);
        for (int i = 1; i <= 20; ++i) {
            gesture.set(2.0 * i);
            QCOMPARE(document.journal().size(), before.journal.size() + 1);
            QVERIFY(isAbout(twistAt(document, 1), 2.0 * i));
        }
        gesture.finish();
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Twist"));
        QCOMPARE(indexFault(document), QString());
        const DocumentState done(document);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
        QCOMPARE(differenceFrom(before, document), QString());
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
    }
}

void TwistGestureTest::branch_isTwistedFromThePressedNodeToItsTip()
{
    TreeDocument document;
    grow(document, 14);
    const TreeIndex& index = document.index();
    const InternodeId from = trunkNode(document);
    twistBranch(document, from, TwistScope::Branch, 25.0);
    int twisted = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const bool isAbove = index.axis(id) == index.axis(from) && id >= from && document.tree().isAlive(id);
        QVERIFY(isAbout(twistAt(document, id), isAbove ? 25.0 : 0.0));
        twisted += isAbove ? 1 : 0;
    }
    QVERIFY(twisted > 3);
}

void TwistGestureTest::subtree_isTwistedWhole()
{
    TreeDocument document;
    grow(document, 14);
    const TreeIndex& index = document.index();
    const InternodeId from = trunkNode(document);
    twistBranch(document, from, TwistScope::Subtree, -40.0);
    const auto& cells = document.tree().content().sparse.twist.cells();
    QCOMPARE(cells.size(), std::size_t{index.subtreeSize(from)});
    QVERIFY(cells.size() > 20);
    for (const auto& cell : cells)
        QVERIFY(isAbout(degrees(static_cast<double>(cell.value)), -40.0));
    QVERIFY(twistAt(document, document.tree().parent(from)) == 0.0);
}

void TwistGestureTest::angle_isRoundedAndClamped()
{
    TreeDocument document;
    grow(document, 4);
    TwistGesture gesture(document, 1, TwistScope::Branch);
    gesture.set(12.3456);
    QCOMPARE(gesture.angle(), 12.35);
    QVERIFY(isAbout(twistAt(document, 1), 12.35));
    gesture.set(1e9);
    QVERIFY(isAbout(twistAt(document, 1), 180.0));
    gesture.set(-1e9);
    QVERIFY(isAbout(twistAt(document, 1), -180.0));
    gesture.set(std::numeric_limits<double>::quiet_NaN());
    QVERIFY(isAbout(twistAt(document, 1), -180.0));
    gesture.finish();
    QCOMPARE(indexFault(document), QString());
}

void TwistGestureTest::zero_takesTheTwistAway()
{
    TreeDocument document;
    grow(document, 8);
    const DocumentState before(document);
    twistBranch(document, 1, TwistScope::Subtree, 10.0);
    twistBranch(document, 0, TwistScope::Subtree, 0.0);
    QVERIFY(document.tree() == before.tree);
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Remove Twist"));
    const int steps = document.undoStack().count();
    twistBranch(document, 0, TwistScope::Subtree, 0.0);
    QCOMPARE(document.undoStack().count(), steps);
}

void TwistGestureTest::twist_replacesTheOneThatIsThere()
{
    TreeDocument document;
    grow(document, 10);
    const InternodeId from = trunkNode(document);
    twistBranch(document, 0, TwistScope::Subtree, 10.0);
    twistBranch(document, from, TwistScope::Branch, 50.0);
    QVERIFY(isAbout(twistAt(document, 0), 10.0));
    QVERIFY(isAbout(twistAt(document, from), 50.0));
    const int steps = document.undoStack().count();
    twistBranch(document, from, TwistScope::Branch, 50.0); // nothing new
    QCOMPARE(document.undoStack().count(), steps);
}

void TwistGestureTest::cancelledTwist_leavesNoTrace()
{
    TreeDocument document;
    grow(document, 8);
    twistBranch(document, 2, TwistScope::Branch, 5.0);
    const DocumentState before(document);
    TwistGesture gesture(document, 1, TwistScope::Subtree);
    gesture.set(70.0);
    QVERIFY(!(document.tree() == before.tree));
    gesture.cancel();
    QVERIFY(DocumentState(document) == before);
}

void TwistGestureTest::anotherEdit_finishesTheTwist()
{
    TreeDocument document;
    grow(document, 8);
    const int steps = document.undoStack().count();
    TwistGesture gesture(document, 1, TwistScope::Branch);
    gesture.set(30.0);
    pruneBranches(document, std::array{InternodeId{4}});
    QCOMPARE(document.undoStack().count(), steps + 2);
    const DocumentState after(document);
    gesture.set(80.0);
    gesture.finish();
    QVERIFY(DocumentState(document) == after);
    QVERIFY(isAbout(twistAt(document, 1), 30.0));
}

void TwistGestureTest::deadAndUnknown_haveNoTwist()
{
    TreeDocument document;
    grow(document, 8);
    pruneBranches(document, std::array{InternodeId{3}});
    const DocumentState before(document);
    for (const InternodeId id : {InternodeId{3}, document.tree().size(), kNoInternode}) {
        twistBranch(document, id, TwistScope::Branch, 20.0);
        twistBranch(document, id, TwistScope::Subtree, 20.0);
    }
    QVERIFY(DocumentState(document) == before);
}

void TwistGestureTest::recipe_givesTheSameDocument()
{
    TreeDocument document;
    grow(document, 8);
    twistBranch(document, 1, TwistScope::Branch, 12.3456);
    twistBranch(document, 3, TwistScope::Subtree, -71.8);
    twistBranch(document, 2, TwistScope::Branch, -0.001);
    QCOMPARE(replayFault(document), QString());
}

static const TestClass<TwistGestureTest> twistGestureTest;

} // namespace espalier::test

#include "TwistGestureTest.moc"
