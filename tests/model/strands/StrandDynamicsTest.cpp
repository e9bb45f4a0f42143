// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandDynamics.h"

#include "model/strands/DiscGrid.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <numbers>

namespace espalier::test {

class StrandDynamicsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void twoDiscs_atDistanceOne_goToTheKnownDistance();
    void step_ofOneDisc_isAtMostTheGreatestSpeed();
    void discs_atOnePlace_part();
    void discs_gatherAroundTheMiddle();
    void steps_areLimitedByTheNumberOfDiscs();
    void discs_outsideAProfile_goToItsBoundary();
    void discs_insideAProfile_goToItsAttractors();
    void grid_findsAllPairs_data();
    void grid_findsAllPairs();
};

void StrandDynamicsTest::twoDiscs_atDistanceOne_goToTheKnownDistance()
{
    // The collision pass alone leads to 1.9; then each goes on by the greatest move of a step, 0.12. With
    // the outline of a profile around them, nothing pulls.
    const StrandProfile around = scaled(profileOf(ProfileShape::Round), 50.0F);
    for (const StrandProfile* const profile : {static_cast<const StrandProfile*>(nullptr), &around}) {
        std::vector<Vec2> discs{{-0.5F, 0.0F}, {0.5F, 0.0F}};
        packByDynamics(discs, 1, profile, 1.0F);
        QVERIFY(std::abs((discs[1] - discs[0]).norm() - 2.14F) < 1e-5F);
        QVERIFY((discs[0] + discs[1]).norm() < 1e-6F);
    }
}

void StrandDynamicsTest::step_ofOneDisc_isAtMostTheGreatestSpeed()
{
    std::vector<Vec2> disc{{10.0F, 0.0F}};
    packByDynamics(disc, 1, nullptr, 1.0F);
    QVERIFY(std::abs(disc[0].x() - 9.88F) < 1e-5F);
    QCOMPARE(disc[0].y(), 0.0F);
    packByDynamics(disc, 0, nullptr, 1.0F);
    QVERIFY(std::abs(disc[0].x() - 9.88F) < 1e-5F);
}

void StrandDynamicsTest::discs_atOnePlace_part()
{
    std::vector<Vec2> discs(30, Vec2(1.0F, 2.0F));
    packByDynamics(discs, 100, nullptr, 1.0F);
    for (const Vec2& disc : discs)
        QVERIFY(disc.allFinite());
    QVERIFY(nearestPair(discs) > 0.3F);
}

void StrandDynamicsTest::discs_gatherAroundTheMiddle()
{
    std::vector<Vec2> discs;
    for (int i = 0; i < 50; ++i)
        discs.emplace_back(static_cast<float>(3 * (i % 10)), static_cast<float>(3 * (i / 10)));
    packByDynamics(discs, 500, nullptr, 1.0F);
    float radius = 0.0F;
    for (const Vec2& disc : discs)
        radius = std::max(radius, disc.norm() + 1.0F);
    QVERIFY2(50.0F / (radius * radius) >= 0.55F, qPrintable(QString::number(double{radius})));
    QVERIFY(nearestPair(discs) > 0.8F); // The discs do not come to rest
}

void StrandDynamicsTest::steps_areLimitedByTheNumberOfDiscs()
{
    std::vector<Vec2> few{{100.0F, 0.0F}};
    packByDynamics(few, 10'000, nullptr, 1.0F);
    QVERIFY(std::abs(few[0].x() - (100.0F - 5.0F * 0.12F)) < 1e-3F);
}

void StrandDynamicsTest::discs_outsideAProfile_goToItsBoundary()
{
    const StrandProfile square = rectangle(2.0F, 2.0F);
    std::vector<Vec2> discs;
    for (int i = 0; i < 40; ++i)
        discs.emplace_back(static_cast<float>(20 + 2 * (i % 5)), static_cast<float>(2 * (i / 5)));
    packByDynamics(discs, 5000, &square, 10.0F);
    for (const Vec2& disc : discs)
        QVERIFY(distanceOutside(square, disc / 10.0F) < 0.7F);
}

void StrandDynamicsTest::discs_insideAProfile_goToItsAttractors()
{
    StrandProfile square = rectangle(2.0F, 2.0F);
    square.attractors.push_back({Vec2(0.5F, -0.5F), Vec2(0.5F, 0.5F)});
    std::vector<Vec2> discs;
    for (int i = 0; i < 10; ++i)
        discs.emplace_back(-8.0F, static_cast<float>(2 * i - 9));
    packByDynamics(discs, 5000, &square, 10.0F);
    for (const Vec2& disc : discs)
        QVERIFY(disc.x() > -6.0F);
}

void StrandDynamicsTest::grid_findsAllPairs_data()
{
    QTest::addColumn<double>("extent");
    for (const double extent : {1e-6, 3.0, 30.0, 300.0, 1e7})
        QTest::newRow(qPrintable(QString::number(extent))) << extent;
}

void StrandDynamicsTest::grid_findsAllPairs()
{
    QFETCH(const double, extent);
    Random random(3, 0, 0, Purpose::Direction);
    std::vector<Vec2> discs;
    for (int i = 0; i < 300; ++i)
        discs.emplace_back(static_cast<float>(random.uniform(-extent, extent)),
                           static_cast<float>(random.uniform(-extent, extent)));
    discs.push_back(discs.front());
    DiscGrid grid;
    grid.sort(discs);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    grid.forEachPair(discs, 2.0F,
                     [&](std::uint32_t a, std::uint32_t b) { found.emplace_back(std::minmax(a, b)); });
    std::ranges::sort(found);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> expected;
    for (std::uint32_t a = 0; a < discs.size(); ++a) {
        for (std::uint32_t b = a + 1; b < discs.size(); ++b) {
            if ((discs[a] - discs[b]).squaredNorm() < 4.0F)
                expected.emplace_back(a, b);
        }
    }
    QVERIFY(!expected.empty());
    QVERIFY(found == expected);
    grid.sort({});
    grid.forEachPair({}, 2.0F, [](std::uint32_t, std::uint32_t) { QFAIL("there are no discs"); });
}

static const TestClass<StrandDynamicsTest> strandDynamicsTest;

} // namespace espalier::test

#include "StrandDynamicsTest.moc"
