// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/GrowGesture.h"

#include "commands/SetParameters.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class GrowGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void growth_isOneUndoStep_undoneAndRedoneToTheBit();
    void cancelledGrowth_leavesNoTrace();
    void growthDroppedUnfinished_isCancelled();
    void noGrowth_isNoCommand();
    void afterItsEnd_theGestureDoesNothing();
    void seedling_becomesATree();
    void selectedBranch_growsAlone();
    void parameters_areOneUndoStep_undoneAndRedoneToTheBit();
    void parametersInForce_areNoCommand();
};

void GrowGestureTest::growth_isOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 40, 200);
        const DocumentState before(document);
        if (grow(document, 4) == 0)
            continue;
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        const DocumentState done(document);
        QCOMPARE(indexFault(document), QString());
        document.undoStack().undo();
        QCOMPARE(differenceFrom(before, document), QString());
        const DocumentState undone(document);
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == undone);
    }
}

void GrowGestureTest::cancelledGrowth_leavesNoTrace()
{
    TreeDocument document;
    grow(document, 6);
    document.undoStack().clear();
    const DocumentState before(document);
    GrowGesture gesture(document);
    QVERIFY(gesture.step());
    QVERIFY(gesture.step());
    gesture.cancel();
    QCOMPARE(differenceFrom(before, document), QString());
    gesture.finish();
    QCOMPARE(document.undoStack().count(), 0);
}

void GrowGestureTest::growthDroppedUnfinished_isCancelled()
{
    TreeDocument document;
    grow(document, 6);
    document.undoStack().clear();
    const DocumentState before(document);
    {
        GrowGesture gesture(document);
        QVERIFY(gesture.step());
    }
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(document.undoStack().count(), 0);
}

void GrowGestureTest::noGrowth_isNoCommand()
{
    TreeDocument document;
    GrowGesture gesture(document);
    gesture.finish();
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(document.tree() == Tree(1));
}

void GrowGestureTest::afterItsEnd_theGestureDoesNothing()
{
    TreeDocument document;
    GrowGesture gesture(document);
    QVERIFY(gesture.step());
    gesture.finish();
    const DocumentState done(document);
    QVERIFY(!gesture.step());
    gesture.cancel();
    QVERIFY(DocumentState(document) == done);
}

void GrowGestureTest::seedling_becomesATree()
{
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        TreeDocument document;
        document.reset(seed);
        QCOMPARE(grow(document, 25), 25);
        QVERIFY(document.index().livingCount() > 200);
        QVERIFY(document.index().tipCount(0) > 30);
        for (InternodeId id = 1; id < document.tree().size(); ++id)
            QVERIFY(document.index().nodePosition(id).y() > -0.2F);
    }
}

void GrowGestureTest::selectedBranch_growsAlone()
{
    TreeDocument document;
    QVERIFY(grow(document, 12) > 8);
    const Tree& tree = document.tree();
    const std::uint32_t size = tree.size();
    InternodeId branch = kNoInternode;
    for (InternodeId id = 1; id < size; ++id) {
        if (tree.isAlive(id) && !tree.continuesAxis(id))
            branch = id;
    }
    QVERIFY(branch != kNoInternode);
    const Competitors competitors{tree.parent(branch), tree.columns().slot[branch]};
    QVERIFY(grow(document, 5, competitors) > 0);
    QVERIFY(tree.size() > size);
    for (InternodeId id = size; id < tree.size(); ++id) {
        InternodeId ancestor = id;
        while (ancestor > branch)
            ancestor = tree.parent(ancestor);
        QCOMPARE(ancestor, branch);
    }
}

void GrowGestureTest::parameters_areOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 40, 150);
        const DocumentState before(document);
        Random random(seed, 5, 0, Purpose::ShootLength);
        const TreeParameters wanted = randomParameters(random);
        setParameters(document, wanted);
        QVERIFY(document.parameters() == wanted);
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(indexFault(document), QString());
        const DocumentState done(document);
        document.undoStack().undo();
        QCOMPARE(differenceFrom(before, document), QString());
        const DocumentState undone(document);
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == undone);
    }
}

void GrowGestureTest::parametersInForce_areNoCommand()
{
    TreeDocument document;
    setParameters(document, document.parameters());
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(document.journal().empty());
}

const TestClass<GrowGestureTest> growGestureTest;

} // namespace espalier::test

#include "GrowGestureTest.moc"
