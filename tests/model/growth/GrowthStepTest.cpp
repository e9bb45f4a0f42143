// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthStep.h"

#include "commands/SetParameters.h"
#include "model/growth/BorchertHonda.h"
#include "model/growth/Buds.h"
#include "tests/support/BruteForce.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>
#include <set>

namespace espalier::test {

class GrowthStepTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shootLength_isTheFloorOfTheShare();
    void shootLength_doesNotDependOnTheScaleOfVigour();
    void shoots_startExactlyWhereBruteForceSays();
    void shoots_areAsLongAsTheirVigourAllows();
    void shoots_withMarkersInPlenty_areExactlyAsLong();
    void strongestEnabledBud_growsTheLongestShoot();
    void withoutMarkers_nothingGrows();
    void selectedBud_growsAlone();
    void branches_areShedWhereBruteForceSays();
    void internodes_areAsLongAsAsked();
    void laterals_startAtTheBranchingAngle();
    void nodes_turnByThePhyllotacticAngle();
    void axis_turnsAwayFromAStartingLateral();
    void grownTree_isConsistent();
    void leastVigour_ofOneLeavesTheStrongestAlone();
    void leader_reachesForTheTarget();
    void autonomousStep_goesOnWhereTheStrongestAreHemmedIn();
};

namespace {

MarkerSet markersIn(const Vec3& centre, float radius, int count, std::uint64_t seed)
{
    Random random(seed, 0, 0, Purpose::BrushMarker);
    MarkerSet markers;
    for (int i = 0; i < count; ++i) {
        markers.positions.push_back(centre + radius * random.inBall());
        markers.born.push_back(0);
    }
    return markers;
}

/// A step of growth toward random markers in a random tree, and the state before it.
struct Step1 {
    explicit Step1(std::uint64_t seed, double shedding = 0.0)
    {
        growAtRandom(document, seed, 60, 260);
        TreeParameters parameters = document.parameters();
        parameters.growth.shedding = shedding;
        parameters.growth.maxShootLength = 3 + static_cast<int>(seed % 4);
        setParameters(document, parameters);

        const Perception perception = Perception::of(parameters.growth);
        const GrowingTree growing(tree(), index(), workspace);
        Random random(seed, 1, 0, Purpose::BrushMarker);
        for (int i = 0; i < 400; ++i) {
            const auto id = static_cast<InternodeId>(random.bits() % tree().size());
            markers.positions.push_back(index().nodePosition(id) + 1.3F * perception.reach * random.inBall());
            markers.born.push_back(0);
        }
        markers = clearCut(growing, perception, markers);
        expected = bruteCompetition(growing, perception, {}, markers);
    }

    void step(const GrowthStepOptions& options)
    {
        delta = growthStep(tree(), index(), growthIndexOf(document), markers, options, workspace);
    }
    void step() { step(GrowthStepOptions::of(document.parameters().growth)); }

    /// n of each enabled bud, without those for which rounding decides.
    std::map<BudRef, int> lengths() const
    {
        const BruteVigour vigour(tree(), index());
        double greatest = 0.0;
        for (const EnabledBud& bud : expected.enabled)
            greatest = std::max(greatest, vigour.ofBud.at(bud.bud));
        std::map<BudRef, int> result;
        const int longest = document.parameters().growth.maxShootLength;
        for (const EnabledBud& bud : expected.enabled) {
            const double n = greatest > 0.0 ? vigour.ofBud.at(bud.bud) / greatest * longest : 0.0;
            const bool isStrongest = vigour.ofBud.at(bud.bud) == greatest;
            if (isStrongest || std::abs(n - std::round(n)) > 1e-3)
                result[bud.bud] = isStrongest && greatest > 0.0 ? longest : static_cast<int>(n);
        }
        return result;
    }
    /// Number of internodes that each old bud has become.
    std::map<BudRef, int> grown() const
    {
        std::map<BudRef, int> result;
        std::vector<BudRef> origin;
        for (std::uint32_t i = 0; i < delta.born.count; ++i) {
            const InternodeId parent = delta.rows->internodes.parent[i];
            origin.push_back(delta.born.contains(parent) ? origin[parent - delta.born.first]
                                                         : BudRef{parent, delta.rows->internodes.slot[i]});
            ++result[origin.back()];
        }
        return result;
    }

    const Tree& tree() const { return document.tree(); }
    const TreeIndex& index() const { return document.index(); }

    TreeDocument document;
    GrowthWorkspace workspace;
    MarkerSet markers;
    BruteCompetition expected;
    TreeDelta delta;
};

/// Parameters of a diagram: no irregularity, straight on, no tropism, no shedding.
TreeParameters diagram()
{
    TreeParameters parameters;
    GrowthParameters& p = parameters.growth;
    p.irregularity = 0.0;
    p.straightening = 0.0;
    p.axisWeight = 1.0;
    p.tropismWeight = p.spaceWeight = 0.0;
    p.shedding = 0.0;
    p.deflectionAngle = 0.0;
    return parameters;
}

} // namespace

void GrowthStepTest::shootLength_isTheFloorOfTheShare()
{
    QCOMPARE(shootLength(10.0, 10.0, 5), 5);
    QCOMPARE(shootLength(9.99, 10.0, 5), 4);
    QCOMPARE(shootLength(2.0, 10.0, 5), 1);
    QCOMPARE(shootLength(1.99, 10.0, 5), 0);
    QCOMPARE(shootLength(0.0, 10.0, 5), 0);
    QCOMPARE(shootLength(0.0, 0.0, 5), 0);
    Random random(1, 0, 0, Purpose::ShootLength);
    for (int i = 0; i < 1000; ++i) {
        const double greatest = std::pow(10.0, random.uniform(-12, 12));
        const int longest = 1 + static_cast<int>(random.bits() % 40);
        QCOMPARE(shootLength(greatest, greatest, longest), longest);
    }
}

void GrowthStepTest::shootLength_doesNotDependOnTheScaleOfVigour()
{
    Random random(2, 0, 0, Purpose::ShootLength);
    for (int i = 0; i < 1000; ++i) {
        const double greatest = random.uniform(0.1, 10.0);
        const double vigour = greatest * random.uniform();
        const int longest = 1 + static_cast<int>(random.bits() % 40);
        for (const double scale : {0x1p-30, 0.125, 2.0, 0x1p40})
            QCOMPARE(shootLength(scale * vigour, scale * greatest, longest),
                     shootLength(vigour, greatest, longest));
    }
}

void GrowthStepTest::shoots_startExactlyWhereBruteForceSays()
{
    std::size_t started = 0;
    for (std::uint64_t seed = 1; seed <= 25; ++seed) {
        Step1 one(seed);
        const auto lengths = one.lengths();
        one.step();
        const auto grown = one.grown();
        const double length = one.tree().parameters().growth.internodeLength;
        for (const auto& [bud, n] : lengths) {
            // Near the ground, a shoot that would go below it does not start.
            if (static_cast<double>(one.index().nodePosition(bud.node).y()) < 2.0 * length)
                continue;
            QVERIFY2(grown.contains(bud) == (n > 0), qPrintable(QStringLiteral("seed %1").arg(seed)));
            started += n > 0 ? 1 : 0;
        }
        // No other buds grow.
        for (const auto& [bud, count] : grown)
            QVERIFY(
                std::ranges::any_of(one.expected.enabled, [&](const EnabledBud& e) { return e.bud == bud; }));
    }
    QVERIFY(started > 150);
}

void GrowthStepTest::shoots_areAsLongAsTheirVigourAllows()
{
    for (std::uint64_t seed = 30; seed < 55; ++seed) {
        Step1 one(seed);
        const auto lengths = one.lengths();
        one.step();
        std::uint32_t sum = 0;
        for (const auto& [bud, count] : one.grown()) {
            sum += static_cast<std::uint32_t>(count);
            if (lengths.contains(bud))
                QVERIFY(count <= lengths.at(bud));
        }
        QCOMPARE(one.delta.born.count, sum);
    }
}

void GrowthStepTest::shoots_withMarkersInPlenty_areExactlyAsLong()
{
    // Straight shoots that a small zone keeps apart, in a cloud of markers that leaves none wanting.
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        TreeParameters parameters = diagram();
        GrowthParameters& p = parameters.growth;
        p.internodeLength = 0.1;
        p.occupancyRadius = 0.5;
        p.perceptionDepth = 2.0;
        p.perceptionAngle = radians(120);
        p.branchingAngle = radians(60);
        p.maxShootLength = 3;
        TreeDocument document;
        document.reset(seed, parameters);
        GrowthWorkspace workspace;
        const GrowthStepOptions options = GrowthStepOptions::of(p);
        for (int step = 0; step < 3; ++step) {
            MarkerSet markers =
                markersIn({0.0F, 0.6F, 0.0F}, 1.6F, 120000, seed + static_cast<std::uint64_t>(step));
            MarkerSet same = markers;
            GrowingTree growing(document.tree(), document.index(), workspace);
            Competition competition(growing, document.growthModel().space(), options.perception, {}, same);
            competition.admit();
            const auto enabled = competition.enabled();
            VigourFlow flow(document.tree(), document.index(), growthIndexOf(document), workspace.vigour);
            double greatest = 0.0;
            for (const EnabledBud& bud : enabled)
                greatest = std::max(greatest, flow.ofBud(bud.bud.node, bud.bud.slot));
            int sum = 0;
            for (const EnabledBud& bud : enabled)
                sum += shootLength(flow.ofBud(bud.bud.node, bud.bud.slot), greatest, p.maxShootLength);
            TreeDelta delta = growthStep(document.tree(), document.index(), growthIndexOf(document), markers,
                                         options, workspace);
            QCOMPARE(static_cast<int>(delta.born.count), sum);
            QVERIFY(sum > 0);
            apply(document, std::move(delta));
        }
    }
}

void GrowthStepTest::strongestEnabledBud_growsTheLongestShoot()
{
    // A lone seedling is the strongest shoot.
    TreeParameters parameters = diagram();
    for (int longest : {1, 4, 12}) {
        parameters.growth.maxShootLength = longest;
        TreeDocument document;
        document.reset(1, parameters);
        MarkerSet markers = markersIn({0.0F, 1.5F, 0.0F}, 1.6F, 60000, 1);
        GrowthWorkspace workspace;
        const TreeDelta delta = growthStep(document.tree(), document.index(), growthIndexOf(document),
                                           markers, GrowthStepOptions::of(parameters.growth), workspace);
        QCOMPARE(static_cast<int>(delta.born.count), longest);
        for (const float vigour : delta.rows->internodes.vigour)
            QCOMPARE(vigour, 1.0F);
    }
}

void GrowthStepTest::withoutMarkers_nothingGrows()
{
    Step1 one(60);
    one.markers.clear();
    one.step();
    QVERIFY(one.delta.isEmpty());
    QCOMPARE(one.delta.stepAfter, one.delta.stepBefore);
}

void GrowthStepTest::selectedBud_growsAlone()
{
    std::size_t grown = 0;
    for (std::uint64_t seed = 70; seed < 85; ++seed) {
        Step1 one(seed);
        GrowthStepOptions options = GrowthStepOptions::of(one.document.parameters().growth);
        const BudRef chosen = one.expected.enabled[one.expected.enabled.size() / 2].bud;
        options.competitors = {chosen.node, chosen.slot};
        one.step(options);
        for (const auto& [bud, count] : one.grown()) {
            QVERIFY(bud == chosen);
            // It alone is enabled, so it is the strongest: it may grow to the full length.
            QVERIFY(count <= one.document.parameters().growth.maxShootLength);
            ++grown;
        }
    }
    QVERIFY(grown > 10);
}

void GrowthStepTest::branches_areShedWhereBruteForceSays()
{
    std::size_t shed = 0;
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
        Step1 one(seed, 0.35);
        one.step();
        std::vector<Vec3> born;
        if (one.delta.born.count > 0) {
            // Positions after the step.
            Tree tree = one.tree();
            TreeDelta births = deltaStartingAt(tree);
            births.born = one.delta.born;
            births.rows = std::make_shared<TreeRows>(*one.delta.rows);
            tree.apply(births);
            const TreeIndex index(tree);
            for (InternodeId id = births.born.first; id != births.born.end(); ++id)
                born.push_back(index.nodePosition(id));
        }
        std::vector<InternodeId> growingAt;
        for (const auto& [bud, count] : one.grown())
            growingAt.push_back(bud.node);
        std::vector<InternodeId> died = one.delta.died;
        std::ranges::sort(died);
        QVERIFY2(died == bruteShedding(one.tree(), one.index(), born, growingAt),
                 qPrintable(QStringLiteral("seed %1").arg(seed)));
        shed += died.size();
    }
    QVERIFY(shed > 20);
}

void GrowthStepTest::internodes_areAsLongAsAsked()
{
    for (std::uint64_t seed = 150; seed < 160; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 100, 300);
        const Tree& tree = document.tree();
        double sum = 0.0;
        for (InternodeId id = 1; id < tree.size(); ++id) {
            const GrowthParameters& p = tree.parametersOf(id).growth;
            const double relative = static_cast<double>(tree.length(id)) / p.internodeLength;
            if (p.irregularity == 0.0)
                // Rather than go below the ground, an internode is half as long.
                QVERIFY(std::abs(relative - 1.0) < 1e-6 || std::abs(relative - 0.5) < 1e-6);
            QVERIFY(relative > (p.irregularity == 0.0 ? 0.3 : 0.15) && relative < 2.0);
            sum += relative;
            const float distance =
                (document.index().nodePosition(id) - document.index().basePosition(tree, id)).norm();
            QVERIFY(std::abs(distance - tree.length(id)) < 1e-5F);
        }
        // The mean is exact.
        QVERIFY(std::abs(sum / (tree.size() - 1) - 1.0) < 0.1);
    }
}

void GrowthStepTest::laterals_startAtTheBranchingAngle()
{
    TreeParameters parameters = diagram();
    parameters.growth.branchingAngle = radians(47);
    parameters.growth.lateralsPerNode = 2;
    TreeDocument document;
    document.reset(3, parameters);
    QVERIFY(grow(document, 12) > 5);
    const Tree& tree = document.tree();
    int laterals = 0;
    for (InternodeId id = 1; id < tree.size(); ++id) {
        const Vec3 before = document.index().heading(tree.parent(id));
        const double angle =
            std::acos(std::clamp(static_cast<double>(before.dot(document.index().heading(id))), -1.0, 1.0));
        QVERIFY(std::abs(degrees(angle) - (tree.continuesAxis(id) ? 0.0 : 47.0)) < 0.1);
        laterals += tree.continuesAxis(id) ? 0 : 1;
    }
    QVERIFY(laterals > 10);
}

void GrowthStepTest::nodes_turnByThePhyllotacticAngle()
{
    // The golden angle, 360° (1 − 1/φ).
    const double golden = 360.0 * (1.0 - 2.0 / (1.0 + std::sqrt(5.0)));
    QVERIFY(std::abs(golden - 137.507764) < 1e-6);
    for (const double phyllotaxis : {golden, 180.0, 90.0, 0.0}) {
        TreeParameters parameters = diagram();
        parameters.growth.phyllotaxis = radians(phyllotaxis);
        TreeDocument document;
        document.reset(1, parameters);
        grow(document, 8);
        const Tree& tree = document.tree();
        int turned = 0;
        for (InternodeId id = 1; id < tree.size(); ++id) {
            if (!tree.continuesAxis(id))
                continue;
            // The axes are straight, so their frames differ by a turn about them.
            const Vec3 first = document.index().rotation(tree.parent(id)).conjugate() *
                               (document.index().rotation(id) * Vec3(Vec3::UnitX()));
            const double angle =
                degrees(std::atan2(-static_cast<double>(first.z()), static_cast<double>(first.x())));
            QVERIFY(std::abs(std::remainder(angle - phyllotaxis, 360.0)) < 0.05);
            ++turned;
        }
        QVERIFY(turned > 10);
    }
}

void GrowthStepTest::axis_turnsAwayFromAStartingLateral()
{
    TreeParameters parameters = diagram();
    GrowthParameters& p = parameters.growth;
    p.deflectionAngle = radians(12);
    p.maxShootLength = 1;
    p.apicalDominance = 0.5;
    TreeDocument document;
    document.reset(1, parameters);
    grow(document, 12);
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    int deflected = 0;
    for (InternodeId id = 1; id < tree.size(); ++id) {
        const InternodeId parent = tree.parent(id);
        if (!tree.continuesAxis(id))
            continue;
        InternodeId lateral = kNoInternode;
        for (InternodeId child = index.firstChild(parent); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (!tree.continuesAxis(child) && tree.birth(child) <= tree.birth(id))
                lateral = child;
        }
        const double angle = std::acos(
            std::clamp(static_cast<double>(index.heading(parent).dot(index.heading(id))), -1.0, 1.0));
        QVERIFY2(std::abs(degrees(angle) - (lateral == kNoInternode ? 0.0 : 12.0)) < 0.1,
                 qPrintable(QStringLiteral("internode %1 on %2").arg(id).arg(parent)));
        if (lateral == kNoInternode)
            continue;
        ++deflected;
        // Away from the lateral, in one plane with it.
        const Vec3 sideways =
            index.heading(id) - index.heading(id).dot(index.heading(parent)) * index.heading(parent);
        const Vec3 toLateral = index.heading(lateral) -
                               index.heading(lateral).dot(index.heading(parent)) * index.heading(parent);
        QVERIFY(sideways.normalized().dot(toLateral.normalized()) < -0.999F);
    }
    QVERIFY(deflected > 3);
}

void GrowthStepTest::grownTree_isConsistent()
{
    for (std::uint64_t seed = 170; seed < 190; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed);
        const Tree& tree = document.tree();
        const Result<Tree> read = Tree::fromContent(tree.content());
        QVERIFY2(static_cast<bool>(read), read ? "" : qPrintable(read.error().message));
        QVERIFY(*read == tree);
        for (InternodeId id = 1; id < tree.size(); ++id) {
            QVERIFY(tree.parent(id) < id);
            QVERIFY(document.index().nodePosition(id).allFinite());
            // A bud that has become an internode does not exist any more.
            QVERIFY((tree.buds(tree.parent(id)) & budBit(tree.columns().slot[id])) == 0);
        }
    }
}

void GrowthStepTest::leastVigour_ofOneLeavesTheStrongestAlone()
{
    for (std::uint64_t seed = 200; seed < 210; ++seed) {
        Step1 one(seed);
        GrowthStepOptions options = GrowthStepOptions::of(one.document.parameters().growth);
        options.leastVigour = 1.0;
        one.step(options);
        const auto grown = one.grown();
        QVERIFY(!grown.empty());
        const BruteVigour vigour(one.tree(), one.index());
        double greatest = 0.0;
        for (const EnabledBud& bud : one.expected.enabled)
            greatest = std::max(greatest, vigour.ofBud.at(bud.bud));
        for (const auto& [bud, count] : grown)
            QVERIFY(vigour.ofBud.at(bud) > 0.999 * greatest);
    }
}

void GrowthStepTest::leader_reachesForTheTarget()
{
    const auto tip = [](const TreeDocument& document) {
        return BudRef{trunkTip(document.index(), 0), kTerminalSlot};
    };
    for (const Vec3& target : {Vec3(0.0F, 3.0F, 0.0F), Vec3(2.0F, 2.0F, 1.0F), Vec3(-3.0F, 0.5F, 0.0F)}) {
        TreeDocument document;
        GrowthWorkspace workspace;
        float distance = (target - document.index().nodePosition(0)).norm();
        for (int step = 0; step < 100 && distance > 0.5F; ++step) {
            TreeDelta delta =
                growLeader(document.tree(), document.index(), tip(document), target, 0.5F, 3, workspace);
            QVERIFY(delta.born.count > 0 && delta.born.count <= 3);
            apply(document, std::move(delta));
            distance = (target - document.index().nodePosition(tip(document).node)).norm();
        }
        QVERIFY(distance <= 0.5F);
        QCOMPARE(document.index().tipCount(0), 1U);
        QVERIFY(growLeader(document.tree(), document.index(), tip(document), target, 0.5F, 3, workspace)
                    .isEmpty());
    }
}

void GrowthStepTest::autonomousStep_goesOnWhereTheStrongestAreHemmedIn()
{
    // Nearly all vigour goes to the tip of an axis that has reached the ground, where it sees only earth.
    TreeParameters parameters = diagram();
    GrowthParameters& p = parameters.growth;
    p.internodeLength = 0.1;
    p.apicalDominance = 0.95;
    p.maxShootLength = 1;
    p.occupancyRadius = 0.5;
    p.perceptionAngle = radians(60);
    p.branchingAngle = radians(90);
    TreeBuilder builder(1, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(radians(180)), 2, continuing(), 0.04F);
    const InternodeId tip = builder.tree.size() - 1;
    QVERIFY(builder.index.nodePosition(tip).y() < 0.03F);
    QVERIFY(builder.index.heading(tip).y() < -0.99F);
    const GrowthIndex growth(builder.tree, builder.index);
    GrowthWorkspace workspace;
    VigourFlow flow(builder.tree, builder.index, growth, workspace.vigour);
    QVERIFY(flow.ofBud(tip, 0) < 0.1 * flow.ofBud(tip, kTerminalSlot));

    const TreeDelta delta =
        autonomousStep(builder.tree, builder.index, growth, GrowthStepOptions::of(p), workspace);
    QVERIFY(delta.born.count > 0);
    for (const std::uint8_t slot : delta.rows->internodes.slot)
        QVERIFY(slot != kTerminalSlot);
}

const TestClass<GrowthStepTest> growthStepTest;

} // namespace espalier::test

#include "GrowthStepTest.moc"
