// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthIndex.h"

#include "commands/SetParameters.h"
#include "tests/support/BruteForce.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class GrowthIndexTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shadow_isTheSumOverAllInternodes();
    void q_withoutGravimorphism_isExactlyBruteForce();
    void q_withGravimorphism_isBruteForce();
    void basipetal_isTheSumOfTheBudsAbove();
    void dead_haveNoQ();
    void seedling_hasFullLight();
    void lightSensitivity_isTheExponentOfLight();
    void gravimorphism_leavesTerminalBudsAlone();
    void workedOutInParts_itIsTheSame();
    void voxelsOfNoSize_areGivenOne();
};

namespace {

std::int64_t inUnits(double q)
{
    return static_cast<std::int64_t>(q * GrowthIndex::kUnit + 0.5);
}

template <class Visit>
void forEachLiving(const Tree& tree, Visit&& visit)
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            visit(id);
    }
}

std::int64_t budQ(const TreeDocument& document, const BudRef& bud)
{
    return bud.slot == kTerminalSlot
               ? growthIndexOf(document).terminalQ(document.tree(), bud.node)
               : growthIndexOf(document).lateralQ(document.tree(), document.index(), bud.node, bud.slot);
}

} // namespace

void GrowthIndexTest::shadow_isTheSumOverAllInternodes()
{
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 100, 300);
        const VoxelSpace& space = document.growthModel().space();
        Random random(seed, 1, 0, Purpose::Direction);
        std::vector<Vec3> points;
        forEachLiving(document.tree(),
                      [&](InternodeId id) { points.push_back(document.index().nodePosition(id)); });
        for (int i = 0; i < 100; ++i)
            points.push_back(2.0F * random.inBall());
        for (const Vec3& point : points) {
            QCOMPARE(static_cast<std::int64_t>(space.shadow(space.cellAt(point))),
                     bruteShadow(document.tree(), document.index(), point));
        }
    }
}

void GrowthIndexTest::q_withoutGravimorphism_isExactlyBruteForce()
{
    for (std::uint64_t seed = 20; seed < 32; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 80, 300);
        TreeParameters parameters = document.parameters();
        parameters.growth.ellipseVertical = parameters.growth.ellipseParallel = 1.0;
        parameters.growth.ellipseOffset = 0.0;
        setParameters(document, parameters);
        const BruteVigour brute(document.tree(), document.index());
        QVERIFY(brute.budQ.size() > 50);
        for (const auto& [bud, q] : brute.budQ)
            QCOMPARE(budQ(document, bud), inUnits(q));
    }
}

void GrowthIndexTest::q_withGravimorphism_isBruteForce()
{
    for (std::uint64_t seed = 40; seed < 52; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 80, 300);
        TreeParameters parameters = document.parameters();
        Random random(seed, 3, 0, Purpose::Direction);
        parameters.growth.ellipseVertical = random.uniform(0.3, 2.0);
        parameters.growth.ellipseParallel = random.uniform(0.3, 2.0);
        parameters.growth.ellipseOffset = random.uniform(-0.9, 0.9) * parameters.growth.ellipseVertical;
        setParameters(document, parameters);
        const BruteVigour brute(document.tree(), document.index());
        for (const auto& [bud, q] : brute.budQ)
            QVERIFY(std::abs(static_cast<double>(budQ(document, bud)) / GrowthIndex::kUnit - q) < 1e-4);
    }
}

void GrowthIndexTest::basipetal_isTheSumOfTheBudsAbove()
{
    for (std::uint64_t seed = 60; seed < 70; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 200);
        const Tree& tree = document.tree();
        forEachLiving(tree, [&](InternodeId id) {
            std::int64_t sum = 0;
            for (const InternodeId above : bruteSubtree(tree, id)) {
                for (int slot = 0; slot < 8; ++slot) {
                    if ((tree.buds(above) & budBit(slot)) != 0)
                        sum += budQ(document, {above, slot});
                }
            }
            QCOMPARE(growthIndexOf(document).basipetal(id), sum);
        });
    }
}

void GrowthIndexTest::dead_haveNoQ()
{
    std::size_t dead = 0;
    for (std::uint64_t seed = 80; seed < 90; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 200, 400);
        for (InternodeId id = 0; id < document.tree().size(); ++id) {
            if (document.tree().isAlive(id))
                continue;
            QCOMPARE(growthIndexOf(document).basipetal(id), 0);
            ++dead;
        }
    }
    QVERIFY(dead > 0);
}

void GrowthIndexTest::seedling_hasFullLight()
{
    TreeDocument document;
    QVERIFY(std::abs(static_cast<double>(growthIndexOf(document).basipetal(0)) / GrowthIndex::kUnit - 1.0) <
            1e-5);
    QCOMPARE(growthIndexOf(document).light({0.0F, 5.0F, 0.0F}), 1.0F);
}

void GrowthIndexTest::lightSensitivity_isTheExponentOfLight()
{
    TreeDocument document;
    growAtRandom(document, 95, 200, 400);
    TreeParameters parameters = document.parameters();
    parameters.growth.ellipseVertical = parameters.growth.ellipseParallel = 1.0;
    parameters.growth.ellipseOffset = 0.0;
    parameters.growth.lightSensitivity = 1.0;
    parameters.growth.shadowIntensity = 0.03;
    parameters.growth.shadowDepth = 6;
    setParameters(document, parameters);
    std::vector<double> light;
    forEachLiving(document.tree(), [&](InternodeId id) {
        light.push_back(
            static_cast<double>(growthIndexOf(document).lateralQ(document.tree(), document.index(), id, 0)) /
            GrowthIndex::kUnit);
    });
    QVERIFY(std::ranges::min(light) < 0.9 && std::ranges::max(light) > 0.95);

    for (const double exponent : {0.25, 2.0, 5.0}) {
        parameters.growth.lightSensitivity = exponent;
        setParameters(document, parameters);
        std::size_t i = 0;
        forEachLiving(document.tree(), [&](InternodeId id) {
            const double q = static_cast<double>(
                                 growthIndexOf(document).lateralQ(document.tree(), document.index(), id, 0)) /
                             GrowthIndex::kUnit;
            if (light[i] > 0.01)
                QVERIFY(std::abs(q - std::pow(light[i], exponent)) < 1e-5);
            ++i;
        });
    }
}

void GrowthIndexTest::workedOutInParts_itIsTheSame()
{
    for (std::uint64_t seed = 100; seed < 106; ++seed) {
        TreeDocument document;
        GrowthIndex parts(document.tree(), document.index());
        Random random(seed, 5, 0, Purpose::Direction);
        int unfinished = 0;
        connect(&document, &TreeDocument::changed, &document, [&](const TreeChange& change) {
            if (change.kind == TreeChange::Kind::Reset)
                parts.rebuild(document.tree(), document.index());
            else
                parts.follow(document.tree(), document.index(), *change.delta);
            unfinished += parts.settleSome(document.tree(), document.index(), random.bits() % 4) ? 0 : 1;
        });
        growAtRandom(document, seed, 80, 300);
        QVERIFY2(unfinished > 2, qPrintable(QString::number(unfinished)));
        while (!parts.settleSome(document.tree(), document.index(), 5)) {
        }
        const GrowthIndex& whole = growthIndexOf(document);
        forEachLiving(document.tree(), [&](InternodeId id) {
            const Vec3& position = document.index().nodePosition(id);
            QCOMPARE(parts.space().shadow(parts.space().cellAt(position)),
                     whole.space().shadow(whole.space().cellAt(position)));
            QCOMPARE(parts.basipetal(id), whole.basipetal(id));
        });
    }
}

void GrowthIndexTest::gravimorphism_leavesTerminalBudsAlone()
{
    TreeDocument document;
    growAtRandom(document, 97, 100, 300);
    TreeParameters parameters = document.parameters();
    const auto terminals = [&] {
        std::vector<std::int64_t> result;
        forEachLiving(document.tree(), [&](InternodeId id) {
            result.push_back(budQ(document, {id, kTerminalSlot}));
        });
        return result;
    };
    parameters.growth.ellipseVertical = parameters.growth.ellipseParallel = 1.0;
    parameters.growth.ellipseOffset = 0.0;
    setParameters(document, parameters);
    const auto neutral = terminals();
    parameters.growth.ellipseVertical = 0.5;
    parameters.growth.ellipseOffset = 0.4;
    setParameters(document, parameters);
    QVERIFY(terminals() == neutral);
}

void GrowthIndexTest::voxelsOfNoSize_areGivenOne()
{
    TreeDocument document;
    growAtRandom(document, 3, 40);
    for (const double length : {0.0, 1e-40}) {
        TreeParameters parameters = document.parameters();
        parameters.growth.internodeLength = length;
        Tree tree(1, parameters);
        const TreeIndex index(tree);
        const GrowthIndex growth(tree, index);
        QVERIFY(growth.space().edge() > 0.0F);
    }
}

const TestClass<GrowthIndexTest> growthIndexTest;

} // namespace espalier::test

#include "GrowthIndexTest.moc"
