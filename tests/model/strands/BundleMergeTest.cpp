// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/BundleMerge.h"

#include "model/strands/SlotAssignment.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <numeric>

namespace espalier::test {

class BundleMergeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void mergeDistance_isTheSumOfBothExtentsAndADiameter();
    void merge_givesEachStrandOneOfTheFirstSlots();
    void addedStrands_lieOnTheirSide();
    void strandsInPlace_moveByASlotAtATime();
    void strandsOnTheOtherSide_stay();
    void merge_ofEqualBundles_givesEachItsHalf();
    void assignSlots_keepsNeighboursTogether();
    void assignSlots_doesNotDependOnPlaceAndSize();
};

void BundleMergeTest::mergeDistance_isTheSumOfBothExtentsAndADiameter()
{
    // The known answer: extents of 3 and 1 along the side, 4 in the paper, and a diameter between the rims.
    const std::vector<Vec2> main{{-3.0F, 0.0F}, {3.0F, 1.0F}, {0.0F, 5.0F}};
    const std::vector<Vec2> added{{-1.0F, 0.0F}, {2.0F, 0.0F}};
    QCOMPARE(mergeDistance(main, added, Vec2(1.0F, 0.0F)), 6.0F);
    QCOMPARE(mergeDistance(main, added, Vec2(-1.0F, 0.0F)), 7.0F);
    QCOMPARE(mergeDistance(main, added, Vec2(0.0F, 1.0F)), 7.0F);
}

namespace {

std::vector<std::uint32_t> firstSlots(std::uint32_t count)
{
    std::vector<std::uint32_t> taken(count);
    std::iota(taken.begin(), taken.end(), 0U);
    return taken;
}

std::vector<Vec2> bundleOf(const HexLattice& lattice, std::uint32_t count)
{
    std::vector<Vec2> places;
    for (std::uint32_t i = 0; i < count; ++i)
        places.push_back(lattice.position(i) - lattice.centroid(count));
    return places;
}

/// The slots of @p main strands and of @p added ones that came from @p side.
std::vector<std::uint32_t> merged(const HexLattice& lattice, std::uint32_t main, std::uint32_t added,
                                  const Vec2& side)
{
    BundleMerge merge(lattice);
    merge.begin(firstSlots(main), 0);
    merge.add(bundleOf(lattice, added), main, side);
    std::vector<std::uint32_t> result(main + added, HexLattice::kNone);
    merge.finish(result);
    return result;
}

} // namespace

void BundleMergeTest::merge_givesEachStrandOneOfTheFirstSlots()
{
    const HexLattice lattice(12'000);
    Random random(7, 0, 0, Purpose::Direction);
    BundleMerge merge(lattice);
    for (int trial = 0; trial < 60; ++trial) {
        auto total = static_cast<std::uint32_t>(random.uniform(1.0, trial % 10 == 0 ? 3000.0 : 60.0));
        merge.begin(firstSlots(total), 0);
        for (int i = 0; i < 4; ++i) {
            const auto added =
                static_cast<std::uint32_t>(random.uniform(1.0, static_cast<double>(total) + 1.0));
            const auto angle = static_cast<float>(random.uniform(0.0, 7.0));
            merge.add(bundleOf(lattice, added), total, Vec2(std::cos(angle), std::sin(angle)));
            total += added;
            if (total > 6000)
                break;
        }
        std::vector<std::uint32_t> result(total, HexLattice::kNone);
        merge.finish(result);
        std::ranges::sort(result);
        QCOMPARE(result, firstSlots(total));
    }
}

void BundleMergeTest::addedStrands_lieOnTheirSide()
{
    const HexLattice lattice(1100);
    for (float angle = 0.1F; angle < 6.2F; angle += 0.5F) {
        const Vec2 side(std::cos(angle), std::sin(angle));
        const std::vector<std::uint32_t> result = merged(lattice, 1000, 60, side);
        for (std::uint32_t i = 1000; i < 1060; ++i)
            QVERIFY(lattice.position(result[i]).dot(side) > 0.5F * lattice.radius(1060));
    }
}

void BundleMergeTest::strandsInPlace_moveByASlotAtATime()
{
    const HexLattice lattice(1100);
    const std::vector<std::uint32_t> result = merged(lattice, 1000, 1, Vec2(1.0F, 0.1F).normalized());
    float farthest = 0.0F;
    int moved = 0;
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const float distance = (lattice.position(result[i]) - lattice.position(i)).norm();
        farthest = std::max(farthest, distance);
        moved += distance > 0.0F ? 1 : 0;
    }
    QVERIFY2(farthest <= 4.0F, qPrintable(QString::number(double{farthest})));
    QVERIFY2(moved < 60, qPrintable(QString::number(moved)));
}

void BundleMergeTest::strandsOnTheOtherSide_stay()
{
    const HexLattice lattice(1100);
    const Vec2 side(0.6F, 0.8F);
    const std::vector<std::uint32_t> result = merged(lattice, 1000, 40, side);
    // The bundle grows all around, so rows move; but few strands go far.
    std::vector<float> moves;
    for (std::uint32_t i = 0; i < 1000; ++i)
        moves.push_back((lattice.position(result[i]) - lattice.position(i)).norm());
    std::ranges::sort(moves);
    QCOMPARE(moves[500], 0.0F);
    QVERIFY2(moves[950] <= 10.0F, qPrintable(QString::number(double{moves[950]})));
}

void BundleMergeTest::merge_ofEqualBundles_givesEachItsHalf()
{
    const HexLattice lattice(400);
    const std::vector<std::uint32_t> result = merged(lattice, 150, 150, Vec2(1.0F, 0.0F));
    Vec2 own = Vec2::Zero();
    Vec2 other = Vec2::Zero();
    for (std::uint32_t i = 0; i < 150; ++i) {
        own += lattice.position(result[i]) / 150.0F;
        other += lattice.position(result[150 + i]) / 150.0F;
    }
    const float radius = lattice.radius(300);
    QVERIFY(other.x() - own.x() > 0.7F * radius); // Two half discs: 0.85
    QVERIFY(std::abs(other.y()) < 0.1F * radius && std::abs(own.y()) < 0.1F * radius);
}

void BundleMergeTest::assignSlots_keepsNeighboursTogether()
{
    const HexLattice lattice(900);
    const std::vector<Vec2> points = bundleOf(lattice, 900);
    std::vector<Vec2> wide;
    for (const Vec2& point : points)
        wide.emplace_back(3.0F * point.x() + 100.0F, point.y());
    std::vector<std::uint32_t> chosen(900);
    assignSlots(points, wide, chosen);
    std::vector<std::uint32_t> sorted = chosen;
    std::ranges::sort(sorted);
    QCOMPARE(sorted, firstSlots(900));
    double mean = 0.0;
    for (std::uint32_t i = 0; i < 900; ++i)
        mean += double{(wide[chosen[i]] - wide[i]).norm()} / 900.0;
    QVERIFY2(mean < 12.0, qPrintable(QString::number(mean))); // At random: 54
}

void BundleMergeTest::assignSlots_doesNotDependOnPlaceAndSize()
{
    const HexLattice lattice(128);
    const std::vector<Vec2> points = bundleOf(lattice, 128);
    std::vector<Vec2> moved;
    for (const Vec2& point : points)
        moved.push_back(4.0F * point + Vec2(64.0F, -32.0F));
    const std::vector<Vec2> places = bundleOf(lattice, 128);
    std::vector<std::uint32_t> chosen(128);
    std::vector<std::uint32_t> chosenMoved(128);
    assignSlots(points, places, chosen);
    assignSlots(moved, places, chosenMoved);
    int differing = 0;
    for (std::size_t i = 0; i < 128; ++i)
        differing += chosen[i] != chosenMoved[i] ? 1 : 0;
    QVERIFY2(differing <= 12, qPrintable(QString::number(differing))); // Rounding decides between equals
    assignSlots({}, {}, {});
}

static const TestClass<BundleMergeTest> bundleMergeTest;

} // namespace espalier::test

#include "BundleMergeTest.moc"
