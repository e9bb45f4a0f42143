// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/BendGesture.h"

#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class BendGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void bend_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit();
    void tip_goesWhereTheHandLeads();
    void wayThereAndBack_restoresTheBranch();
    void cancelledBend_leavesNoTrace();
    void bendDroppedUnfinished_isCancelled();
    void backAtTheStart_isNoCommand();
    void otherHands_goOnFromTheFormThatStands();
    void whatHangsOnThePath_goesAlongRigidly();
    void hostileTargets_leaveASoundTree_data();
    void hostileTargets_leaveASoundTree();
    void handlesThatAreNowhere_holdNothing();
    void bendingForEver_staysWithinWhatATreeMayHold();
};

namespace {

/// A grown tree, and its longest branch: from the trunk's base to the end of that path.
struct Specimen {
    explicit Specimen(std::uint64_t seed = 3)
    {
        TreeParameters parameters;
        parameters.growth.internodeLength = 0.1;
        document.reset(seed, parameters);
        brush(document,
              strokeAlong(std::vector<Vec3>{Vec3::Zero(), Vec3(0.1F, 1.2F, 0.0F), Vec3(0.5F, 2.0F, 0.3F)},
                          0.3F, 2.5));
        const Tree& tree = document.tree();
        std::vector<int> depths(tree.size(), 0);
        for (InternodeId id = 1; id < tree.size(); ++id) {
            depths[id] = depths[tree.parent(id)] + 1;
            if (tree.isAlive(id) && depths[id] > depths[end])
                end = id;
        }
        path = pathBetween(tree, base, end);
    }

    Vec3 tip() const { return document.index().nodePosition(end); }
    float length() const
    {
        float sum = 0.0F;
        for (const InternodeId id : path)
            sum += document.tree().length(id);
        return sum;
    }

    TreeDocument document;
    InternodeId base = 0;
    InternodeId end = 0;
    std::vector<InternodeId> path;
};

bool isSound(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!isFrame(tree.columns().rotation[id], tree.length(id)) ||
            !document.index().nodePosition(id).allFinite())
            return false;
    }
    return true;
}

} // namespace

void BendGestureTest::bend_isOneDeltaAndOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        Specimen specimen(seed);
        TreeDocument& document = specimen.document;
        QVERIFY(specimen.path.size() > 10);
        const DocumentState before(document);
        const Vec3 start = specimen.tip();
        BendGesture gesture(document, specimen.base, {{specimen.end}});
        QCOMPARE(gesture.gripPoints().front(), start);
        for (int i = 1; i <= 30; ++i) {
            const Vec3 target = start + static_cast<float>(i) * Vec3(0.02F, -0.01F, 0.015F);
            gesture.moveTo(std::span(&target, 1));
            QCOMPARE(document.journal().size(), before.journal.size() + 1);
        }
        QCOMPARE(document.undoStack().count(), before.undoIndex);
        gesture.finish();
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("Bend"));
        QVERIFY((specimen.tip() - start).norm() > 0.3F);
        QCOMPARE(indexFault(document), QString());
        const DocumentState done(document);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
        QCOMPARE(differenceFrom(before, document), QString());
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
        QCOMPARE(indexFault(document), QString());
    }
}

void BendGestureTest::tip_goesWhereTheHandLeads()
{
    Specimen specimen;
    const Vec3 target = specimen.tip() + Vec3(0.4F, -0.5F, 0.2F);
    BendGesture gesture(specimen.document, specimen.base, {{specimen.end}});
    gesture.settleAt(std::span(&target, 1));
    gesture.finish();
    QVERIFY((specimen.tip() - target).norm() < 1e-4F);
}

void BendGestureTest::wayThereAndBack_restoresTheBranch()
{
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const TreeIndex before = document.index();
    const InternodeId middle = specimen.path[specimen.path.size() / 2];
    BendGesture gesture(document, specimen.base, {{middle, 0.5}, {specimen.end, 1.0}});
    const std::vector<Vec3> start = gesture.gripPoints();
    // Both handles go around in loops; the directions from the base stay well within a quarter turn.
    const float reach = 0.3F * specimen.length();
    for (int i = 0; i <= 120; ++i) {
        const float angle = static_cast<float>(radians(3.0 * i));
        const Vec3 loop(std::sin(angle), std::cos(angle) - 1.0F, 0.5F * std::sin(2.0F * angle));
        const std::vector<Vec3> targets{start[0] + 0.3F * reach * loop, start[1] + reach * loop};
        gesture.moveTo(targets);
        if (i == 60)
            QVERIFY((specimen.tip() - start[1]).norm() > reach);
    }
    gesture.settleAt(start);
    gesture.finish();
    for (const InternodeId id : specimen.path) {
        QVERIFY((document.index().nodePosition(id) - before.nodePosition(id)).norm() <
                1e-6F * specimen.length());
    }
    QCOMPARE(indexFault(document), QString());
}

void BendGestureTest::cancelledBend_leavesNoTrace()
{
    Specimen specimen;
    const DocumentState before(specimen.document);
    BendGesture gesture(specimen.document, specimen.base, {{specimen.end}});
    const Vec3 target = specimen.tip() + Vec3(0.5F, 0.0F, 0.0F);
    gesture.moveTo(std::span(&target, 1));
    QVERIFY(!(specimen.document.tree() == before.tree));
    gesture.cancel();
    QCOMPARE(differenceFrom(before, specimen.document), QString());
    gesture.moveTo(std::span(&target, 1));
    gesture.settleAt(std::span(&target, 1));
    gesture.regrip(specimen.base, {{specimen.end}});
    gesture.finish();
    QVERIFY(DocumentState(specimen.document) == before);
}

void BendGestureTest::bendDroppedUnfinished_isCancelled()
{
    Specimen specimen;
    const DocumentState before(specimen.document);
    {
        BendGesture gesture(specimen.document, specimen.base, {{specimen.end}});
        const Vec3 target = specimen.tip() + Vec3(0.5F, 0.0F, 0.0F);
        gesture.moveTo(std::span(&target, 1));
    }
    QVERIFY(DocumentState(specimen.document) == before);
}

void BendGestureTest::backAtTheStart_isNoCommand()
{
    Specimen specimen;
    const DocumentState before(specimen.document);
    BendGesture gesture(specimen.document, specimen.base, {{specimen.end}});
    const std::vector<Vec3> start = gesture.gripPoints();
    gesture.moveTo(start);
    gesture.finish();
    QVERIFY(DocumentState(specimen.document) == before);
}

void BendGestureTest::otherHands_goOnFromTheFormThatStands()
{
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const DocumentState before(document);
    BendGesture gesture(document, specimen.base, {{specimen.end}});
    const Vec3 first = specimen.tip() + Vec3(0.4F, -0.2F, 0.0F);
    gesture.settleAt(std::span(&first, 1));
    const Tree bent = document.tree();

    // A second handle holds the branch lower down: the form does not jump.
    const InternodeId middle = specimen.path[specimen.path.size() / 2];
    const Vec3 held = document.index().nodePosition(middle);
    gesture.regrip(middle, {{specimen.end}, {middle}});
    gesture.moveTo(std::vector<Vec3>{gesture.gripPoints().front(), held});
    QVERIFY(document.tree() == bent);
    const std::vector<Vec3> second{specimen.tip() + Vec3(0.0F, 0.1F, 0.3F), held};
    gesture.settleAt(second);
    QCOMPARE(document.index().nodePosition(middle), held);
    QVERIFY((specimen.tip() - second[0]).norm() < 1e-4F);
    gesture.finish();

    QCOMPARE(document.journal().size(), before.journal.size() + 1);
    QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
    const DocumentState done(document);
    document.undoStack().undo();
    QVERIFY(DocumentState(document) == before);
    document.undoStack().redo();
    QVERIFY(DocumentState(document) == done);
    QCOMPARE(indexFault(document), QString());
}

void BendGestureTest::whatHangsOnThePath_goesAlongRigidly()
{
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const Tree before = document.tree();
    const Vec3 target = specimen.tip() + Vec3(0.6F, -0.3F, 0.1F);
    BendGesture gesture(document, specimen.base, {{specimen.end}});
    gesture.settleAt(std::span(&target, 1));
    gesture.finish();
    const Tree& after = document.tree();
    int hanging = 0;
    for (InternodeId id = 1; id < after.size(); ++id) {
        if (std::ranges::binary_search(specimen.path, id))
            continue;
        QCOMPARE(after.columns().rotation[id].coeffs(), before.columns().rotation[id].coeffs());
        QCOMPARE(after.length(id), before.length(id));
        hanging += after.isAlive(id) ? 1 : 0;
    }
    QVERIFY(hanging > 20);
}

void BendGestureTest::hostileTargets_leaveASoundTree_data()
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    QTest::addColumn<Vec3>("target");
    QTest::newRow("ten times out of reach") << Vec3(30.0F, 5.0F, -4.0F);
    QTest::newRow("out of this world") << Vec3(3e38F, -3e38F, 3e38F);
    QTest::newRow("the base itself") << Vec3(Vec3::Zero());
    QTest::newRow("below the ground, straight through the base") << Vec3(0.0F, -20.0F, 0.0F);
    QTest::newRow("no number") << Vec3(std::nanf(""), 1.0F, 2.0F);
    QTest::newRow("infinite") << Vec3(kInfinity, -kInfinity, 0.0F);
}

void BendGestureTest::hostileTargets_leaveASoundTree()
{
    QFETCH(Vec3, target);
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const DocumentState before(document);
    const InternodeId middle = specimen.path[specimen.path.size() / 2];
    for (const std::vector<Vec3>& targets : {std::vector{target, target}, std::vector{target, Vec3(-target)},
                                             std::vector{Vec3(Vec3::Zero()), target}, std::vector{target}}) {
        BendGesture gesture(document, specimen.base, {{specimen.end}, {middle, 0.3}});
        for (int call = 0; call < 20; ++call) {
            gesture.moveTo(targets);
            QVERIFY(isSound(document));
        }
        gesture.finish();
        QCOMPARE(indexFault(document), QString());
        const bool isBent = document.undoStack().index() > before.undoIndex;
        QCOMPARE(isBent, !(document.tree() == before.tree));
        if (isBent)
            document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
    }
}

void BendGestureTest::handlesThatAreNowhere_holdNothing()
{
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const DocumentState before(document);
    const InternodeId beyond = document.tree().size() + 7;
    const Vec3 target(1.0F, 1.0F, 1.0F);
    const std::vector<Vec3> targets(3, target);
    const auto bend = [&](InternodeId base, std::vector<BranchBend::Handle> handles) {
        BendGesture gesture(document, base, std::move(handles));
        gesture.settleAt(targets);
        gesture.finish();
        return !(DocumentState(document) == before);
    };
    QVERIFY(!bend(0, {}));
    QVERIFY(!bend(0, {{beyond}}));
    QVERIFY(!bend(beyond, {{specimen.end}}));
    QVERIFY(!bend(kNoInternode, {{kNoInternode}}));
    QVERIFY(!bend(0, {{kNoInternode}, {0, 0.5}}));
    QVERIFY(!bend(specimen.end, {{specimen.end}, {specimen.base}}));
    // A valid handle bends the branch, also if the others are not valid.
    QVERIFY(bend(0, {{beyond}, {specimen.end, std::nan("")}, {0, -3.0}}));
    QVERIFY(isSound(document));
    QCOMPARE(indexFault(document), QString());
}

void BendGestureTest::bendingForEver_staysWithinWhatATreeMayHold()
{
    Specimen specimen;
    TreeDocument& document = specimen.document;
    const DocumentState before(document);
    // Each bend starts from the lengths that the one before has stretched or compressed.
    for (const float factor : {10.0F, 0.0F}) {
        for (int i = 0; i < 40; ++i) {
            BendGesture gesture(document, specimen.base, {{specimen.end}},
                                {.stretching = 0.01, .bending = 100.0, .mostStretch = 10.0});
            const Vec3 target = factor * specimen.tip();
            gesture.moveTo(std::span(&target, 1));
            gesture.finish();
            QVERIFY(isSound(document));
        }
        while (document.undoStack().index() > before.undoIndex)
            document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
    }
}

const TestClass<BendGestureTest> bendGestureTest;

} // namespace espalier::test

#include "BendGestureTest.moc"
