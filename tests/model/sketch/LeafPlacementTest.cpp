// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/LeafPlacement.h"

#include "tests/support/PlacedLeaves.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <limits>

namespace espalier::test {

class LeafPlacementTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void blade_goesToTheFarthestPointOfTheOutline();
    void blade_looksAtTheViewer();
    void blade_alongTheView_hasAnUpperSide();
    void blade_ofADot_isNone();
    void leafOn_hasTheFrameOfTheWorld();
    void limits_areThoseOfRows();
    void edits_comeAndGo();
    void edits_ofNothing_areEmpty();
};

namespace {

using Outline = std::vector<Eigen::Vector3d>;

Vec3 midribOf(const LeafBlade& blade)
{
    return blade.frame * Vec3(Vec3::UnitY());
}

Vec3 upperSideOf(const LeafBlade& blade)
{
    return blade.frame * Vec3(Vec3::UnitZ());
}

} // namespace

void LeafPlacementTest::blade_goesToTheFarthestPointOfTheOutline()
{
    const Outline outline{{1.0, 2.0, 0.5}, {1.5, 2.2, 0.5}, {2.0, 3.0, 0.5}, {1.1, 2.6, 0.5}};
    const auto blade = bladeOf(outline, Eigen::Vector3d::UnitZ());
    QVERIFY(blade);
    QVERIFY(std::abs(blade->length - std::sqrt(2.0F)) < 1e-6F);
    QVERIFY((midribOf(*blade) - Vec3(1.0F, 1.0F, 0.0F).normalized()).norm() < 1e-6F);
    const Outline huge{{0.0, 0.0, 0.0}, {1e4, 0.0, 0.0}, {0.0, 1.0, 0.0}};
    QCOMPARE(bladeOf(huge, Eigen::Vector3d::UnitZ())->length, kGreatestLeaf);
}

void LeafPlacementTest::blade_looksAtTheViewer()
{
    Random random(6, 0, 0, Purpose::Direction);
    for (int i = 0; i < 50; ++i) {
        const Eigen::Vector3d tip = random.direction().cast<double>();
        const Eigen::Vector3d viewer = random.direction().cast<double>();
        const auto blade = bladeOf(Outline{{0.0, 0.0, 0.0}, 0.5 * tip, tip}, viewer);
        QVERIFY(blade);
        const Vec3 upper = upperSideOf(*blade);
        QVERIFY(std::abs(upper.dot(midribOf(*blade))) < 1e-5F);
        // No direction across the midrib is nearer to the viewer.
        const double most = std::sqrt(1.0 - std::pow(viewer.dot(tip) / tip.norm(), 2.0));
        QVERIFY(std::abs(static_cast<double>(upper.dot(viewer.cast<float>())) - most) < 1e-4);
    }
}

void LeafPlacementTest::blade_alongTheView_hasAnUpperSide()
{
    const auto blade = bladeOf(Outline{{0, 0, 0}, {0, 0, 1}, {0, 0, 2}}, Eigen::Vector3d::UnitZ());
    QVERIFY(blade);
    QVERIFY(isFrame(blade->frame, blade->length));
    QVERIFY((midribOf(*blade) - Vec3(Vec3::UnitZ())).norm() < 1e-6F);
}

void LeafPlacementTest::blade_ofADot_isNone()
{
    QVERIFY(!bladeOf(Outline{}, Eigen::Vector3d::UnitZ()));
    QVERIFY(!bladeOf(Outline{{1, 1, 1}, {1, 1, 1.00001}, {1, 1, 1}}, Eigen::Vector3d::UnitZ()));
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!bladeOf(Outline{{1, 1, 1}, {nan, 1, 1}, {1, 1, 1}}, Eigen::Vector3d::UnitZ()));
}

void LeafPlacementTest::leafOn_hasTheFrameOfTheWorld()
{
    const TreeBuilder builder = randomTree(50, 5);
    const auto blade =
        bladeOf(Outline{{0, 0, 0}, {0.1, 0.2, 0.0}, {0.3, 0.4, 0.0}}, Eigen::Vector3d::UnitZ());
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        const LeafRow row = leafOn(builder.tree, builder.index, id, 0.3F, *blade);
        QCOMPARE(row.internode, id);
        QCOMPARE(row.along, 0.3F);
        QCOMPARE(row.length, blade->length);
        QCOMPARE(isLeafPlace(builder.tree, row), builder.tree.isAlive(id));
        QVERIFY((builder.index.rotation(id) * row.rotation).angularDistance(blade->frame) < 1e-3F);
    }
}

void LeafPlacementTest::limits_areThoseOfRows()
{
    TreeBuilder builder;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 3);
    builder.apply(death(builder.tree, builder.index, tip));
    const LeafRow good = leafAround(1, 0.5F, 0.0);
    QVERIFY(isLeafPlace(builder.tree, good));
    const auto isRefused = [&](auto&& change) {
        LeafRow row = good;
        change(row);
        return !isLeafPlace(builder.tree, row);
    };
    const float nan = std::numeric_limits<float>::quiet_NaN();
    QVERIFY(isRefused([&](LeafRow& row) { row.internode = tip; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.internode = 99; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.along = 1.1F; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.along = nan; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.length = 0.0F; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.length = 2.0F * kGreatestLeaf; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.rotation.coeffs() *= 2.0F; }));
    QVERIFY(isRefused([&](LeafRow& row) { row.kind = static_cast<LeafKind>(9); }));
}

void LeafPlacementTest::edits_comeAndGo()
{
    TreeBuilder builder = randomTree(60, 8);
    Random random(9, 0, 0, Purpose::Direction);
    std::vector<Tree> states{builder.tree};
    for (int i = 0; i < 80; ++i) {
        builder.apply(randomLeafEdit(builder.tree, random));
        QCOMPARE(treeFault(builder.tree.content()), QString());
        states.push_back(builder.tree);
    }
    const LeafColumns& rows = builder.tree.placedLeaves();
    QVERIFY(std::ranges::any_of(rows.death, [](Step step) { return step != kNever; }));
    while (states.size() > 1) {
        QVERIFY(builder.tree == states.back());
        states.pop_back();
        builder.revert();
    }
    QVERIFY(builder.tree == states.back());
}

void LeafPlacementTest::edits_ofNothing_areEmpty()
{
    TreeBuilder builder = randomTree(20, 8);
    TreeDelta placed = deltaStartingAt(builder.tree);
    QVERIFY(placed.isEmpty());
    addLeaf(placed, leafAround(3, 0.5F, 0.0));
    QVERIFY(!placed.isEmpty());
    builder.apply(std::move(placed));
    TreeDelta unmoved = deltaStartingAt(builder.tree);
    moveLeaf(unmoved, builder.tree, 0, leafRow(builder.tree, 0));
    QVERIFY(unmoved.isEmpty());
    TreeDelta moved = deltaStartingAt(builder.tree);
    moveLeaf(moved, builder.tree, 0, leafAround(3, 0.75F, 0.0));
    QCOMPARE(moved.leaves.along.size(), std::size_t{1});
    QVERIFY(moved.leaves.internode.empty() && moved.leaves.rotation.empty() && moved.leaves.length.empty() &&
            moved.leaves.kind.empty());
}

const TestClass<LeafPlacementTest> leafPlacementTest;

} // namespace espalier::test

#include "LeafPlacementTest.moc"
