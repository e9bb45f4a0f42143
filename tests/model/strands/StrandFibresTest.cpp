// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandFibres.h"

#include "model/shape/Pruning.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace espalier::test {

namespace {

/// The ratio of two channels to all, by the place of a tip: the same at the surface and inside.
using TipColours = std::map<std::array<float, 3>, std::array<double, 2>>;

TipColours coloursOfTips(const TreeBuilder& builder)
{
    TipColours all;
    const StrandLayouts layouts = layoutsOf(builder);
    for (const FibreVertex& vertex : strandFibres(layouts, builder.tree, builder.index)) {
        const double sum = vertex.colour[0] + vertex.colour[1] + vertex.colour[2];
        all[vertex.position] = {vertex.colour[0] / sum, vertex.colour[1] / sum};
    }
    TipColours ofTips;
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        if (!builder.tree.isAlive(id) || builder.index.subtreeSize(id) != 1)
            continue;
        const Vec3& tip = builder.index.nodePosition(id);
        const auto nearest = std::ranges::min_element(
            all, {}, [&](const auto& end) { return (Vec3(end.first.data()) - tip).squaredNorm(); });
        ofTips[{tip.x(), tip.y(), tip.z()}] = nearest->second;
    }
    return ofTips;
}

} // namespace

class StrandFibresTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fibres_runFromEachTipToTheGround();
    void fibres_ofALargeTree_areAtMostAsManyAsAsked();
    void branches_haveColoursOfTheirOwn();
    void growthAndCuts_leaveTheColoursOfOtherBranches();
};

void StrandFibresTest::fibres_runFromEachTipToTheGround()
{
    const TreeBuilder builder = forkedTree(30, strandParameters(2));
    const StrandLayouts layouts = layoutsOf(builder);
    const std::vector<FibreVertex> fibres = strandFibres(layouts, builder.tree, builder.index);
    QVERIFY(fibres.size() % 2 == 0);
    int feet = 0;
    for (std::size_t i = 0; i < fibres.size(); i += 2) {
        if (fibres[i].position[1] < 1e-4F)
            ++feet;
        QVERIFY(fibres[i].position[1] >= 0.0F);
        // No piece is longer than an internode.
        const Vec3 from(fibres[i].position.data());
        const Vec3 to(fibres[i + 1].position.data());
        QVERIFY((to - from).norm() < 0.15F);
    }
    QCOMPARE(feet, 60);
}

void StrandFibresTest::fibres_ofALargeTree_areAtMostAsManyAsAsked()
{
    const TreeBuilder builder = forkedTree(900);
    const StrandLayouts layouts = layoutsOf(builder);
    const std::size_t all = strandFibres(layouts, builder.tree, builder.index).size() / 2;
    QVERIFY(all > 10000);
    for (const std::size_t most : {5000UL, 2000UL, 300UL}) {
        const std::size_t pieces = strandFibres(layouts, builder.tree, builder.index, most).size() / 2;
        QVERIFY(pieces <= most);
        QVERIFY(pieces > most / 3);
    }
    QVERIFY(strandFibres(layouts, builder.tree, builder.index, 0).empty());
}

void StrandFibresTest::branches_haveColoursOfTheirOwn()
{
    const TreeBuilder builder = forkedTree(200);
    const std::vector<FibreVertex> fibres = strandFibres(layoutsOf(builder), builder.tree, builder.index);
    // By the ratio of its channels, which is the same at the surface and inside.
    std::set<std::pair<int, int>> hues;
    for (const FibreVertex& vertex : fibres) {
        QCOMPARE(int(vertex.colour[3]), 255);
        const int sum = vertex.colour[0] + vertex.colour[1] + vertex.colour[2];
        QVERIFY(sum > 60);
        hues.emplace(8 * vertex.colour[0] / sum, 8 * vertex.colour[1] / sum);
    }
    QVERIFY2(hues.size() >= 5, qPrintable(QString::number(hues.size())));
}

void StrandFibresTest::growthAndCuts_leaveTheColoursOfOtherBranches()
{
    TreeBuilder builder = forkedTree(60, strandParameters(2));
    const auto before = coloursOfTips(builder);
    QVERIFY(before.size() == 60);
    const auto same = [&](const auto& after) {
        std::size_t count = 0;
        for (const auto& [place, colour] : after) {
            const auto found = before.find(place);
            if (found == before.end())
                continue;
            ++count;
            // Colours are rounded to 1/255.
            for (const std::size_t channel : {0U, 1U}) {
                if (std::abs(found->second[channel] - colour[channel]) > 0.02)
                    return std::size_t{0};
            }
        }
        return count;
    };
    // A new limb, low on the trunk, with far more strands than any other.
    InternodeId parent = builder.growAxis(1, 2, branching(0.9, 2), 3);
    for (int i = 0; i < 80; ++i) {
        builder.growAxis(parent, 0, branching(0.7), 2);
        parent = builder.growAxis(parent, kTerminalSlot, continuing(0.05), 1);
    }
    const auto grown = coloursOfTips(builder);
    QVERIFY(grown.size() > 120);
    QCOMPARE(same(grown), std::size_t{60});
    // A limb is cut.
    InternodeId limb = kNoInternode;
    for (InternodeId id = 1; id < builder.tree.size() && limb == kNoInternode; ++id) {
        if (builder.index.axis(id) == id)
            limb = id;
    }
    const std::uint32_t fallen = builder.index.tipCount(limb);
    QVERIFY(fallen > 5 && fallen < 40);
    builder.apply(prune(builder.tree, builder.index, std::array{limb}));
    QCOMPARE(same(coloursOfTips(builder)), std::size_t{60} - fallen);
}

const TestClass<StrandFibresTest> strandFibresTest;

} // namespace espalier::test

#include "StrandFibresTest.moc"
