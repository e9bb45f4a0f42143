// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/ProfileSlots.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QElapsedTimer>
#include <QTest>

#include <numbers>

namespace espalier::test {

class ProfileSlotsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void slots_areInsideAndApart_data();
    void slots_areInsideAndApart();
    void bundles_areDense_data();
    void bundles_areDense();
    void attractors_gatherTheStrands();
    void parts_shareStrandsByTheirAreas();
    void tenThousandStrands_areQuick();
    void slots_ofAScaledProfile_areTheSame();
    void slits_doNotTakeLong();
};

namespace {

StrandProfile attracted(StrandProfile profile, const Vec2& from, const Vec2& to)
{
    profile.attractors.push_back({from, to});
    return profile;
}

StrandProfile unequalParts()
{
    StrandProfile profile = profileOf(ProfileShape::Round);
    profile.boundaries.push_back(rectangle(0.04F, 0.04F, Vec2(1.2F, 0.0F)).boundaries.front());
    profile.boundaries.push_back(rectangle(0.5F, 0.5F, Vec2(0.0F, 1.6F)).boundaries.front());
    return profile;
}

} // namespace

void ProfileSlotsTest::slots_areInsideAndApart_data()
{
    QTest::addColumn<StrandProfile>("profile");
    for (int i = 0; i < kProfileShapeCount; ++i)
        QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(i)))
            << profileOf(static_cast<ProfileShape>(i));
    QTest::newRow("thin C") << thinC(0.1F);
    QTest::newRow("very thin C") << thinC(0.005F);
    QTest::newRow("unequal parts") << unequalParts();
    QTest::newRow("tiny") << scaled(profileOf(ProfileShape::CShape), 0.01F);
    QTest::newRow("huge") << scaled(profileOf(ProfileShape::Ring), 80.0F);
    QTest::newRow("far away") << rectangle(0.1F, 0.1F, Vec2(99.0F, -99.0F));
    QTest::newRow("attractor") << attracted(profileOf(ProfileShape::Round), {-0.9F, 0.0F}, {-0.5F, 0.0F});
    QTest::newRow("attractor outside")
        << attracted(profileOf(ProfileShape::Round), {9.0F, 0.0F}, {9.0F, 9.0F});
    QTest::newRow("attractor, a point")
        << attracted(profileOf(ProfileShape::Ring), {0.0F, 0.0F}, {0.0F, 0.0F});
    QTest::newRow("triangle") << polygon({{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}});
}

void ProfileSlotsTest::slots_areInsideAndApart()
{
    QFETCH(const StrandProfile, profile);
    QCOMPARE(profileFault(profile), QString());
    for (const std::uint32_t strands : {1U, 2U, 3U, 7U, 50U, 777U}) {
        const ProfileSlots result = profileSlots(profile, strands);
        QCOMPARE(result.places.size(), strands);
        QVERIFY(std::isfinite(result.scale) && result.scale > 0.0F);
        QVERIFY(nearestPair(result.places) >= 1.9F);
        for (const Vec2& place : result.places)
            QVERIFY(distanceOutside(profile, place / result.scale) * result.scale < 0.5F);
    }
}

void ProfileSlotsTest::bundles_areDense_data()
{
    QTest::addColumn<StrandProfile>("profile");
    for (int i = 0; i < kProfileShapeCount; ++i)
        QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(i)))
            << profileOf(static_cast<ProfileShape>(i));
    QTest::newRow("unequal parts") << unequalParts();
    QTest::newRow("attractor") << attracted(profileOf(ProfileShape::Round), {-0.9F, 0.0F}, {-0.5F, 0.0F});
}

void ProfileSlotsTest::bundles_areDense()
{
    QFETCH(const StrandProfile, profile);
    for (const std::uint32_t strands : {50U, 200U, 1000U}) {
        const ProfileSlots result = profileSlots(profile, strands);
        const double area = double{areaOf(profile)} * std::pow(double{result.scale}, 2.0);
        const double fill = std::numbers::pi * strands / area;
        QVERIFY2(fill >= 0.7 && fill <= 0.95, qPrintable(QStringLiteral("%1: %2").arg(strands).arg(fill)));
    }
}

void ProfileSlotsTest::attractors_gatherTheStrands()
{
    const StrandProfile profile = attracted(rectangle(4.0F, 4.0F), {-1.9F, -2.0F}, {-1.9F, 2.0F});
    const ProfileSlots result = profileSlots(profile, 400);
    for (const Vec2& place : result.places)
        QVERIFY(place.x() / result.scale < 1.5F); // A fifth of the area stays free
}

void ProfileSlotsTest::parts_shareStrandsByTheirAreas()
{
    StrandProfile profile = rectangle(1.0F, 1.0F, Vec2(-2.0F, 0.0F));
    profile.boundaries.push_back(rectangle(3.0F, 1.0F, Vec2(2.0F, 0.0F)).boundaries.front());
    const ProfileSlots result = profileSlots(profile, 400);
    const auto left =
        std::ranges::count_if(result.places, [](const Vec2& place) { return place.x() < 0.0F; });
    QVERIFY2(left > 85 && left < 115, qPrintable(QString::number(left)));
}

void ProfileSlotsTest::tenThousandStrands_areQuick()
{
    QElapsedTimer timer;
    timer.start();
    const StrandProfile profile = profileOf(ProfileShape::CShape);
    const ProfileSlots result = profileSlots(profile, 10'000);
    QVERIFY2(timer.elapsed() < 400, qPrintable(QString::number(timer.elapsed())));
    QCOMPARE(result.places.size(), 10'000U);
    for (const Vec2& place : result.places)
        QVERIFY(distanceOutside(profile, place / result.scale) * result.scale < 0.5F);
}

void ProfileSlotsTest::slots_ofAScaledProfile_areTheSame()
{
    // Only the shape counts. A power of two leaves no rounding.
    const StrandProfile profile = profileOf(ProfileShape::Fluted);
    const ProfileSlots own = profileSlots(profile, 300);
    const ProfileSlots larger = profileSlots(scaled(profile, 4.0F), 300);
    QVERIFY(std::abs(own.scale / larger.scale - 4.0F) < 1e-4F);
    for (std::size_t i = 0; i < 300; ++i)
        QVERIFY((own.places[i] - larger.places[i]).norm() < 1e-2F);
}

void ProfileSlotsTest::slits_doNotTakeLong()
{
    const float far = kFarthestProfilePoint;
    const StrandProfile upright = rectangle(2e-6F, 2.0F * far);
    const StrandProfile level = rectangle(2.0F * far, 4e-5F, Vec2(0.0F, 3.3F));
    const StrandProfile slanted =
        polygon({{-far, -far}, {far, 0.9F * far}, {far, 0.9F * far + 1e-4F}, {-far, -far + 1e-4F}});
    for (const StrandProfile& profile : {upright, level, slanted}) {
        QCOMPARE(profileFault(profile), QString());
        for (const std::uint32_t strands : {1U, 50U, 5000U}) {
            QElapsedTimer timer;
            timer.start();
            const ProfileSlots result = profileSlots(profile, strands);
            QCOMPARE(result.places.size(), strands);
            QVERIFY2(timer.elapsed() < 3000, qPrintable(QString::number(timer.elapsed())));
        }
    }
}

static const TestClass<ProfileSlotsTest> profileSlotsTest;

} // namespace espalier::test

#include "ProfileSlotsTest.moc"
