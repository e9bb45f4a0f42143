// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/base/Error.h"
#include "model/base/Headroom.h"
#include "model/base/Ids.h"
#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <atomic>
#include <set>

namespace espalier::test {

class BaseTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void random_isAFunctionOfItsKey();
    void random_differsWithEachPartOfItsKey();
    void uniform_fillsItsRangeEvenly();
    void normal_hasMeanZeroAndDeviationOne();
    void direction_isUniformOnTheSphere();
    void ball_isFilledUniformly();
    void consecutiveNumbers_areNotCorrelated();
    void perpendicular_isAUnitVectorAtRightAngles();
    void degrees_andRadiansInvert();
    void parallelFor_coversEachIndexOnce();
    void columnThatGrows_keepsAnEighthOfHeadroom();
    void columnThatGrows_isCopiedInLinearTime();
    void columnThatIsShared_leavesItsCopyAlone();
    void clearedScratch_keepsLittleMemory();
    void idRange_containsItsMembersOnly();
    void result_holdsAValueOrAnError();
};

void BaseTest::random_isAFunctionOfItsKey()
{
    Random a(1, 2, 3, Purpose::Leaf);
    Random b(1, 2, 3, Purpose::Leaf);
    for (int i = 0; i < 100; ++i)
        QCOMPARE(a.bits(), b.bits());
    // Part of "same recipe, same tree": it must never change. Worked out by hand from the definition of
    // SplitMix64.
    Random known(1, 2, 3, Purpose::Leaf);
    const std::uint64_t first = known.bits();
    QCOMPARE(first, 0x28d1312bb8ed9dc9U);
}

void BaseTest::random_differsWithEachPartOfItsKey()
{
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed : {0ULL, 1ULL, 1ULL << 63}) {
        for (std::uint32_t step : {0U, 1U, 2U}) {
            for (std::uint32_t id : {0U, 1U, 2U}) {
                for (Purpose purpose : {Purpose::BrushMarker, Purpose::BudMarker, Purpose::InternodeLength}) {
                    Random random(seed, step, id, purpose);
                    for (int i = 0; i < 20; ++i)
                        QVERIFY(seen.insert(random.bits()).second);
                }
            }
        }
    }
}

void BaseTest::uniform_fillsItsRangeEvenly()
{
    Random random(7, 0, 0, Purpose::ShootLength);
    std::array<int, 20> counts{};
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double x = random.uniform(-3.0, 7.0);
        QVERIFY(x >= -3.0 && x < 7.0);
        ++counts[static_cast<std::size_t>((x + 3.0) * 2.0)];
    }
    double chiSquared = 0.0;
    for (const int n : counts)
        chiSquared += std::pow(n - count / 20.0, 2) / (count / 20.0);
    QVERIFY(chiSquared < 43.8); // 19 degrees of freedom, 0.1 %
}

void BaseTest::normal_hasMeanZeroAndDeviationOne()
{
    Random random(8, 0, 0, Purpose::ShootLength);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        const double x = random.normal();
        QVERIFY(std::abs(x) < 3.5);
        sum += x;
        squares += x * x;
    }
    QVERIFY(std::abs(sum / count) < 0.015);
    QVERIFY(std::abs(squares / count - 1.0) < 0.02);
}

void BaseTest::direction_isUniformOnTheSphere()
{
    Random random(9, 0, 0, Purpose::Direction);
    Vec3 sum = Vec3::Zero();
    std::array<int, 8> octants{};
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i) {
        const Vec3 direction = random.direction();
        QVERIFY(std::abs(direction.norm() - 1.0F) < 1e-5F);
        sum += direction;
        ++octants[(direction.x() > 0 ? 1U : 0U) + (direction.y() > 0 ? 2U : 0U) +
                  (direction.z() > 0 ? 4U : 0U)];
    }
    QVERIFY(sum.norm() / count < 0.015F);
    for (const int n : octants)
        QVERIFY(std::abs(n - count / 8) < 300);
}

void BaseTest::ball_isFilledUniformly()
{
    Random random(10, 0, 0, Purpose::BrushMarker);
    constexpr int count = 40000;
    int inner = 0;
    for (int i = 0; i < count; ++i) {
        const Vec3 point = random.inBall();
        QVERIFY(point.norm() <= 1.00001F);
        inner += point.norm() < 0.5F ? 1 : 0;
    }
    QVERIFY(std::abs(inner - count / 8) < 300);
}

void BaseTest::consecutiveNumbers_areNotCorrelated()
{
    // Neither along one key nor between neighbouring ids.
    double along = 0.0;
    double across = 0.0;
    constexpr std::uint32_t count = 50000;
    for (std::uint32_t id = 0; id < count; ++id) {
        Random random(11, 3, id, Purpose::Phyllotaxis);
        Random next(11, 3, id + 1, Purpose::Phyllotaxis);
        const double first = random.uniform() - 0.5;
        along += first * (random.uniform() - 0.5);
        across += first * (next.uniform() - 0.5);
    }
    QVERIFY(std::abs(12.0 * along / count) < 0.02);
    QVERIFY(std::abs(12.0 * across / count) < 0.02);
}

void BaseTest::perpendicular_isAUnitVectorAtRightAngles()
{
    Random random(12, 0, 0, Purpose::Direction);
    std::vector<Vec3> directions{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitX()};
    for (int i = 0; i < 1000; ++i)
        directions.push_back(random.direction());
    for (const Vec3& direction : directions) {
        const Vec3 side = anyPerpendicular(direction);
        QVERIFY(std::abs(side.norm() - 1.0F) < 1e-5F);
        QVERIFY(std::abs(side.dot(direction)) < 1e-5F);
    }
}

void BaseTest::degrees_andRadiansInvert()
{
    QCOMPARE(radians(180.0), std::numbers::pi);
    for (const double angle : {0.0, 37.5, 137.5, 359.0})
        QVERIFY(std::abs(degrees(radians(angle)) - angle) < 1e-12);
}

void BaseTest::parallelFor_coversEachIndexOnce()
{
    for (const std::size_t count : {0U, 1U, 7U, 8U, 9U, 1000U, 12345U}) {
        std::vector<std::atomic<int>> visits(count);
        parallelFor(count, 8, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        QVERIFY(std::ranges::all_of(visits, [](const auto& n) { return n == 1; }));
    }
}

namespace {

/// Grows a column to @p end elements, @p step at a time; returns how many elements were copied to new memory.
template <class Column>
std::size_t growColumn(Column& column, std::size_t end, std::size_t step)
{
    std::size_t copied = 0;
    while (static_cast<std::size_t>(column.size()) < end) {
        const auto size = static_cast<std::size_t>(column.size());
        const auto capacity = column.capacity();
        resizeColumn(column, size + step, 7);
        if (column.capacity() != capacity)
            copied += size;
    }
    return copied;
}

} // namespace

void BaseTest::columnThatGrows_keepsAnEighthOfHeadroom()
{
    const auto check = [](auto column) {
        for (const std::size_t size : {1U, 63U, 1'000U, 65'537U, 200'000U}) {
            growColumn(column, size, 13);
            const auto now = static_cast<std::size_t>(column.size());
            const auto capacity = static_cast<std::size_t>(column.capacity());
            QVERIFY2(capacity <= now + std::max<std::size_t>(64, now / 8),
                     qPrintable(QStringLiteral("%1 for %2").arg(capacity).arg(now)));
            QVERIFY(std::ranges::all_of(column, [](int value) { return value == 7; }));
        }
    };
    check(std::vector<int>());
    check(QList<int>());
}

void BaseTest::columnThatGrows_isCopiedInLinearTime()
{
    const auto check = [](auto column) {
        for (const std::size_t size : {100U, 10'000U, 1'000'000U}) {
            column.clear();
            column.shrink_to_fit();
            const std::size_t copied = growColumn(column, size, 1);
            QVERIFY2(copied <= 9 * size, qPrintable(QStringLiteral("%1 for %2").arg(copied).arg(size)));
        }
    };
    check(std::vector<int>());
    check(QList<int>());
}

void BaseTest::columnThatIsShared_leavesItsCopyAlone()
{
    QList<int> column;
    growColumn(column, 10'000, 1);
    const QList<int> snapshot = column;
    // With room and without.
    for (const qsizetype more : {1, 5'000}) {
        const QList<int> rows(more, 8);
        makeRoom(column, static_cast<std::size_t>(column.size() + more));
        column.append(rows);
        QCOMPARE(column.back(), 8);
        QVERIFY(column.capacity() <= column.size() + column.size() / 8);
    }
    QCOMPARE(snapshot, QList<int>(10'000, 7));
}

void BaseTest::clearedScratch_keepsLittleMemory()
{
    std::vector<int> list(1'000, 1);
    clearScratch(list);
    QVERIFY(list.empty());
    QVERIFY(list.capacity() >= 1'000); // no new allocation when it is filled again
    list.resize(100'000);
    clearScratch(list);
    QVERIFY(list.empty());
    QCOMPARE(list.capacity(), std::size_t{0});
}

void BaseTest::idRange_containsItsMembersOnly()
{
    const IdRange range{5, 3};
    QCOMPARE(range.end(), 8U);
    for (InternodeId id : {5U, 6U, 7U})
        QVERIFY(range.contains(id));
    for (InternodeId id : {0U, 4U, 8U, kNoInternode})
        QVERIFY(!range.contains(id));
    QVERIFY(!IdRange{}.contains(0));
}

void BaseTest::result_holdsAValueOrAnError()
{
    const Result<int> good = 3;
    QVERIFY(static_cast<bool>(good));
    QCOMPARE(*good, 3);
    const Result<int> bad = Error{Error::Kind::Cancelled, QStringLiteral("no")};
    QVERIFY(!bad);
    QVERIFY(bad.error().kind == Error::Kind::Cancelled);
    QCOMPARE(bad.error().message, QStringLiteral("no"));
    QVERIFY(static_cast<bool>(Result<void>()));
    QVERIFY(!Result<void>(Error{}));
}

const TestClass<BaseTest> baseTest;

} // namespace espalier::test

#include "BaseTest.moc"
