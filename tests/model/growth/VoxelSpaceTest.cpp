// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/VoxelSpace.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>
#include <map>
#include <set>

namespace espalier::test {

class VoxelSpaceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void cell_coversItsHalfOpenCube();
    void cell_farAwayOrNotANumberStaysInRange();
    void caster_shades455VoxelsNoneOfThemAbove();
    void casterPerVoxel_addsUpToTheKnownShadow();
    void loneCaster_seesFullLight();
    void shadow_castAndLifted_leavesNothing();
    void shadow_doesNotDependOnTheOrderOfCasters();
    void shadow_isTheSumOverAllCasters();
    void castShadows_visitsOccupiedVoxelsWhoseShadowChanged();
    void light_betweenVoxelCentresIsInterpolated();
    void light_staysWithinZeroAndOne();
    void nodes_areFoundInTheBoxThatHoldsThem();
    void place_containsThePositionsOfItsVoxel();
    void bricksThatAreOnlyShaded_takeLessMemory();
    void shaded_areTheOccupiedVoxelsBelowTheCasters();
};

namespace {

constexpr ShadowPyramid kKnownPyramid{0.03, 1.8, 6};

template <class Visit>
void forEachCell(int reach, Visit&& visit)
{
    for (int x = -reach; x <= reach; ++x) {
        for (int y = -reach; y <= reach; ++y) {
            for (int z = -reach; z <= reach; ++z)
                visit(Cell{x, y, z});
        }
    }
}

void cast(VoxelSpace& space)
{
    space.castShadows([](VoxelSpace::Residents, std::uint32_t) {});
}

/// Inserts the ids from @p first up to but not including @p end; returns their places by id.
std::vector<VoxelSpace::Place> insertAll(VoxelSpace& space, const std::vector<Vec3>& positions,
                                         InternodeId first, InternodeId end)
{
    std::vector<VoxelSpace::Place> places(end);
    for (InternodeId id = first; id < end; ++id)
        places[id] = space.insert(id, positions[id]);
    return places;
}

std::vector<Vec3> randomPositions(std::uint64_t seed, int count, float spread)
{
    Random random(seed, 0, 0, Purpose::Direction);
    std::vector<Vec3> positions;
    for (int i = 0; i < count; ++i)
        positions.push_back(spread * random.inBall());
    return positions;
}

/// Shadow that a caster in @p caster throws on @p shaded, in integer units.
std::int64_t pyramidShadow(const ShadowPyramid& pyramid, const Cell& caster, const Cell& shaded)
{
    const int q = caster.y - shaded.y;
    if (q < 0 || q > pyramid.depth || std::abs(caster.x - shaded.x) > q || std::abs(caster.z - shaded.z) > q)
        return 0;
    return std::llround(pyramid.intensity * std::pow(pyramid.falloff, -q) * VoxelSpace::kShadowUnit);
}

} // namespace

void VoxelSpaceTest::cell_coversItsHalfOpenCube()
{
    const VoxelSpace space(0.5F, {});
    QCOMPARE(space.cellAt({0.0F, 0.0F, 0.0F}), (Cell{0, 0, 0}));
    QCOMPARE(space.cellAt({0.499F, 0.5F, -0.001F}), (Cell{0, 1, -1}));
    QCOMPARE(space.cellAt({-0.5F, -0.501F, 4.0F}), (Cell{-1, -2, 8}));
    forEachCell(9, [&](const Cell& cell) { QCOMPARE(space.cellAt(space.centreOf(cell)), cell); });
}

void VoxelSpaceTest::cell_farAwayOrNotANumberStaysInRange()
{
    VoxelSpace space(0.01F, kKnownPyramid);
    for (const float far : {1e9F, -1e9F, 1e30F, std::numeric_limits<float>::infinity()}) {
        const VoxelSpace::Place place = space.insert(0, {far, far, far});
        cast(space);
        space.remove(0, place);
        cast(space);
        QCOMPARE(space.shadow(space.cellAt({far, far, far})), 0U);
    }
}

void VoxelSpaceTest::caster_shades455VoxelsNoneOfThemAbove()
{
    VoxelSpace space(0.2F, kKnownPyramid);
    space.insert(0, {0.1F, 0.1F, 0.1F});
    cast(space);
    int shaded = 0;
    double sum = 0.0;
    forEachCell(12, [&](const Cell& cell) {
        const std::uint32_t shadow = space.shadow(cell);
        QCOMPARE(static_cast<std::int64_t>(shadow), pyramidShadow(kKnownPyramid, {0, 0, 0}, cell));
        shaded += shadow > 0 ? 1 : 0;
        sum += shadow / VoxelSpace::kShadowUnit;
    });
    QCOMPARE(shaded, 455);
    // 0.03 Σ (2q+1)² 1.8^-q, the shadow of one caster in each voxel of a column.
    QVERIFY(std::abs(sum - 1.2362) < 455 * 0.5 / VoxelSpace::kShadowUnit + 5e-5);
}

void VoxelSpaceTest::casterPerVoxel_addsUpToTheKnownShadow()
{
    VoxelSpace space(1.0F, kKnownPyramid);
    InternodeId id = 0;
    forEachCell(7, [&](const Cell& cell) { space.insert(id++, space.centreOf(cell)); });
    cast(space);
    QVERIFY(std::abs(space.shadow({0, 0, 0}) / VoxelSpace::kShadowUnit - 1.2362) <
            455 * 0.5 / VoxelSpace::kShadowUnit + 5e-5);
}

void VoxelSpaceTest::loneCaster_seesFullLight()
{
    for (const double intensity : {0.0, 0.013, 0.2, 0.999, 1.0}) {
        VoxelSpace space(0.2F, {intensity, 1.5, 4});
        space.insert(0, Vec3::Zero());
        cast(space);
        QVERIFY(std::abs(space.light({0, 0, 0}) - 1.0F) < 4e-6F); // to the unit of the sums
        QVERIFY(space.light({0, 0, 0}) <= 1.0F);
    }
}

void VoxelSpaceTest::shadow_castAndLifted_leavesNothing()
{
    VoxelSpace space(0.3F, {0.0213, 1.37, 5});
    const auto positions = randomPositions(1, 300, 3.0F);
    const auto early = insertAll(space, positions, 0, 150);
    cast(space);
    std::map<Cell, std::uint32_t> before;
    forEachCell(20, [&](const Cell& cell) { before[cell] = space.shadow(cell); });

    const auto late = insertAll(space, positions, 150, 300);
    cast(space);
    for (InternodeId id = 300; id-- > 150;) {
        space.remove(id, late[id]);
        if (id % 7 == 0)
            cast(space);
    }
    cast(space);
    forEachCell(20, [&](const Cell& cell) { QCOMPARE(space.shadow(cell), before[cell]); });

    for (InternodeId id = 0; id < 150; ++id)
        space.remove(id, early[id]);
    cast(space);
    forEachCell(20, [&](const Cell& cell) { QCOMPARE(space.shadow(cell), 0U); });
}

void VoxelSpaceTest::shadow_doesNotDependOnTheOrderOfCasters()
{
    const auto positions = randomPositions(2, 200, 2.0F);
    VoxelSpace forwards(0.25F, kKnownPyramid);
    VoxelSpace backwards(0.25F, kKnownPyramid);
    for (InternodeId id = 0; id < 200; ++id) {
        forwards.insert(id, positions[id]);
        backwards.insert(199 - id, positions[199 - id]);
        if (id % 50 == 0)
            cast(backwards);
    }
    cast(forwards);
    cast(backwards);
    forEachCell(16, [&](const Cell& cell) { QCOMPARE(backwards.shadow(cell), forwards.shadow(cell)); });
}

void VoxelSpaceTest::shadow_isTheSumOverAllCasters()
{
    for (std::uint64_t seed = 0; seed < 12; ++seed) {
        Random random(seed, 1, 0, Purpose::Direction);
        const ShadowPyramid pyramid{random.uniform(0.0, 0.2), random.uniform(1.01, 4.0),
                                    static_cast<int>(seed)};
        VoxelSpace space(0.25F, pyramid);
        const auto positions = randomPositions(seed, 120, 2.5F);
        for (InternodeId id = 0; id < positions.size(); ++id)
            space.insert(id, positions[id]);
        cast(space);
        forEachCell(12, [&](const Cell& cell) {
            std::int64_t sum = 0;
            for (const Vec3& position : positions)
                sum += pyramidShadow(pyramid, space.cellAt(position), cell);
            QCOMPARE(static_cast<std::int64_t>(space.shadow(cell)), sum);
        });
    }
}

void VoxelSpaceTest::castShadows_visitsOccupiedVoxelsWhoseShadowChanged()
{
    VoxelSpace space(0.25F, kKnownPyramid);
    const auto positions = randomPositions(3, 200, 2.0F);
    const auto places = insertAll(space, positions, 0, 150);
    cast(space);
    std::map<Cell, std::uint32_t> before;
    for (const Vec3& position : positions)
        before[space.cellAt(position)] = space.shadow(space.cellAt(position));

    for (InternodeId id = 150; id < 200; ++id)
        space.insert(id, positions[id]);
    for (InternodeId id = 0; id < 20; ++id)
        space.remove(id, places[id]);
    std::set<Cell> visited;
    space.castShadows([&](VoxelSpace::Residents residents, std::uint32_t shadow) {
        const Cell cell = space.cellAt(positions[residents.front()]);
        QVERIFY(visited.insert(cell).second);
        QCOMPARE(shadow, space.shadow(cell));
    });
    for (InternodeId id = 20; id < 200; ++id) {
        const Cell cell = space.cellAt(positions[id]);
        if (space.shadow(cell) != before[cell])
            QVERIFY(visited.contains(cell));
    }
    // No change is pending.
    space.castShadows([&](VoxelSpace::Residents, std::uint32_t) { QFAIL("visited without a change"); });
}

void VoxelSpaceTest::light_betweenVoxelCentresIsInterpolated()
{
    VoxelSpace space(0.5F, {0.2, 1.5, 3});
    const auto positions = randomPositions(4, 40, 2.0F);
    for (InternodeId id = 0; id < positions.size(); ++id)
        space.insert(id, positions[id]);
    cast(space);
    forEachCell(5, [&](const Cell& cell) {
        const Vec3 centre = space.centreOf(cell);
        QVERIFY(std::abs(space.lightAt(centre) - space.light(cell)) < 1e-4F);
        const Vec3 right = space.centreOf({cell.x + 1, cell.y, cell.z});
        const float expected = 0.25F * space.light(cell) + 0.75F * space.light({cell.x + 1, cell.y, cell.z});
        QVERIFY(std::abs(space.lightAt(0.25F * centre + 0.75F * right) - expected) < 1e-4F);
    });
}

void VoxelSpaceTest::light_staysWithinZeroAndOne()
{
    VoxelSpace space(0.5F, {1.0, 1.01, 6});
    for (InternodeId id = 0; id < 500; ++id)
        space.insert(id, Vec3::Zero());
    cast(space);
    QCOMPARE(space.light({0, 0, 0}), 0.0F);
    QCOMPARE(space.light({0, -6, 0}), 0.0F);
    QCOMPARE(space.light({0, 1, 0}), 1.0F);
    for (const Vec3& position : randomPositions(5, 1000, 4.0F)) {
        QVERIFY(space.lightAt(position) >= 0.0F);
        QVERIFY(space.lightAt(position) <= 1.0F);
    }
}

void VoxelSpaceTest::nodes_areFoundInTheBoxThatHoldsThem()
{
    VoxelSpace space(0.25F, kKnownPyramid);
    auto positions = randomPositions(6, 400, 4.0F);
    const auto places = insertAll(space, positions, 0, 400);
    space.settle();
    for (InternodeId id = 0; id < 400; id += 3)
        space.remove(id, places[id]);
    // A removed and re-inserted node counts as moved, also within a voxel; an inserted and removed one counts
    // as nothing.
    for (const InternodeId id : {1U, 2U}) {
        space.remove(id, places[id]);
        positions[id] = id == 1 ? positions[7] : Vec3(space.centreOf(space.cellAt(positions[id])));
        const VoxelSpace::Place place = space.insert(id, positions[id]);
        QCOMPARE(place == places[id], id == 2);
    }
    space.remove(400, space.insert(400, positions[2]));
    space.settle();
    Random random(7, 0, 0, Purpose::Direction);
    for (int box = 0; box < 100; ++box) {
        const Cell lower = space.cellAt(4.0F * random.inBall());
        const Cell upper{lower.x + static_cast<int>(random.bits() % 12),
                         lower.y + static_cast<int>(random.bits() % 12),
                         lower.z + static_cast<int>(random.bits() % 12)};
        std::set<InternodeId> found;
        bool isTwice = false;
        const bool any = space.anyRun(lower, upper, [&](VoxelSpace::Residents residents) {
            for (const InternodeId id : residents)
                isTwice = isTwice || !found.insert(id).second;
            return false;
        });
        QVERIFY(!any && !isTwice);
        std::set<InternodeId> expected;
        for (InternodeId id = 0; id < 400; ++id) {
            const Cell c = space.cellAt(positions[id]);
            if (id % 3 != 0 && c.x >= lower.x && c.x <= upper.x && c.y >= lower.y && c.y <= upper.y &&
                c.z >= lower.z && c.z <= upper.z)
                expected.insert(id);
        }
        QVERIFY(found == expected);
        QCOMPARE(space.anyRun(lower, upper, [](VoxelSpace::Residents) { return true; }), !expected.empty());
    }
}

void VoxelSpaceTest::place_containsThePositionsOfItsVoxel()
{
    VoxelSpace space(0.25F, kKnownPyramid);
    const auto positions = randomPositions(10, 200, 2.0F);
    const auto places = insertAll(space, positions, 0, 200);
    int together = 0;
    for (InternodeId a = 0; a < 200; ++a) {
        for (InternodeId b = 0; b < 200; ++b) {
            const bool isSame = space.cellAt(positions[a]) == space.cellAt(positions[b]);
            QCOMPARE(space.isAt(places[a], positions[b]), isSame);
            together += isSame && a != b ? 1 : 0;
        }
    }
    QVERIFY(together > 0);
}

void VoxelSpaceTest::bricksThatAreOnlyShaded_takeLessMemory()
{
    VoxelSpace space(1.0F, kKnownPyramid);
    // The pyramid of shadow is in the caster's brick and in the four below it.
    space.insert(0, {0.5F, 0.5F, 0.5F});
    cast(space);
    const std::size_t one = space.bytes();
    QVERIFY2(one > 5 * 2048, qPrintable(QString::number(one)));
    QVERIFY2(one < 5 * 3072, qPrintable(QString::number(one)));
    // Memory for many insertions is freed after them.
    std::vector<VoxelSpace::Place> places;
    for (InternodeId id = 1; id < 20'000; ++id)
        places.push_back(space.insert(id, {0.5F, 0.5F, 0.5F}));
    cast(space);
    QVERIFY2(space.bytes() < one + 3 * 20'000 * sizeof(InternodeId),
             qPrintable(QString::number(space.bytes())));
}

void VoxelSpaceTest::shaded_areTheOccupiedVoxelsBelowTheCasters()
{
    VoxelSpace space(0.25F, kKnownPyramid);
    const auto positions = randomPositions(8, 300, 3.0F);
    for (InternodeId id = 0; id < 300; ++id)
        space.insert(id, positions[id]);
    cast(space);
    std::vector<Cell> casters;
    for (const Vec3& position : randomPositions(9, 6, 3.0F))
        casters.push_back(space.cellAt(position));
    std::set<Cell> found;
    space.forEachShaded(casters, [&](VoxelSpace::Residents residents) {
        QVERIFY(found.insert(space.cellAt(positions[residents.front()])).second);
    });
    std::set<Cell> expected;
    for (const Vec3& position : positions) {
        for (const Cell& caster : casters) {
            if (pyramidShadow(kKnownPyramid, caster, space.cellAt(position)) > 0)
                expected.insert(space.cellAt(position));
        }
    }
    QVERIFY(!expected.empty());
    QVERIFY(found == expected);
}

const TestClass<VoxelSpaceTest> voxelSpaceTest;

} // namespace espalier::test

#include "VoxelSpaceTest.moc"
