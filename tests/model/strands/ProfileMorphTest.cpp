// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/ProfileMorph.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class ProfileMorphTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void blend_betweenAnyTwoShapes_hasNoFault();
    void blend_ofSquares_isTheSquareBetween();
    void blend_fromOnePartToTwo_divides();
    void blend_fromARingToADisc_closesTheCavity();
    void attractors_areBlended();
    void sketch_ofACircle_isACircleOfFewPoints();
    void sketch_withOpenEnds_isClosed();
    void sketch_ofAFigureOfEight_crossesItself();
    void sketch_ofTooLittle_isNothing();
};

void ProfileMorphTest::blend_betweenAnyTwoShapes_hasNoFault()
{
    for (int a = 0; a < kProfileShapeCount; ++a) {
        for (int b = 0; b < kProfileShapeCount; ++b) {
            const StrandProfile from = profileOf(static_cast<ProfileShape>(a));
            const StrandProfile to = scaled(profileOf(static_cast<ProfileShape>(b)), 1.3F);
            for (const float share : {0.0F, 0.2F, 0.5F, 0.7F, 1.0F}) {
                const StrandProfile blended = ProfileBlend(from, to).at(share);
                QCOMPARE(profileFault(blended), QString());
                QVERIFY(share != 0.0F || blended == from);
                QVERIFY(share != 1.0F || blended == to);
                const float area = areaOf(blended);
                QVERIFY2(area > 0.5F && area < 9.0F, qPrintable(QString::number(double{area})));
            }
        }
    }
}

void ProfileMorphTest::blend_ofSquares_isTheSquareBetween()
{
    const StrandProfile blended =
        ProfileBlend(rectangle(2.0F, 2.0F), rectangle(4.0F, 4.0F, Vec2(2.0F, 0.0F))).at(0.5F);
    QVERIFY(std::abs(areaOf(blended) - 9.0F) < 0.2F);
    for (const Vec2& point : blended.boundaries.front()) {
        const Vec2 fromMiddle = point - Vec2(1.0F, 0.0F);
        QVERIFY(std::abs(fromMiddle.cwiseAbs().maxCoeff() - 1.5F) < 0.05F);
    }
}

void ProfileMorphTest::blend_fromOnePartToTwo_divides()
{
    const StrandProfile from = profileOf(ProfileShape::Elongated);
    const StrandProfile to = profileOf(ProfileShape::TwoParts);
    QCOMPARE(ProfileBlend(from, to).at(0.1F).boundaries.size(), 1U);
    QCOMPARE(ProfileBlend(from, to).at(0.9F).boundaries.size(), 2U);
}

void ProfileMorphTest::blend_fromARingToADisc_closesTheCavity()
{
    const StrandProfile ring = profileOf(ProfileShape::Ring);
    const StrandProfile disc = profileOf(ProfileShape::Round);
    const StrandProfile early = ProfileBlend(ring, disc).at(0.1F);
    QCOMPARE(early.boundaries.size(), 2U);
    QVERIFY(!isInside(early, Vec2::Zero()));
    QVERIFY(isInside(ProfileBlend(ring, disc).at(0.9F), Vec2::Zero()));
}

void ProfileMorphTest::attractors_areBlended()
{
    StrandProfile from = rectangle(2.0F, 2.0F);
    StrandProfile to = from;
    from.attractors = {{Vec2(0.0F, 0.0F), Vec2(1.0F, 0.0F)}};
    to.attractors = {{Vec2(0.0F, 1.0F), Vec2(1.0F, 1.0F)}, {Vec2(5.0F, 5.0F), Vec2(6.0F, 5.0F)}};
    const StrandProfile early = ProfileBlend(from, to).at(0.25F);
    QCOMPARE(early.attractors.size(), 1U);
    QVERIFY((early.attractors.front().from - Vec2(0.0F, 0.25F)).norm() < 1e-6F);
    QCOMPARE(ProfileBlend(from, to).at(0.75F).attractors.size(), 2U);
}

namespace {

std::vector<Vec2> arc(float from, float to, int count, float wobble = 0.0F)
{
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const float angle = from + (to - from) * static_cast<float>(i) / static_cast<float>(count - 1);
        const float radius = 1.0F + wobble * static_cast<float>(i % 2);
        points.push_back(radius * Vec2(std::cos(angle), std::sin(angle)));
    }
    return points;
}

} // namespace

void ProfileMorphTest::sketch_ofACircle_isACircleOfFewPoints()
{
    const StrandProfile::Loop loop = sketchedLoop(arc(0.0F, 6.2F, 400, 0.02F), 0.1F);
    QVERIFY2(loop.size() >= 12 && loop.size() <= 64, qPrintable(QString::number(loop.size())));
    QCOMPARE(profileFault({{loop}, {}}), QString());
    QVERIFY(std::abs(std::abs(signedAreaOf(loop)) - 3.2F) < 0.2F);
    for (const Vec2& point : loop)
        QVERIFY(std::abs(point.norm() - 1.01F) < 0.05F);
}

void ProfileMorphTest::sketch_withOpenEnds_isClosed()
{
    const StrandProfile::Loop loop = sketchedLoop(arc(0.0F, 4.5F, 200), 0.1F);
    QCOMPARE(profileFault({{loop}, {}}), QString());
    // Ends that cross a little are cut off.
    QCOMPARE(profileFault({{sketchedLoop(arc(0.0F, 6.5F, 200, 0.0F), 0.1F)}, {}}), QString());
}

void ProfileMorphTest::sketch_ofAFigureOfEight_crossesItself()
{
    std::vector<Vec2> eight;
    for (int i = 0; i < 200; ++i) {
        const float angle = 0.0314F * static_cast<float>(i);
        eight.emplace_back(std::cos(angle), std::sin(2.0F * angle));
    }
    QCOMPARE(profileFault({{sketchedLoop(eight, 0.1F)}, {}}), QStringLiteral("its outline crosses itself"));
}

void ProfileMorphTest::sketch_ofTooLittle_isNothing()
{
    QVERIFY(sketchedLoop({}, 0.1F).empty());
    QVERIFY(sketchedLoop(std::vector<Vec2>(50, Vec2(1.0F, 1.0F)), 0.1F).empty());
    QVERIFY(sketchedLoop(std::vector<Vec2>{{0.0F, 0.0F}, {0.02F, 0.0F}, {0.02F, 0.02F}}, 0.1F).empty());
    QVERIFY(sketchedLoop(std::vector<Vec2>{{0.0F, 0.0F}, {1.0F, std::nanf("")}, {1.0F, 1.0F}}, 0.1F).empty());
}

static const TestClass<ProfileMorphTest> profileMorphTest;

} // namespace espalier::test

#include "ProfileMorphTest.moc"
