// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandFibres.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <set>

namespace espalier::test {

class StrandFibresTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void fibres_runFromEachTipToTheGround();
    void fibres_ofALargeTree_areAtMostAsManyAsAsked();
    void branches_haveColoursOfTheirOwn();
};

void StrandFibresTest::fibres_runFromEachTipToTheGround()
{
    const TreeBuilder builder = forkedTree(30, strandParameters(2));
    const StrandLayouts layouts = layoutsOf(builder);
    const std::vector<FibreVertex> fibres = strandFibres(layouts);
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
    const std::size_t all = strandFibres(layouts).size() / 2;
    QVERIFY(all > 10000);
    for (const std::size_t most : {5000UL, 2000UL, 300UL}) {
        const std::size_t pieces = strandFibres(layouts, most).size() / 2;
        QVERIFY(pieces <= most);
        QVERIFY(pieces > most / 3);
    }
    QVERIFY(strandFibres(layouts, 0).empty());
}

void StrandFibresTest::branches_haveColoursOfTheirOwn()
{
    const TreeBuilder builder = forkedTree(200);
    const std::vector<FibreVertex> fibres = strandFibres(layoutsOf(builder));
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

const TestClass<StrandFibresTest> strandFibresTest;

} // namespace espalier::test

#include "StrandFibresTest.moc"
