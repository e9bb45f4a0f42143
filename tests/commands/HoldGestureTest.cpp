// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/HoldGesture.h"

#include "commands/InvigorateGesture.h"
#include "commands/ReduceGesture.h"
#include "commands/SetParameters.h"
#include "model/shape/Reduction.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

/// Branches that are held: invigorated and reduced.
class HoldGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void hold_isOneUndoStep_undoneAndRedoneToTheBit_data();
    void hold_isOneUndoStep_undoneAndRedoneToTheBit();
    void recipe_doesTheSame_data() { models(); }
    void recipe_doesTheSame();
    void partsOfTheTime_giveTheSameAsTheWhole();
    void invigorated_growsItsBranchAlone_data() { models(); }
    void invigorated_growsItsBranchAlone();
    void longerHold_addsMoreVigour();
    void addedVigour_hasALimit();
    void reduced_losesTheYoungestFirst();
    void reduced_growsAgain_data() { models(); }
    void reduced_growsAgain();
    void reducedToTheEnd_keepsTheHeldInternode();
    void cancelled_leavesNoTrace();
    void interrupted_isCommitted();

private:
    static void models();
    /// A tree by the model of the current row of data.
    static void plant(TreeDocument& document, std::uint64_t seed, GrowthModelKind kind);
    /// A living internode that carries at least @p least others, not the seedling.
    static InternodeId branchOf(const TreeDocument& document, std::uint32_t least = 10);
};

void HoldGestureTest::models()
{
    QTest::addColumn<int>("model");
    QTest::newRow("treesketch") << static_cast<int>(GrowthModelKind::TreeSketch);
    QTest::newRow("vigour") << static_cast<int>(GrowthModelKind::Vigour);
}

void HoldGestureTest::plant(TreeDocument& document, std::uint64_t seed, GrowthModelKind kind)
{
    TreeParameters parameters;
    parameters.growth.model = kind;
    parameters.vigour.growthRate = 0.8;
    parameters.vigour.internodeLength = 0.1;
    document.reset(seed, parameters);
    QVERIFY(grow(document, kind == GrowthModelKind::Vigour ? 40 : 7) > 5);
    QVERIFY(document.index().livingCount() > 60);
}

InternodeId HoldGestureTest::branchOf(const TreeDocument& document, std::uint32_t least)
{
    InternodeId best = 0;
    for (InternodeId id = 1; id < document.tree().size(); ++id) {
        const std::uint32_t size = document.index().subtreeSize(id);
        if (size > least && (best == 0 || size < document.index().subtreeSize(best)))
            best = id;
    }
    return best;
}

void HoldGestureTest::hold_isOneUndoStep_undoneAndRedoneToTheBit_data()
{
    models();
}

void HoldGestureTest::hold_isOneUndoStep_undoneAndRedoneToTheBit()
{
    QFETCH(int, model);
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeDocument document;
        plant(document, seed, static_cast<GrowthModelKind>(model));
        const InternodeId branch = branchOf(document);
        const auto check = [&](HoldGesture& gesture) {
            const DocumentState before(document);
            gesture.holdTo(0.9);
            gesture.finish();
            QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
            QCOMPARE(indexFault(document), QString());
            const DocumentState done(document);
            QVERIFY(done.tree != before.tree);
            document.undo();
            QCOMPARE(differenceFrom(before, document), QString());
            document.redo();
            QVERIFY(DocumentState(document) == done);
        };
        InvigorateGesture invigorate(document, branch);
        check(invigorate);
        ReduceGesture reduce(document, branch);
        check(reduce);
    }
}

void HoldGestureTest::recipe_doesTheSame()
{
    QFETCH(int, model);
    TreeDocument document;
    plant(document, 5, static_cast<GrowthModelKind>(model));
    InvigorateGesture first(document, branchOf(document));
    first.holdTo(1.234);
    first.finish();
    grow(document, 2);
    ReduceGesture second(document, branchOf(document, 25));
    second.holdTo(0.61);
    second.finish();
    grow(document, 2);
    InvigorateGesture third(document, 0);
    third.finish();
    QCOMPARE(replayFault(document), QString());
}

void HoldGestureTest::partsOfTheTime_giveTheSameAsTheWhole()
{
    TreeDocument whole;
    TreeDocument parts;
    for (TreeDocument* document : {&whole, &parts})
        plant(*document, 6, GrowthModelKind::Vigour);
    const InternodeId branch = branchOf(whole);
    InvigorateGesture one(whole, branch);
    one.holdTo(2.0);
    one.finish();
    InvigorateGesture many(parts, branch);
    for (double time = 0.0; time <= 2.0; time += 0.0137)
        many.holdTo(time);
    many.holdTo(2.0);
    many.finish();
    QVERIFY(whole.tree() == parts.tree());
}

void HoldGestureTest::invigorated_growsItsBranchAlone()
{
    QFETCH(int, model);
    TreeDocument document;
    plant(document, 7, static_cast<GrowthModelKind>(model));
    const InternodeId branch = branchOf(document);
    const Tree before = document.tree();
    const std::uint32_t size = document.index().subtreeSize(branch);
    const std::uint32_t others = document.index().livingCount() - size;
    InvigorateGesture gesture(document, branch);
    gesture.holdTo(2.0);
    gesture.finish();
    QVERIFY(document.index().subtreeSize(branch) > size + 20);
    QCOMPARE(document.index().livingCount() - document.index().subtreeSize(branch), others);
    const Tree& after = document.tree();
    for (InternodeId id = 0; id < before.size(); ++id) {
        bool isInside = false;
        for (InternodeId at = id; at != kNoInternode && !isInside; at = after.parent(at))
            isInside = at == branch;
        if (isInside)
            continue;
        QCOMPARE(after.length(id), before.length(id));
        QVERIFY(after.columns().rotation[id] == before.columns().rotation[id]);
        QVERIFY(after.budStates(id) == before.budStates(id));
    }
}

void HoldGestureTest::longerHold_addsMoreVigour()
{
    float before = 0.0F;
    std::uint32_t size = 0;
    for (const double seconds : {0.2, 1.0, 3.0}) {
        TreeDocument document;
        plant(document, 8, GrowthModelKind::Vigour);
        const InternodeId branch = branchOf(document);
        InvigorateGesture gesture(document, branch);
        gesture.holdTo(seconds);
        gesture.finish();
        const float left = document.tree().content().sparse.addedVigour.at(branch).value_or(0.0F);
        QVERIFY(left > before);
        QVERIFY(document.index().subtreeSize(branch) > size);
        before = left;
        size = document.index().subtreeSize(branch);
        // The vigour model uses what is left.
        grow(document, 3);
        QVERIFY(document.tree().content().sparse.addedVigour.at(branch).value_or(0.0F) < left);
    }
}

void HoldGestureTest::addedVigour_hasALimit()
{
    TreeDocument document;
    plant(document, 9, GrowthModelKind::Vigour);
    TreeDelta delta = deltaStartingAt(document.tree());
    delta.sparse.addedVigour.push_back({5, std::nullopt, kMostAddedVigour});
    apply(document, std::move(delta));
    InvigorateGesture gesture(document, 5);
    gesture.holdTo(0.5);
    gesture.finish();
    QVERIFY(document.tree().content().sparse.addedVigour.at(5) <= kMostAddedVigour);
    QCOMPARE(treeFault(document.tree().content()), QString());
}

void HoldGestureTest::reduced_losesTheYoungestFirst()
{
    TreeDocument document;
    plant(document, 10, GrowthModelKind::TreeSketch);
    const Tree before = document.tree();
    const InternodeId branch = branchOf(document, 20);
    Step oldestGone = kNever;
    for (int i = 0; i < 3; ++i) {
        const TreeDelta delta = reduceBranch(document.tree(), document.index(), branch);
        QVERIFY(!delta.died.empty());
        const Step birth = document.tree().birth(delta.died.front());
        QVERIFY(birth < oldestGone);
        oldestGone = birth;
        for (const InternodeId id : delta.died)
            QCOMPARE(document.tree().birth(id), birth);
        for (const auto& change : delta.internodes.buds)
            QVERIFY(change.after.active() > change.before.active());
        apply(document, TreeDelta(delta));
        QCOMPARE(indexFault(document), QString());
        QCOMPARE(treeFault(document.tree().content()), QString());
    }
    for (InternodeId id = 0; id < before.size(); ++id) {
        if (before.isAlive(id) && !document.tree().isAlive(id))
            QVERIFY(before.birth(id) >= oldestGone);
    }
}

void HoldGestureTest::reduced_growsAgain()
{
    QFETCH(int, model);
    TreeDocument document;
    plant(document, 11, static_cast<GrowthModelKind>(model));
    const InternodeId branch = branchOf(document, 30);
    const std::uint32_t size = document.index().subtreeSize(branch);
    ReduceGesture gesture(document, branch);
    gesture.holdTo(0.4);
    gesture.finish();
    const std::uint32_t reduced = document.index().subtreeSize(branch);
    QVERIFY(reduced < size);
    InvigorateGesture again(document, branch);
    again.holdTo(1.5);
    again.finish();
    QVERIFY(document.index().subtreeSize(branch) > reduced);
    QCOMPARE(treeFault(document.tree().content()), QString());
    QCOMPARE(indexFault(document), QString());
}

void HoldGestureTest::reducedToTheEnd_keepsTheHeldInternode()
{
    TreeDocument document;
    plant(document, 12, GrowthModelKind::Vigour);
    ReduceGesture gesture(document, 0);
    gesture.holdTo(30.0);
    gesture.finish();
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(document.tree().buds(0) & kTerminalBud, static_cast<int>(kTerminalBud));
    const DocumentState before(document);
    ReduceGesture nothing(document, 0);
    nothing.holdTo(1.0);
    nothing.finish();
    QCOMPARE(nothing.changeCount(), 0);
    QCOMPARE(differenceFrom(before, document), QString());
}

void HoldGestureTest::cancelled_leavesNoTrace()
{
    TreeDocument document;
    plant(document, 13, GrowthModelKind::TreeSketch);
    const DocumentState before(document);
    InvigorateGesture gesture(document, branchOf(document));
    gesture.holdTo(0.5);
    QVERIFY(document.tree() != before.tree);
    gesture.cancel();
    QCOMPARE(differenceFrom(before, document), QString());
    gesture.finish();
    QCOMPARE(differenceFrom(before, document), QString());
}

void HoldGestureTest::interrupted_isCommitted()
{
    TreeDocument document;
    plant(document, 14, GrowthModelKind::TreeSketch);
    const int commands = document.undoStack().count();
    InvigorateGesture gesture(document, branchOf(document));
    gesture.holdTo(0.5);
    grow(document, 1);
    QCOMPARE(document.undoStack().count(), commands + 2);
    const Tree after = document.tree();
    gesture.holdTo(2.0);
    QVERIFY(document.tree() == after);
}

const TestClass<HoldGestureTest> holdGestureTest;

} // namespace espalier::test

#include "HoldGestureTest.moc"
