// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/HexLattice.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class HexLatticeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void slots_areADiameterApart();
    void slots_areOrderedByDistance();
    void largerLattice_beginsWithTheSmallerOne();
    void neighbours_areADiameterAwayAndMutual();
    void centroid_isTheMeanOfTheFirstSlots();
    void bundle_isRoundAndDense();
};

void HexLatticeTest::slots_areADiameterApart()
{
    const HexLattice lattice(500);
    QVERIFY(lattice.size() >= 500);
    std::vector<Vec2> places;
    for (std::uint32_t i = 0; i < lattice.size(); ++i)
        places.push_back(lattice.position(i));
    QVERIFY(std::abs(nearestPair(places) - 2.0F) < 1e-5F);
}

void HexLatticeTest::slots_areOrderedByDistance()
{
    const HexLattice lattice(5000);
    for (std::uint32_t i = 1; i < lattice.size(); ++i)
        QVERIFY(lattice.position(i).norm() >= lattice.position(i - 1).norm() - 1e-4F);
}

void HexLatticeTest::largerLattice_beginsWithTheSmallerOne()
{
    const HexLattice large(20'000);
    for (const std::uint32_t slots : {0U, 1U, 2U, 7U, 100U, 6000U}) {
        const HexLattice small(slots);
        QVERIFY(small.size() >= slots);
        for (std::uint32_t i = 0; i < slots; ++i)
            QCOMPARE(small.position(i), large.position(i));
    }
}

void HexLatticeTest::neighbours_areADiameterAwayAndMutual()
{
    const HexLattice lattice(300);
    int missing = 0;
    for (std::uint32_t i = 0; i < lattice.size(); ++i) {
        for (std::size_t j = 0; j < 6; ++j) {
            const std::uint32_t other = lattice.neighbours(i)[j];
            if (other == HexLattice::kNone) {
                ++missing;
                continue;
            }
            QVERIFY(std::abs((lattice.position(other) - lattice.position(i)).norm() - 2.0F) < 1e-4F);
            QCOMPARE(lattice.neighbours(other)[(j + 3) % 6], i);
        }
    }
    QVERIFY(missing > 0 && missing < 200); // At the rim alone
    for (const std::uint32_t neighbour : lattice.neighbours(0))
        QVERIFY(neighbour >= 1 && neighbour <= 12);
}

void HexLatticeTest::centroid_isTheMeanOfTheFirstSlots()
{
    const HexLattice lattice(1000);
    Vec2 sum = Vec2::Zero();
    for (std::uint32_t i = 0; i < 1000; ++i) {
        sum += lattice.position(i);
        QVERIFY((lattice.centroid(i + 1) - sum / static_cast<float>(i + 1)).norm() < 1e-3F);
    }
}

void HexLatticeTest::bundle_isRoundAndDense()
{
    const HexLattice lattice(10'000);
    QCOMPARE(lattice.radius(0), 0.0F);
    for (std::uint32_t count = 50; count <= 10'000; count += count < 400 ? 1 : 97) {
        // The circle is that around the middle of the bundle, where layouts have their origin.
        const Vec2 middle = lattice.centroid(count);
        float radius = 0.0F;
        for (std::uint32_t i = 0; i < count; ++i)
            radius = std::max(radius, (lattice.position(i) - middle).norm() + 1.0F);
        const float fill = static_cast<float>(count) / (radius * radius);
        QVERIFY2(fill >= 0.698F, qPrintable(QString::number(count)));
        QVERIFY(double{fill} <= HexLattice::kFill);
        QVERIFY2(middle.norm() < 0.5F, qPrintable(QString::number(count)));
        // The radius that layouts are scaled by is that of the bundle's rim.
        QVERIFY(std::abs(bundleRadius(count) - radius) < 1.1F);
    }
}

static const TestClass<HexLatticeTest> hexLatticeTest;

} // namespace espalier::test

#include "HexLatticeTest.moc"
