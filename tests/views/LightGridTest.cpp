// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/LightGrid.h"

#include "model/document/TreeDocument.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

using namespace espalier;

namespace {

/// Cells of @p grid that do not hold the light of their voxel.
int wrongCells(const LightGrid& grid, const VoxelSpace& space)
{
    int wrong = 0;
    const auto& size = grid.size();
    for (int z = 0; z < size[2]; ++z) {
        for (int y = 0; y < size[1]; ++y) {
            for (int x = 0; x < size[0]; ++x) {
                const Vec3 inCells(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F,
                                   static_cast<float>(z) + 0.5F);
                const float light = space.lightAt(grid.origin() + grid.cellEdge() * inCells);
                const std::uint8_t cell =
                    grid.cells()[static_cast<std::size_t>((z * size[1] + y) * size[0] + x)];
                wrong += std::abs(255.0F * light - static_cast<float>(cell)) > 1.0F ? 1 : 0;
            }
        }
    }
    return wrong;
}

Box3 touched(const TreeDocument& document, const TreeDelta& delta)
{
    Box3 box;
    delta.forEachTouched([&](InternodeId id) { box.extend(document.index().nodePosition(id)); });
    return box;
}

void grow(TreeDocument& document, std::uint32_t internodes)
{
    test::apply(document, (test::randomGrowth(document.tree(), internodes)));
}

} // namespace

class LightGridTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void seedling_hasAGrid();
    void update_isAsGoodAsRebuilding();
    void update_changesOnlyAPart();
    void largeTrees_fitTheGrid();
    void otherVoxels_makeAnotherGrid();
};

void LightGridTest::seedling_hasAGrid()
{
    const TreeDocument document;
    LightGrid grid;
    grid.rebuild(document.growthModel().space());
    for (const int edge : grid.size())
        QVERIFY(edge >= 1);
    QVERIFY(grid.takeChanges().all);
    QVERIFY(grid.takeChanges().isEmpty());
    QCOMPARE(wrongCells(grid, document.growthModel().space()), 0);
}

void LightGridTest::update_isAsGoodAsRebuilding()
{
    TreeDocument document;
    const VoxelSpace& space = document.growthModel().space();
    LightGrid grid;
    grid.rebuild(space);
    connect(&document, &TreeDocument::changed, this,
            [&](const TreeChange& change) { grid.update(space, touched(document, *change.delta)); });
    for (int step = 0; step < 25; ++step) {
        grow(document, 40);
        QCOMPARE(wrongCells(grid, space), 0);
    }
    for (int step = 0; step < 25; ++step) {
        test::travel(document, document.journal().size() - 1);
        QCOMPARE(wrongCells(grid, space), 0);
    }
    QVERIFY(std::ranges::all_of(grid.cells(), [](std::uint8_t cell) { return cell == 255; }));
}

void LightGridTest::update_changesOnlyAPart()
{
    TreeDocument document;
    for (int step = 0; step < 20; ++step)
        grow(document, 40);
    LightGrid grid;
    grid.rebuild(document.growthModel().space());
    grid.takeChanges();
    InternodeId tip = document.tree().size() - 1;
    test::apply(document, (test::births(document.tree(), std::array{test::NewInternode{.parent = tip}})));
    grid.update(document.growthModel().space(), touched(document, *document.journal().back()));
    const LightGrid::Changes changes = grid.takeChanges();
    QVERIFY(!changes.all);
    QVERIFY(!changes.isEmpty());
    const auto cells =
        static_cast<std::size_t>(changes.region.count[0] * changes.region.count[1] * changes.region.count[2]);
    QVERIFY(cells < grid.cells().size() / 4);
    grid.update(document.growthModel().space(), Box3());
    QVERIFY(grid.takeChanges().isEmpty());
}

void LightGridTest::largeTrees_fitTheGrid()
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 2.0;
    parameters.growth.occupancyRadius = 0.5;
    TreeDocument document;
    document.reset(1, parameters);
    // A pole of 150 internodes is 300 voxels high.
    std::vector<test::NewInternode> pole;
    for (std::uint32_t i = 0; i < 150; ++i)
        pole.push_back({.parent = i, .length = 2.0F});
    test::apply(document, (test::births(document.tree(), pole)));
    const VoxelSpace& space = document.growthModel().space();
    LightGrid grid;
    grid.rebuild(space);
    QVERIFY(space.bounds().upper.y - space.bounds().lower.y > LightGrid::kMaxEdge);
    for (const int edge : grid.size())
        QVERIFY(edge <= LightGrid::kMaxEdge);
    QVERIFY(grid.cellEdge() > space.edge());
    QCOMPARE(wrongCells(grid, space), 0);
}

void LightGridTest::otherVoxels_makeAnotherGrid()
{
    TreeDocument document;
    grow(document, 30);
    LightGrid grid;
    grid.rebuild(document.growthModel().space());
    const float edge = grid.cellEdge();
    TreeParameters parameters = document.parameters();
    parameters.growth.occupancyRadius *= 2.0;
    document.reset(1, parameters);
    grid.update(document.growthModel().space(), Box3());
    QVERIFY(grid.takeChanges().all);
    QVERIFY(std::abs(grid.cellEdge() - 2.0F * edge) < 1e-6F);
}

static const test::TestClass<LightGridTest> lightGridTest;

#include "LightGridTest.moc"
