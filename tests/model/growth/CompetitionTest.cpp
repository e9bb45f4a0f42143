// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Competition.h"

#include "model/growth/Buds.h"
#include "model/growth/GrowthIndex.h"
#include "tests/support/BruteForce.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class CompetitionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void perceptionAngle_isTheFullApexAngle();
    void perception_reachesFromOccupancyToItsDepth();
    void marker_goesToTheNearestBudThatPerceivesIt();
    void budsOfOneNode_shareByDirection();
    void space_isTheMeanOfUnitVectors();
    void competition_isWhatBruteForceFinds();
    void laterRounds_areWhatBruteForceFinds();
    void selected_competeWhileAllClear();
    void afterTheRound_noMarkerIsNearABud();
    void result_doesNotDependOnThreads();
    void markers_keepTheirOrderWhenSomeGo();
};

namespace {

MarkerSet markersAround(const TreeIndex& index, const Tree& tree, const Perception& perception,
                        Random& random, int count)
{
    MarkerSet markers;
    for (int i = 0; i < count; ++i) {
        auto id = static_cast<InternodeId>(random.bits() % tree.size());
        markers.positions.push_back(index.nodePosition(id) + 1.5F * perception.reach * random.inBall());
        markers.born.push_back(static_cast<Step>(i));
    }
    return markers;
}

MarkerSet setOf(std::initializer_list<Vec3> positions)
{
    return {positions, std::vector<Step>(positions.size(), 0)};
}

/// The first round of a growth step.
std::vector<EnabledBud> compete(const TreeDocument& document, GrowingTree& growing,
                                const Perception& perception, const Competitors& competitors,
                                MarkerSet& markers)
{
    Competition competition(growing, document.growthModel().space(), perception, competitors, markers);
    competition.admit();
    return competition.enabled();
}

/// A seedling of which only the terminal bud at (0, l, 0) lives.
struct Seedling {
    explicit Seedling(double perceptionAngle)
    {
        TreeParameters parameters;
        parameters.growth.internodeLength = 1.0;
        parameters.growth.occupancyRadius = 1.0;
        parameters.growth.perceptionDepth = 3.0;
        parameters.growth.perceptionAngle = perceptionAngle;
        document.reset(1, parameters);
    }
    std::vector<EnabledBud> compete(MarkerSet markers)
    {
        GrowthWorkspace workspace;
        GrowingTree growing(document.tree(), document.index(), workspace);
        return test::compete(document, growing, Perception::of(document.parameters().growth), {}, markers);
    }
    bool perceives(double angle, float distance)
    {
        const Vec3 direction(static_cast<float>(std::sin(angle)), static_cast<float>(std::cos(angle)), 0.0F);
        return !compete(setOf({Vec3(0.0F, 1.0F, 0.0F) + distance * direction})).empty();
    }
    TreeDocument document;
};

void compare(const std::vector<EnabledBud>& found, const std::vector<EnabledBud>& expected,
             std::uint64_t seed)
{
    const QByteArray where = "seed " + QByteArray::number(static_cast<qulonglong>(seed));
    QVERIFY2(found.size() == expected.size(), where.constData());
    for (std::size_t i = 0; i < found.size(); ++i) {
        QVERIFY2(found[i].bud == expected[i].bud, where.constData());
        QVERIFY2((found[i].space - expected[i].space).norm() < 1e-3F, where.constData());
    }
}

} // namespace

void CompetitionTest::perceptionAngle_isTheFullApexAngle()
{
    Seedling seedling(radians(90));
    QVERIFY(seedling.perceives(radians(44), 2.0F));
    QVERIFY(!seedling.perceives(radians(46), 2.0F));
    Seedling all(radians(360));
    QVERIFY(all.perceives(radians(179), 2.0F));
}

void CompetitionTest::perception_reachesFromOccupancyToItsDepth()
{
    Seedling seedling(radians(90));
    QVERIFY(!seedling.perceives(0.1, 0.99F));
    QVERIFY(seedling.perceives(0.1, 1.01F));
    QVERIFY(seedling.perceives(0.1, 3.99F));
    QVERIFY(!seedling.perceives(0.1, 4.01F));
}

void CompetitionTest::marker_goesToTheNearestBudThatPerceivesIt()
{
    // A trunk of two: the marker is nearer to the upper node, whose buds look away from it.
    TreeParameters parameters;
    GrowthParameters& p = parameters.growth;
    p.internodeLength = 1.0;
    p.irregularity = 0.0;
    p.occupancyRadius = 0.5;
    p.perceptionDepth = 5.0;
    p.perceptionAngle = radians(90);
    p.branchingAngle = radians(60);
    TreeDocument document;
    document.reset(1, parameters);
    GrowthWorkspace workspace;
    GrowingTree growing(document.tree(), document.index(), workspace);
    const InternodeId lower = growing.grow(0, kTerminalSlot, up(), 0.0, 1.0, 1.0);
    const InternodeId upper = growing.grow(lower, kTerminalSlot, up(), std::numbers::pi, 1.0, 1.0);
    const Vec3 side = growing.rotation(lower) * Vec3(Vec3::UnitX()); // where the lower node's lateral is
    const Vec3 marker = growing.nodePosition(upper) + 1.5F * side + 0.2F * up();
    MarkerSet markers = setOf({marker});
    const auto enabled = compete(document, growing, Perception::of(p), {}, markers);
    QCOMPARE(enabled.size(), std::size_t{1});
    QVERIFY(enabled[0].bud == (BudRef{lower, 0}));
    QVERIFY((enabled[0].space - (marker - growing.nodePosition(lower)).normalized()).norm() < 1e-5F);
}

void CompetitionTest::budsOfOneNode_shareByDirection()
{
    TreeParameters parameters;
    GrowthParameters& p = parameters.growth;
    p.internodeLength = 1.0;
    p.irregularity = 0.0;
    p.occupancyRadius = 0.5;
    p.perceptionAngle = radians(360);
    p.lateralsPerNode = 4;
    p.branchingAngle = radians(80);
    TreeDocument document;
    document.reset(1, parameters);
    GrowthWorkspace workspace;
    GrowingTree growing(document.tree(), document.index(), workspace);
    const InternodeId node = growing.grow(0, kTerminalSlot, up(), 0.0, 1.0, 1.0);
    MarkerSet markers;
    for (int slot : {0, 1, 2, 3, kTerminalSlot}) {
        markers.positions.push_back(growing.nodePosition(node) +
                                    budDirection(growing.key(node), slot, growing.rotation(node), p));
        markers.born.push_back(0);
    }
    const auto enabled = compete(document, growing, Perception::of(p), {}, markers);
    QCOMPARE(enabled.size(), std::size_t{5});
    for (std::size_t i = 0; i < enabled.size(); ++i) {
        const BudRef bud = enabled[i].bud;
        QVERIFY(
            (enabled[i].space - budDirection(growing.key(bud.node), bud.slot, growing.rotation(bud.node), p))
                .norm() < 1e-4F);
    }
}

void CompetitionTest::space_isTheMeanOfUnitVectors()
{
    Seedling seedling(radians(180));
    const Vec3 bud(0.0F, 1.0F, 0.0F);
    const auto enabled =
        seedling.compete(setOf({bud + 3.5F * Vec3(0.6F, 0.8F, 0.0F), bud + 1.5F * Vec3(0.0F, 0.8F, 0.6F)}));
    QCOMPARE(enabled.size(), std::size_t{1});
    QVERIFY((enabled[0].space - Vec3(0.6F, 1.6F, 0.6F).normalized()).norm() < 1e-5F);
}

void CompetitionTest::competition_isWhatBruteForceFinds()
{
    std::size_t seen = 0;
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        Random random(seed, 1, 0, Purpose::BrushMarker);
        const Perception perception = Perception::of(document.parameters().growth);
        GrowthWorkspace workspace;
        GrowingTree growing(document.tree(), document.index(), workspace);
        MarkerSet markers = clearCut(
            growing, perception, markersAround(document.index(), document.tree(), perception, random, 300));
        const BruteCompetition expected = bruteCompetition(growing, perception, {}, markers);
        const auto found = compete(document, growing, perception, {}, markers);
        QVERIFY(markers.positions == expected.freeMarkers);
        compare(found, expected.enabled, seed);
        seen += found.size();
    }
    QVERIFY(seen > 500);
}

void CompetitionTest::laterRounds_areWhatBruteForceFinds()
{
    std::size_t seen = 0;
    for (std::uint64_t seed = 200; seed < 230; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        Random random(seed, 1, 0, Purpose::BrushMarker);
        const GrowthParameters& p = document.parameters().growth;
        const Perception perception = Perception::of(p);
        GrowthWorkspace workspace;
        GrowingTree growing(document.tree(), document.index(), workspace);
        MarkerSet markers = clearCut(
            growing, perception, markersAround(document.index(), document.tree(), perception, random, 400));
        // Some markers are added later than others.
        MarkerSet late;
        for (std::size_t i = markers.size() / 2; i < markers.size(); ++i) {
            late.positions.push_back(markers.positions[i]);
            late.born.push_back(markers.born[i]);
        }
        markers.filter([&](std::size_t i) { return i < markers.size() / 2; });
        Competition competition(growing, document.growthModel().space(), perception, {}, markers);
        competition.admit();
        markers.positions.insert(markers.positions.end(), late.positions.begin(), late.positions.end());
        markers.born.insert(markers.born.end(), late.born.begin(), late.born.end());
        competition.admit();
        auto enabled = competition.enabled();
        for (int round = 0; round < 3; ++round) {
            for (std::size_t i = 0; i < enabled.size(); i += 1 + random.bits() % 2) {
                const auto [node, slot] = enabled[i].bud;
                const Vec3 direction = (enabled[i].space + 0.3F * random.direction()).normalized();
                growing.grow(node, slot, direction, p.phyllotaxis, p.internodeLength, 1.0);
            }
            const BruteCompetition expected = bruteCompetition(growing, perception, {}, markers);
            const bool isClear = clearCut(growing, perception, markers).size() == markers.size();
            competition.repeat();
            enabled = competition.enabled();
            if (!isClear)
                break; // rounding decides for a marker
            QVERIFY(markers.positions == expected.freeMarkers);
            compare(enabled, expected.enabled, seed);
            std::erase_if(enabled,
                          [&](const EnabledBud& bud) { return bud.bud.node < growing.tree().size(); });
            const auto ofNewNodes = competition.enabled(growing.tree().size());
            QVERIFY(std::ranges::equal(ofNewNodes, enabled, {}, &EnabledBud::bud, &EnabledBud::bud));
            seen += enabled.size();
        }
    }
    QVERIFY(seen > 200);
}

void CompetitionTest::selected_competeWhileAllClear()
{
    std::size_t seen = 0;
    for (std::uint64_t seed = 300; seed < 320; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        const Tree& tree = document.tree();
        Random random(seed, 1, 0, Purpose::BrushMarker);
        // A living lateral: the branch that has grown from it, or the bud itself.
        Competitors competitors;
        for (int attempt = 0; attempt < 200 && competitors.node == kNoInternode; ++attempt) {
            const auto id = static_cast<InternodeId>(random.bits() % tree.size());
            if (tree.isAlive(id) && id > 0)
                competitors =
                    attempt % 2 == 0
                        ? Competitors{tree.parent(id), tree.columns().slot[id]}
                        : Competitors{id, tree.buds(id) != 0 ? std::countr_zero(unsigned{tree.buds(id)}) : 0};
        }
        const Perception perception = Perception::of(document.parameters().growth);
        GrowthWorkspace workspace;
        GrowingTree growing(tree, document.index(), workspace);
        MarkerSet markers =
            clearCut(growing, perception, markersAround(document.index(), tree, perception, random, 300));
        const BruteCompetition everybody = bruteCompetition(growing, perception, {}, markers);
        const BruteCompetition expected = bruteCompetition(growing, perception, competitors, markers);
        const auto found = compete(document, growing, perception, competitors, markers);
        QVERIFY(markers.positions == everybody.freeMarkers);
        compare(found, expected.enabled, seed);
        seen += found.size();
    }
    QVERIFY(seen > 50);
}

void CompetitionTest::afterTheRound_noMarkerIsNearABud()
{
    for (std::uint64_t seed = 400; seed < 410; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        const Tree& tree = document.tree();
        Random random(seed, 1, 0, Purpose::BrushMarker);
        const Perception perception = Perception::of(document.parameters().growth);
        GrowthWorkspace workspace;
        GrowingTree growing(tree, document.index(), workspace);
        MarkerSet markers = markersAround(document.index(), tree, perception, random, 1500);
        const std::size_t before = markers.size();
        compete(document, growing, perception, {}, markers);
        QVERIFY(markers.size() < before);
        for (const Vec3& marker : markers.positions) {
            for (InternodeId id = 0; id < tree.size(); ++id) {
                if (tree.isAlive(id) && tree.buds(id) != 0)
                    QVERIFY((marker - document.index().nodePosition(id)).norm() >=
                            0.99999F * perception.occupancy);
            }
        }
    }
}

void CompetitionTest::result_doesNotDependOnThreads()
{
    TreeDocument document;
    growAtRandom(document, 500, 200, 400);
    const Perception perception = Perception::of(document.parameters().growth);
    const auto competeOn = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        Random random(1, 1, 0, Purpose::BrushMarker);
        GrowthWorkspace workspace;
        GrowingTree growing(document.tree(), document.index(), workspace);
        MarkerSet markers = markersAround(document.index(), document.tree(), perception, random, 20000);
        auto enabled = compete(document, growing, perception, {}, markers);
        return std::pair(enabled, markers.positions);
    };
    const auto [one, oneMarkers] = competeOn(1);
    QVERIFY(!one.empty());
    for (const std::size_t threads : {2, 4}) {
        const auto [many, manyMarkers] = competeOn(threads);
        QVERIFY(manyMarkers == oneMarkers);
        QCOMPARE(many.size(), one.size());
        for (std::size_t i = 0; i < one.size(); ++i) {
            QVERIFY(many[i].bud == one[i].bud);
            QCOMPARE(many[i].space, one[i].space); // to the last bit
        }
    }
}

void CompetitionTest::markers_keepTheirOrderWhenSomeGo()
{
    MarkerSet markers;
    for (Step i = 0; i < 100; ++i) {
        markers.positions.emplace_back(static_cast<float>(i), 0.0F, 0.0F);
        markers.born.push_back(i);
    }
    markers.filter([](std::size_t i) { return i % 3 != 0; });
    QCOMPARE(markers.size(), std::size_t{66});
    QVERIFY(std::ranges::is_sorted(markers.born));
    for (std::size_t i = 0; i < markers.size(); ++i) {
        QVERIFY(markers.born[i] % 3 != 0);
        QCOMPARE(markers.positions[i].x(), static_cast<float>(markers.born[i]));
    }
}

const TestClass<CompetitionTest> competitionTest;

} // namespace espalier::test

#include "CompetitionTest.moc"
