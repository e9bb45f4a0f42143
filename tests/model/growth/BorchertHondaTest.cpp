// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BorchertHonda.h"

#include "commands/SetParameters.h"
#include "tests/support/BruteForce.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class BorchertHondaTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void share_hasTheKnownValues();
    void share_isConservedAndGrowsWithLambda();
    void share_whereNothingCanUseVigour_isNothing();
    void vigour_isWhatBruteForceFinds();
    void vigour_isConservedFromTheBaseToTheBuds();
    void vigour_intoTheTrunk_growsWithLambda();
    void vigour_atOneHalf_isTheShareOfLight();
    void vigour_doesNotDependOnTheOrderOfChildren();
    void vigour_doesNotDependOnTheOrderOfQuestions();
};

namespace {

/// A tree grown at random with @p lambda in force, and its flow of vigour.
struct Grown {
    explicit Grown(std::uint64_t seed, double lambda = -1.0)
    {
        growAtRandom(document, seed, 80, 300);
        if (lambda >= 0.0) {
            TreeParameters parameters = document.parameters();
            parameters.growth.apicalDominance = lambda;
            setParameters(document, parameters);
        }
    }
    VigourFlow flow() { return VigourFlow(tree(), document.index(), growthIndexOf(document), known); }
    const Tree& tree() const { return document.tree(); }
    std::int64_t q(InternodeId id) const { return growthIndexOf(document).basipetal(id); }

    TreeDocument document;
    StampedColumn<double> known;
};

template <class Visit>
void forEachBud(const Tree& tree, Visit&& visit)
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        for (int slot = 0; slot < 8; ++slot) {
            if (tree.isAlive(id) && (tree.buds(id) & budBit(slot)) != 0)
                visit(id, slot);
        }
    }
}

} // namespace

void BorchertHondaTest::share_hasTheKnownValues()
{
    const auto is = [](const VigourShares& shares, double main, double lateral) {
        return std::abs(shares.main - main) < 1e-12 && std::abs(shares.lateral - lateral) < 1e-12;
    };
    QVERIFY(is(shareVigour(3.0, 0.6, 2.0, 1.0), 2.25, 0.75));
    QVERIFY(is(shareVigour(10.0, 0.46, 1.7, 1.7), 4.6, 5.4));
    QVERIFY(is(shareVigour(5.0, 0.7, 0.0, 2.0), 0.0, 5.0));
}

void BorchertHondaTest::share_isConservedAndGrowsWithLambda()
{
    Random random(1, 0, 0, Purpose::ShootLength);
    for (int i = 0; i < 1000; ++i) {
        const double v = random.uniform(0.0, 1e6);
        const double main = random.uniform(0.0, 1e4);
        const double lateral = random.uniform(0.0, 1e4);
        double last = -1.0;
        for (const double lambda : {0.0, 0.1, 0.44, 0.5, 0.58, 0.9, 1.0}) {
            const VigourShares shares = shareVigour(v, lambda, main, lateral);
            QVERIFY(std::abs(shares.main + shares.lateral - v) <= 1e-12 * v);
            QVERIFY(shares.main > last || v == 0.0);
            last = shares.main;
        }
    }
}

void BorchertHondaTest::share_whereNothingCanUseVigour_isNothing()
{
    for (const auto& [lambda, main, lateral] :
         {std::tuple(0.5, 0.0, 0.0), {1.0, 0.0, 3.0}, {0.0, 3.0, 0.0}}) {
        const VigourShares shares = shareVigour(7.0, lambda, main, lateral);
        QCOMPARE(shares.main, 0.0);
        QCOMPARE(shares.lateral, 0.0);
    }
}

void BorchertHondaTest::vigour_isWhatBruteForceFinds()
{
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        Grown grown(seed);
        const BruteVigour brute(grown.tree(), grown.document.index());
        VigourFlow flow = grown.flow();
        const double unit = GrowthIndex::kUnit;
        // Each bud's Q is rounded to a whole number of units.
        const double tolerance = 1e-4 * brute.into.at(0);
        for (InternodeId id = 0; id < grown.tree().size(); ++id) {
            if (grown.tree().isAlive(id))
                QVERIFY(std::abs(flow.into(id) / unit - brute.into.at(id)) <= tolerance);
        }
        forEachBud(grown.tree(), [&](InternodeId id, int slot) {
            QVERIFY(std::abs(flow.ofBud(id, slot) / unit - brute.ofBud.at({id, slot})) <= tolerance);
        });
    }
}

void BorchertHondaTest::vigour_isConservedFromTheBaseToTheBuds()
{
    for (std::uint64_t seed = 20; seed < 32; ++seed) {
        Grown grown(seed);
        VigourFlow flow = grown.flow();
        const double base = flow.into(0);
        QCOMPARE(base, static_cast<double>(grown.q(0)));
        double sum = 0.0;
        forEachBud(grown.tree(), [&](InternodeId id, int slot) { sum += flow.ofBud(id, slot); });
        // With 0 < λ < 1 only a branch without any Q could not pass on what it gets, and it gets nothing.
        QVERIFY(base > 0.0);
        QVERIFY(std::abs(sum - base) <= 1e-9 * base);
    }
}

void BorchertHondaTest::vigour_intoTheTrunk_growsWithLambda()
{
    for (std::uint64_t seed = 40; seed < 45; ++seed) {
        double last = -1.0;
        for (const double lambda : {0.2, 0.4, 0.5, 0.6, 0.8}) {
            Grown grown(seed, lambda);
            const TreeIndex& index = grown.document.index();
            InternodeId tip = 0;
            while (index.mainChild(tip) != kNoInternode)
                tip = index.mainChild(tip);
            if (grown.q(tip) == 0 || grown.q(tip) == grown.q(0))
                continue;
            VigourFlow flow = grown.flow();
            QVERIFY(flow.into(tip) > last);
            last = flow.into(tip);
        }
        QVERIFY(last > 0.0);
    }
}

void BorchertHondaTest::vigour_atOneHalf_isTheShareOfLight()
{
    for (std::uint64_t seed = 50; seed < 56; ++seed) {
        Grown grown(seed, 0.5);
        VigourFlow flow = grown.flow();
        for (InternodeId id = 0; id < grown.tree().size(); ++id) {
            if (grown.tree().isAlive(id))
                QVERIFY(std::abs(flow.into(id) - static_cast<double>(grown.q(id))) <= 1e-9 * flow.into(0));
        }
    }
}

void BorchertHondaTest::vigour_doesNotDependOnTheOrderOfChildren()
{
    // The same plant, its three branches born in different orders: one side each node, in a level plane but
    // for the trunk.
    const auto build = [](const std::vector<int>& order) {
        TreeParameters parameters;
        parameters.growth.irregularity = 0.0;
        parameters.growth.lateralsPerNode = 3;
        parameters.growth.apicalDominance = 0.56;
        TreeBuilder builder(1, parameters);
        const InternodeId crotch = builder.growAxis(0, kTerminalSlot, continuing(), 3);
        std::array<InternodeId, 4> tips{};
        for (const int branch : order) {
            const bool main = branch == 3;
            tips[static_cast<std::size_t>(branch)] = builder.growAxis(
                crotch, main ? kTerminalSlot : branch, main ? continuing() : branching(0.9, branch, 3),
                static_cast<std::uint32_t>(4 + 3 * branch));
        }
        return std::pair(std::move(builder), tips);
    };
    const auto vigours = [](const std::pair<TreeBuilder, std::array<InternodeId, 4>>& built) {
        const GrowthIndex growth(built.first.tree, built.first.index);
        StampedColumn<double> known;
        VigourFlow flow(built.first.tree, built.first.index, growth, known);
        std::vector<double> result;
        for (const InternodeId tip : built.second) {
            result.push_back(flow.into(tip));
            result.push_back(flow.ofBud(tip, kTerminalSlot));
            result.push_back(flow.ofBud(tip, 1));
        }
        return result;
    };
    const auto expected = vigours(build({3, 0, 1, 2}));
    QVERIFY(std::ranges::all_of(expected, [](double v) { return v > 0.0; }));
    for (const std::vector<int>& order : {std::vector{0, 1, 2, 3}, {2, 3, 1, 0}, {1, 0, 3, 2}}) {
        const auto other = vigours(build(order));
        for (std::size_t i = 0; i < expected.size(); ++i)
            QVERIFY(std::abs(other[i] - expected[i]) <= 1e-9 * expected[i]);
    }
}

void BorchertHondaTest::vigour_doesNotDependOnTheOrderOfQuestions()
{
    Grown grown(60);
    std::vector<double> upwards(grown.tree().size(), 0.0);
    {
        VigourFlow flow = grown.flow();
        for (InternodeId id = 0; id < grown.tree().size(); ++id) {
            if (grown.tree().isAlive(id))
                upwards[id] = flow.into(id);
        }
    }
    VigourFlow flow = grown.flow();
    for (InternodeId id = grown.tree().size(); id-- > 0;) {
        if (grown.tree().isAlive(id))
            QCOMPARE(flow.into(id), upwards[id]);
    }
}

const TestClass<BorchertHondaTest> borchertHondaTest;

} // namespace espalier::test

#include "BorchertHondaTest.moc"
