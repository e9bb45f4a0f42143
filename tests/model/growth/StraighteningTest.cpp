// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Straightening.h"

#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

namespace espalier::test {

/// Young wood that straightens.
class StraighteningTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void elbow_spreadsOverItsNeighbours();
    void endsOfThePath_keepTheirDirection();
    void fork_keepsItsAngle();
    void lateralThatDoesNotLead_keepsItsAngle();
    void off_turnsNothing();
    void drawnAxis_staysAsDrawn();
    void branchPlacedByHand_staysAsItIs();
    void nothing_getsBelowTheGround();
    void grownTree_hasFewerSharpTurns();

private:
    /// A trunk whose tip a lateral has taken over from, at 60°: ids 1...6 the trunk below the elbow, 7 the
    /// old tip, 8...15 what has taken over.
    static void plantElbow(TreeDocument& document, double straightening, double upward = 0.0);
    /// So many times two steps, in one of which wood turns and nothing else happens.
    static void straighten(TreeDocument& document, const std::vector<InternodeId>& growingAt, int steps = 1);
    static double angleBetween(const Vec3& a, const Vec3& b)
    {
        return std::atan2(double{a.cross(b).norm()}, double{a.dot(b)});
    }
    /// The angle between an internode and what carries it, rad.
    static double turnAt(const TreeDocument& document, InternodeId id)
    {
        return angleBetween(document.index().heading(document.tree().parent(id)),
                            document.index().heading(id));
    }

    static constexpr InternodeId kElbow = 8;
    static constexpr InternodeId kTip = 15;
};

void StraighteningTest::plantElbow(TreeDocument& document, double straightening, double upward)
{
    TreeParameters parameters;
    parameters.growth.straightening = straightening;
    document.reset(3, parameters);
    std::vector<NewInternode> internodes;
    const auto turned = [upward](InternodeId id) {
        return id == 1 ? branching(upward, 0, 1, 0.0) : Rotation(Rotation::Identity());
    };
    for (InternodeId id = 1; id <= 7; ++id)
        internodes.push_back({.parent = id - 1, .rotation = turned(id)});
    internodes.push_back({.parent = 6, .slot = 0, .rotation = branching(radians(60), 0, 1, 0.0)});
    for (InternodeId id = 9; id <= kTip; ++id)
        internodes.push_back({.parent = id - 1});
    // A twig, so that the elbow carries more tips than the old tip.
    internodes.push_back({.parent = 11, .slot = 0, .rotation = branching(radians(40))});
    apply(document, births(document.tree(), internodes));
}

void StraighteningTest::straighten(TreeDocument& document, const std::vector<InternodeId>& growingAt,
                                   int steps)
{
    GrowthWorkspace workspace;
    for (int i = 0; i < 2 * steps; ++i) {
        GrowingTree growing(document.tree(), document.index(), workspace);
        straightenWood(growing, growingAt, workspace);
        TreeDelta delta = growing.takeDelta();
        delta.stepAfter = delta.stepBefore + 1;
        apply(document, std::move(delta));
    }
    QCOMPARE(indexFault(document), QString());
}

void StraighteningTest::elbow_spreadsOverItsNeighbours()
{
    TreeDocument document;
    plantElbow(document, 0.3);
    QVERIFY(turnAt(document, kElbow) > radians(59));
    straighten(document, {kTip});
    // In two steps 1 - 0.7² of the way to the mean of the neighbours, on both sides of the elbow.
    QVERIFY(std::abs(turnAt(document, kElbow) - radians(30)) < radians(6));
    straighten(document, {kTip}, 7);
    for (InternodeId id = kElbow; id <= kTip; ++id)
        QVERIFY(turnAt(document, id) < radians(20));
    while (document.undoStack().canUndo())
        document.undo();
    QCOMPARE(document.tree().size(), 1U);
}

void StraighteningTest::endsOfThePath_keepTheirDirection()
{
    TreeDocument document;
    plantElbow(document, 0.8);
    const Vec3 root = document.index().heading(0);
    const Vec3 tip = document.index().heading(kTip);
    straighten(document, {kTip}, 6);
    QVERIFY(angleBetween(root, document.index().heading(0)) < 1e-3);
    QVERIFY(angleBetween(tip, document.index().heading(kTip)) < 1e-3);
    QVERIFY(turnAt(document, kElbow) < radians(25));
}

void StraighteningTest::fork_keepsItsAngle()
{
    TreeDocument document;
    plantElbow(document, 0.5);
    const auto fork = [&] {
        return angleBetween(document.index().heading(7), document.index().heading(kElbow));
    };
    const double before = fork();
    straighten(document, {kTip}, 5);
    QVERIFY(std::abs(fork() - before) < 1e-3);
    // What led before leans the other way now.
    QVERIFY(document.index().heading(7).x() < -0.2F);
}

void StraighteningTest::lateralThatDoesNotLead_keepsItsAngle()
{
    TreeDocument document;
    plantElbow(document, 1.0);
    const double twig = turnAt(document, kTip + 1);
    const Rotation before = document.tree().columns().rotation[7];
    straighten(document, {7});
    QVERIFY(document.tree().columns().rotation[7] == before);
    straighten(document, {kTip, kTip + 1}, 3);
    QVERIFY(std::abs(turnAt(document, kTip + 1) - twig) < radians(12));
}

void StraighteningTest::off_turnsNothing()
{
    TreeDocument document;
    plantElbow(document, 0.0);
    const QList<Rotation> before = document.tree().columns().rotation;
    straighten(document, {kTip}, 3);
    QVERIFY(document.tree().columns().rotation == before);
}

void StraighteningTest::drawnAxis_staysAsDrawn()
{
    TreeDocument document;
    TreeParameters parameters;
    parameters.growth.straightening = 1.0;
    document.reset(2, parameters);
    std::vector<Vec3> zigzag;
    for (int i = 0; i <= 8; ++i)
        zigzag.emplace_back(i % 2 == 0 ? 0.0F : 0.3F, 0.3F * static_cast<float>(i), 0.0F);
    brush(document, strokeAlong(zigzag, 0.0F, 1.0));
    const std::uint32_t drawn = document.tree().size();
    QVERIFY(drawn > 15);
    QVERIFY(document.tree().drawnLength(0) > 2.9F);
    std::vector<Vec3> places;
    for (InternodeId id = 0; id < drawn; ++id)
        places.push_back(document.index().nodePosition(id));
    QVERIFY(grow(document, 8) > 0);
    for (InternodeId id = 0; id < drawn; ++id)
        QVERIFY(document.index().nodePosition(id) == places[id]);
    QCOMPARE(indexFault(document), QString());
}

void StraighteningTest::branchPlacedByHand_staysAsItIs()
{
    TreeDocument document;
    plantElbow(document, 1.0);
    const InternodeId first = document.tree().size();
    apply(document, births(document.tree(),
                           std::vector<NewInternode>{
                               {.parent = 3, .slot = kFirstAdventitiousSlot, .rotation = branching(1.0)},
                               {.parent = first, .rotation = branching(0.9)},
                               {.parent = first + 1, .rotation = branching(0.9)}}));
    const QList<Rotation> before = document.tree().columns().rotation;
    straighten(document, {first + 2}, 3);
    QVERIFY(document.tree().columns().rotation == before);
}

void StraighteningTest::nothing_getsBelowTheGround()
{
    // A branch that lies on the ground: to straighten it would push it in.
    TreeDocument document;
    plantElbow(document, 1.0, radians(89.5));
    straighten(document, {kTip}, 10);
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        growAtRandom(document, seed, 100, 400);
        TreeParameters parameters = document.parameters();
        parameters.growth.straightening = 1.0;
        parameters.growth.setPointAngle = radians(150);
        TreeDelta delta = deltaStartingAt(document.tree());
        delta.parametersAfter = keepParameters(delta, document.tree(), parameters);
        if (!delta.isEmpty())
            apply(document, std::move(delta));
        grow(document, 5);
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                QVERIFY(document.index().nodePosition(id).y() >= -1e-4F);
        }
    }
}

void StraighteningTest::grownTree_hasFewerSharpTurns()
{
    // Turns of more than 30° where a branch goes on, of all internodes that go on.
    const auto sharp = [](double straightening) {
        int turns = 0;
        int all = 0;
        for (std::uint64_t seed = 1; seed <= 4; ++seed) {
            TreeParameters parameters;
            parameters.growth.straightening = straightening;
            TreeDocument document;
            document.reset(seed, parameters);
            const Vec3 line[] = {{0.0F, 0.3F, 0.0F}, {0.2F, 2.5F, 0.0F}};
            brush(document, strokeAlong(line, 0.6F, 2.0));
            const Tree& tree = document.tree();
            const TreeIndex& index = document.index();
            for (InternodeId id = 1; id < tree.size(); ++id) {
                if (!tree.isAlive(id) || index.tipCount(id) < 3 ||
                    2 * index.tipCount(id) < index.tipCount(tree.parent(id)))
                    continue;
                ++all;
                turns += turnAt(document, id) > radians(30) ? 1 : 0;
            }
        }
        return static_cast<double>(turns) / all;
    };
    const double before = sharp(0.0);
    const double after = sharp(0.35);
    QVERIFY2(before > 0.1 && after < 0.5 * before,
             qPrintable(QStringLiteral("%1, then %2").arg(before).arg(after)));
}

} // namespace espalier::test

static const espalier::test::TestClass<espalier::test::StraighteningTest> straighteningTest;

#include "StraighteningTest.moc"
