// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/StrandProfile.h"

#include "model/io/ProfileJson.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QJsonArray>
#include <QTest>

namespace espalier::test {

class StrandProfileTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void readyMadeShapes_areFaultless();
    void fault_saysWhatIsWrong_data();
    void fault_saysWhatIsWrong();
    void area_leavesOutCavities();
    void inside_followsTheEvenOddRule();
    void json_givesTheSameProfile();
    void json_ofAFaultyProfile_isRefused();
};

void StrandProfileTest::readyMadeShapes_areFaultless()
{
    for (int i = 0; i < kProfileShapeCount; ++i) {
        const StrandProfile profile = profileOf(static_cast<ProfileShape>(i));
        QCOMPARE(profileFault(profile), QString());
        const float area = areaOf(profile);
        QVERIFY2(area > 2.6F && area < 3.7F, qPrintable(QStringLiteral("%1: %2").arg(i).arg(double{area})));
        Eigen::AlignedBox2f box;
        for (const StrandProfile::Loop& loop : profile.boundaries) {
            for (const Vec2& point : loop)
                box.extend(point);
        }
        QVERIFY(box.center().norm() < 0.35F);
    }
}

void StrandProfileTest::fault_saysWhatIsWrong_data()
{
    QTest::addColumn<StrandProfile>("profile");
    QTest::addColumn<QString>("fault");
    const StrandProfile square = rectangle(2.0F, 2.0F);
    const auto row = [](const char* name, const StrandProfile& profile, const QString& fault) {
        QTest::newRow(name) << profile << fault;
    };
    row("none", square, {});
    row("empty", {}, QStringLiteral("it has no outline"));
    row("two points", polygon({{0.0F, 0.0F}, {1.0F, 0.0F}}),
        QStringLiteral("an outline needs at least three points"));
    row("second outline of two points", {{square.boundaries[0], {{0.0F, 0.0F}, {1.0F, 0.0F}}}, {}},
        QStringLiteral("an outline needs at least three points"));
    row("crosses itself", polygon({{0.0F, 0.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}}),
        QStringLiteral("its outline crosses itself"));
    row("touches itself", polygon({{0.0F, 0.0F}, {2.0F, 0.0F}, {2.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}}),
        QStringLiteral("its outline crosses itself"));
    row("point twice", polygon({{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}}),
        QStringLiteral("its outline crosses itself"));
    row("on a line", polygon({{0.0F, 0.0F}, {1.0F, 0.0F}, {2.0F, 0.0F}}),
        QStringLiteral("its outline has no area"));
    row("outlines cross", {{square.boundaries[0], rectangle(2.0F, 2.0F, Vec2(1.0F, 1.0F)).boundaries[0]}, {}},
        QStringLiteral("its outlines cross each other"));
    row("same outline twice", {{square.boundaries[0], square.boundaries[0]}, {}},
        QStringLiteral("its outlines cross each other"));
    row("cavity", {{square.boundaries[0], rectangle(1.0F, 1.0F).boundaries[0]}, {}}, {});
    row("split", {{square.boundaries[0], rectangle(2.0F, 2.0F, Vec2(3.0F, 0.0F)).boundaries[0]}, {}}, {});
    row("tiny", scaled(square, 0.004F), QStringLiteral("its outline has no area"));
    row("small", scaled(square, 0.006F), {});
    row("huge", scaled(square, 100.0F), {});
    row("too huge", scaled(square, 101.0F), QStringLiteral("an outline reaches too far"));
    row("not a number", polygon({{0.0F, 0.0F}, {1.0F, std::nanf("")}, {0.0F, 1.0F}}),
        QStringLiteral("an outline reaches too far"));
    StrandProfile attracted = square;
    attracted.attractors = {{Vec2(50.0F, 50.0F), Vec2(60.0F, 50.0F)}};
    row("attractor outside", attracted, {});
    attracted.attractors.push_back({Vec2(0.0F, 0.0F), Vec2(std::nanf(""), 0.0F)});
    row("attractor too far", attracted, QStringLiteral("an attractor lies too far away"));
    attracted.attractors.assign(kMostAttractors + 1, {});
    row("attractors", attracted, QStringLiteral("it has more than 64 attractors"));
    StrandProfile many;
    for (std::size_t i = 0; i <= kMostProfileLoops; ++i)
        many.boundaries.push_back(
            rectangle(0.5F, 0.5F, Vec2(static_cast<float>(i), 0.0F)).boundaries.front());
    row("outlines", many, QStringLiteral("it has more than 32 outlines or 2000 points"));
}

void StrandProfileTest::fault_saysWhatIsWrong()
{
    QFETCH(const StrandProfile, profile);
    QTEST(profileFault(profile), "fault");
}

void StrandProfileTest::area_leavesOutCavities()
{
    StrandProfile profile = rectangle(4.0F, 2.0F);
    QVERIFY(std::abs(areaOf(profile) - 8.0F) < 1e-5F);
    profile.boundaries.push_back(rectangle(1.0F, 1.0F).boundaries.front());
    QVERIFY(std::abs(areaOf(profile) - 7.0F) < 1e-5F);
    profile.boundaries.push_back(rectangle(0.5F, 0.5F).boundaries.front()); // An island in the cavity
    QVERIFY(std::abs(areaOf(profile) - 7.25F) < 1e-5F);
    std::ranges::reverse(profile.boundaries[1]);
    QVERIFY(std::abs(areaOf(profile) - 7.25F) < 1e-5F);
}

void StrandProfileTest::inside_followsTheEvenOddRule()
{
    const StrandProfile ring = profileOf(ProfileShape::Ring);
    QVERIFY(!isInside(ring, Vec2(0.0F, 0.0F)));
    QVERIFY(isInside(ring, Vec2(0.9F, 0.0F)));
    QVERIFY(!isInside(ring, Vec2(1.3F, 0.0F)));
    const StrandProfile parts = profileOf(ProfileShape::TwoParts);
    QVERIFY(isInside(parts, Vec2(0.85F, 0.0F)) && isInside(parts, Vec2(-0.85F, 0.0F)));
    QVERIFY(!isInside(parts, Vec2(0.0F, 0.0F)));
}

void StrandProfileTest::json_givesTheSameProfile()
{
    for (int i = 0; i < kProfileShapeCount; ++i) {
        StrandProfile profile = profileOf(static_cast<ProfileShape>(i));
        if (i % 2 == 1)
            profile.attractors = {{Vec2(0.1F, 1.0F / 3.0F), Vec2(-7e-7F, 2.0F)}};
        const Result<StrandProfile> read = readProfile(profileToJson(profile), QStringLiteral("profile"));
        QVERIFY(read);
        QVERIFY(*read == profile);
    }
}

void StrandProfileTest::json_ofAFaultyProfile_isRefused()
{
    const Result<StrandProfile> read =
        readProfile(profileToJson(polygon({{0.0F, 0.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}})),
                    QStringLiteral("here"));
    QVERIFY(!read);
    QVERIFY2(read.error().message.contains(QStringLiteral("its outline crosses itself")),
             qPrintable(read.error().message));
}

static const TestClass<StrandProfileTest> strandProfileTest;

} // namespace espalier::test

#include "StrandProfileTest.moc"
