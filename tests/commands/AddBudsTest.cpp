// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/AddBuds.h"

#include "commands/Prune.h"
#include "model/shape/Widths.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <cmath>

namespace espalier::test {

class AddBudsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void buds_areOneUndoStep_undoneAndRedoneToTheBit();
    void buds_standInASpiralOnTheBark();
    void buds_lookOutOfTheBarkAndToTheLight();
    void branches_areAttachedAlongTheWood();
    void shortAxis_hasAllBudsCloserTogether();
    void ground_hasNoBudsBelowIt();
    void samePlace_canHaveBudsAgain();
    void buds_growIntoBranchesAfterAPrune();
    void oneBud_canGrowAlone();
    void deadAndUnknown_haveNoBuds();
    void recipe_givesTheSameDocument();
};

namespace {

/// A straight trunk of @p count internodes of 0.2 m without branches.
void plantTrunk(TreeDocument& document, int count = 12)
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.2;
    parameters.growth.irregularity = 0.0;
    parameters.widths.baseDiameter = 0.2;
    document.reset(5, parameters);
    const std::vector<Vec3> stem{Vec3::Zero(), Vec3(0.0F, 0.2F * static_cast<float>(count), 0.0F)};
    brush(document, strokeAlong(stem, 0.0F, 2.0));
    QVERIFY(document.tree().size() >= static_cast<std::uint32_t>(count) - 2);
    document.undoStack().clear();
}

std::vector<BarkBud> shownBuds(const TreeDocument& document, const BudSpiral& spiral)
{
    const Widths widths(document.tree(), document.index());
    return budsOf(document, spiral, [&](InternodeId id) { return widths.radius(document.index(), id); });
}

} // namespace

void AddBudsTest::buds_areOneUndoStep_undoneAndRedoneToTheBit()
{
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 100, 300);
        const DocumentState before(document);
        QCOMPARE(addBuds(document, {.internode = 2, .count = 5, .spacing = 0.02}), 5);
        QCOMPARE(document.tree().size(), before.tree.size() + 5);
        QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
        QCOMPARE(document.undoStack().undoText(), QStringLiteral("New Buds"));
        QCOMPARE(indexFault(document), QString());
        QCOMPARE(treeFault(document.tree().content()), QString());
        const DocumentState done(document);
        document.undoStack().undo();
        QVERIFY(DocumentState(document) == before);
        QCOMPARE(differenceFrom(before, document), QString());
        document.undoStack().redo();
        QVERIFY(DocumentState(document) == done);
    }
}

void AddBudsTest::buds_standInASpiralOnTheBark()
{
    TreeDocument document;
    plantTrunk(document);
    constexpr double kSpacing = 0.07;
    const std::vector<BarkBud> buds = shownBuds(
        document, {.internode = 5, .along = 0.25, .azimuth = 40.0, .count = 7, .spacing = kSpacing});
    QCOMPARE(buds.size(), 7U);
    const Widths widths(document.tree(), document.index());
    const auto azimuth = [](const BarkBud& bud) {
        return std::atan2(static_cast<double>(bud.place.z()), static_cast<double>(bud.place.x()));
    };
    for (std::size_t i = 0; i < buds.size(); ++i) {
        const double fromAxis = std::hypot(buds[i].place.x(), buds[i].place.z());
        const auto bark = static_cast<double>(widths.radius(document.index(), buds[i].internode));
        QVERIFY(fromAxis > 0.98 * bark && fromAxis < 1.2 * bark + 0.01);
        if (i == 0)
            continue;
        const double turn = std::remainder(azimuth(buds[i]) - azimuth(buds[i - 1]), radians(360));
        QVERIFY2(std::abs(std::abs(turn) - radians(137.5)) < radians(0.5),
                 qPrintable(QString::number(degrees(turn))));
        const auto rise = static_cast<double>(buds[i].place.y() - buds[i - 1].place.y());
        QVERIFY2(std::abs(rise - kSpacing) < 1e-3, qPrintable(QString::number(rise)));
    }
    // The middle one is where it was asked for.
    const Vec3 local = document.index().rotation(5).conjugate() *
                       Vec3(buds[3].place - document.index().basePosition(document.tree(), 5));
    QVERIFY(std::abs(local.y() - 0.25F * document.tree().length(5)) < 1e-3F);
    QVERIFY(std::abs(degrees(std::atan2(static_cast<double>(local.z()), local.x())) - 40.0) < 0.5);
}

void AddBudsTest::buds_lookOutOfTheBarkAndToTheLight()
{
    TreeDocument document;
    plantTrunk(document);
    for (const BarkBud& bud : shownBuds(document, {.internode = 6, .count = 8, .spacing = 0.05})) {
        const Vec3 out = Vec3(bud.place.x(), 0.0F, bud.place.z()).normalized();
        QVERIFY(std::abs(bud.direction.norm() - 1.0F) < 1e-5F);
        QVERIFY(bud.direction.dot(out) > 0.7F);
        QVERIFY(bud.direction.y() > 0.2F); // light comes from above
    }
}

void AddBudsTest::branches_areAttachedAlongTheWood()
{
    TreeDocument document;
    plantTrunk(document);
    const std::uint32_t before = document.tree().size();
    const BudSpiral spiral{.internode = 6, .along = 0.5, .count = 5, .spacing = 0.03};
    const std::vector<BarkBud> shown = shownBuds(document, spiral);
    QCOMPARE(addBuds(document, spiral), 5);
    const Tree& tree = document.tree();
    for (InternodeId id = before; id < tree.size(); ++id) {
        const BarkBud& bud = shown[id - before];
        QCOMPARE(tree.parent(id), bud.internode);
        QCOMPARE(budKind(tree.columns().slot[id]), BudKind::Adventitious);
        QVERIFY(tree.columns().along[id] > 0.0F && tree.columns().along[id] < 1.0F);
        QVERIFY((document.index().basePosition(tree, id) - bud.base).norm() < 1e-4F);
        QVERIFY((document.index().nodePosition(id) - bud.place).norm() < 1e-4F);
        QCOMPARE(tree.buds(id), kTerminalBud);
        QCOMPARE(document.index().axis(id), id);
    }
}

void AddBudsTest::shortAxis_hasAllBudsCloserTogether()
{
    TreeDocument document;
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    document.reset(1, parameters);
    const std::vector<BarkBud> buds = shownBuds(document, {.internode = 0, .count = 8, .spacing = 1.0});
    QCOMPARE(buds.size(), 8U);
    for (std::size_t i = 1; i < buds.size(); ++i)
        QVERIFY(buds[i].place.y() > buds[i - 1].place.y());
    QVERIFY(buds.back().place.y() < 0.11F);
    QCOMPARE(addBuds(document, {.internode = 0, .count = 8, .spacing = 1.0}), 8);
    QCOMPARE(treeFault(document.tree().content()), QString());
}

void AddBudsTest::ground_hasNoBudsBelowIt()
{
    TreeDocument document;
    plantTrunk(document);
    // A trunk that lies on the ground has buds on its upper side alone.
    TreeDelta delta = deltaStartingAt(document.tree());
    const Rotation level(Eigen::AngleAxisf(static_cast<float>(radians(90)), Vec3::UnitX()));
    delta.addFrame(0, document.tree().columns().rotation[0], level, document.tree().length(0),
                   document.tree().length(0));
    apply(document, std::move(delta));
    const std::vector<BarkBud> buds = shownBuds(document, {.internode = 6, .count = 8, .spacing = 0.05});
    QVERIFY(buds.size() > 2 && buds.size() < 8);
    for (const BarkBud& bud : buds)
        QVERIFY(bud.place.y() >= 0.0F);
}

void AddBudsTest::samePlace_canHaveBudsAgain()
{
    TreeDocument document;
    plantTrunk(document);
    for (int i = 1; i <= 5; ++i) {
        QCOMPARE(addBuds(document, {.internode = 6, .count = 8, .spacing = 0.0}), 8);
        QCOMPARE(treeFault(document.tree().content()), QString()); // also finds keys that are not unique
    }
    QCOMPARE(indexFault(document), QString());
}

void AddBudsTest::buds_growIntoBranchesAfterAPrune()
{
    TreeDocument document;
    document.reset(3);
    grow(document, 12);
    // The crown goes, a trunk without buds stays.
    InternodeId cut = 0;
    for (int i = 0; i < 6; ++i)
        cut = document.index().mainChild(cut);
    std::vector<InternodeId> cuts{cut};
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        const InternodeId parent = document.tree().parent(id);
        if (parent != kNoInternode && document.index().axis(id) == id && document.index().axis(parent) == 0)
            cuts.push_back(id);
    }
    pruneBranches(document, cuts);
    const InternodeId stump = document.tree().parent(cut);
    const std::uint32_t before = document.tree().size();
    QCOMPARE(addBuds(document, {.internode = stump, .count = 5, .spacing = 0.03}), 5);
    QVERIFY(grow(document, 8) == 8);
    int branches = 0;
    for (InternodeId id = before; id < before + 5; ++id)
        branches += document.tree().isAlive(id) && document.index().subtreeSize(id) > 10 ? 1 : 0;
    QVERIFY2(branches >= 2, qPrintable(QString::number(branches)));
    QCOMPARE(indexFault(document), QString());
}

void AddBudsTest::oneBud_canGrowAlone()
{
    TreeDocument document;
    plantTrunk(document);
    const InternodeId bud = document.tree().size();
    QCOMPARE(addBuds(document, {.internode = 5, .count = 3, .spacing = 0.05}), 3);
    QVERIFY(grow(document, 5, {bud, kTerminalSlot}) > 0);
    QVERIFY(document.index().subtreeSize(bud) > 3);
    QCOMPARE(document.index().subtreeSize(bud + 1), 1U);
    // Its axis goes on in the direction of the bud.
    const InternodeId next = document.index().mainChild(bud);
    QVERIFY(next != kNoInternode);
    QVERIFY(document.index().heading(next).dot(document.index().heading(bud)) > 0.6F);
}

void AddBudsTest::deadAndUnknown_haveNoBuds()
{
    TreeDocument document;
    grow(document, 8);
    pruneBranches(document, std::array{InternodeId{3}});
    const DocumentState before(document);
    for (const InternodeId id : {InternodeId{3}, document.tree().size(), kNoInternode})
        QCOMPARE(addBuds(document, {.internode = id}), 0);
    QVERIFY(DocumentState(document) == before);
}

void AddBudsTest::recipe_givesTheSameDocument()
{
    TreeDocument document;
    grow(document, 8);
    pruneBranches(document, std::array{InternodeId{5}});
    QVERIFY(addBuds(document,
                    {.internode = 2, .along = 0.123, .azimuth = -66.6, .count = 7, .spacing = 0.044}) > 0);
    grow(document, 4);
    QCOMPARE(replayFault(document), QString());
}

static const TestClass<AddBudsTest> addBudsTest;

} // namespace espalier::test

#include "AddBudsTest.moc"
