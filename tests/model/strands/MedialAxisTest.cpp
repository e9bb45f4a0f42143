// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/MedialAxis.h"

#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QElapsedTimer>
#include <QTest>

namespace espalier::test {

class MedialAxisTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void rectangle_hasASegmentAndFourDiagonals();
    void circle_hasADot();
    void cShape_hasAnArcInside();
    void ring_hasACircle();
    void axis_isInsideEveryProfileAndQuick_data();
    void axis_isInsideEveryProfileAndQuick();
};

namespace {

/// The distance of @p point from the nearest segment.
float distanceTo(const std::vector<MedialSegment>& axis, const Vec2& point)
{
    float nearest = std::numeric_limits<float>::max();
    for (const auto& [from, to] : axis) {
        const Vec2 edge = to - from;
        const float length = edge.squaredNorm();
        const float t = length > 0.0F ? std::clamp((point - from).dot(edge) / length, 0.0F, 1.0F) : 0.0F;
        nearest = std::min(nearest, (point - from - t * edge).norm());
    }
    return nearest;
}

} // namespace

void MedialAxisTest::rectangle_hasASegmentAndFourDiagonals()
{
    const std::vector<MedialSegment> axis = medialAxis(rectangle(4.0F, 1.0F));
    std::vector<MedialSegment> expected{{Vec2(-1.5F, 0.0F), Vec2(1.5F, 0.0F)}};
    for (const float x : {-1.0F, 1.0F}) {
        for (const float y : {-1.0F, 1.0F})
            expected.push_back({Vec2(1.5F * x, 0.0F), Vec2(1.92F * x, 0.42F * y)});
    }
    for (const auto& [from, to] : axis) {
        std::vector<MedialSegment> whole = expected;
        for (std::size_t i = 1; i < whole.size(); ++i)
            whole[i].to = Vec2(std::copysign(2.0F, whole[i].to.x()), std::copysign(0.5F, whole[i].to.y()));
        QVERIFY2(distanceTo(whole, (from + to) / 2.0F) < 0.03F,
                 qPrintable(QStringLiteral("%1 %2").arg(double{from.x()}).arg(double{from.y()})));
    }
    for (const auto& [from, to] : expected) {
        for (float t = 0.0F; t <= 1.0F; t += 0.1F)
            QVERIFY(distanceTo(axis, from + t * (to - from)) < 0.03F);
    }
}

void MedialAxisTest::circle_hasADot()
{
    const std::vector<MedialSegment> axis = medialAxis(profileOf(ProfileShape::Round));
    QVERIFY(!axis.empty());
    for (const auto& [from, to] : axis)
        QVERIFY(from.norm() < 0.05F && to.norm() < 0.05F);
}

void MedialAxisTest::cShape_hasAnArcInside()
{
    const StrandProfile profile = profileOf(ProfileShape::CShape);
    const std::vector<MedialSegment> axis = medialAxis(profile);
    for (const auto& [from, to] : axis) {
        for (float t = 0.0F; t <= 1.0F; t += 0.25F) {
            const Vec2 point = from + t * (to - from);
            QVERIFY(isInside(profile, point));
            QVERIFY(std::abs(point.norm() - 1.0F) < 0.06F); // The band's middle
        }
    }
    for (float angle = 0.9F; angle < 5.3F; angle += 0.1F)
        QVERIFY(distanceTo(axis, Vec2(std::cos(angle), std::sin(angle))) < 0.05F);
}

void MedialAxisTest::ring_hasACircle()
{
    const std::vector<MedialSegment> axis = medialAxis(profileOf(ProfileShape::Ring));
    for (float angle = 0.0F; angle < 6.2F; angle += 0.1F)
        QVERIFY(distanceTo(axis, 0.93F * Vec2(std::cos(angle), std::sin(angle))) < 0.03F);
}

void MedialAxisTest::axis_isInsideEveryProfileAndQuick_data()
{
    QTest::addColumn<StrandProfile>("profile");
    for (int i = 0; i < kProfileShapeCount; ++i)
        QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(i)))
            << profileOf(static_cast<ProfileShape>(i));
    QTest::newRow("triangle") << polygon({{0.0F, 0.0F}, {1.0F, 0.0F}, {0.0F, 1.0F}});
    QTest::newRow("thin C") << thinC(0.02F);
    QTest::newRow("tiny") << scaled(profileOf(ProfileShape::Fluted), 0.01F);
    QTest::newRow("far away") << rectangle(0.1F, 0.1F, Vec2(99.0F, -99.0F));
    QTest::newRow("slit") << rectangle(2e-6F, 200.0F);
    StrandProfile wavy;
    for (int i = 0; i < static_cast<int>(kMostProfilePoints); ++i) {
        const float angle = static_cast<float>(2.0 * std::numbers::pi * i / kMostProfilePoints);
        wavy.boundaries.resize(1);
        wavy.boundaries.front().push_back((1.0F + 0.3F * std::sin(25.0F * angle)) *
                                          Vec2(std::cos(angle), std::sin(angle)));
    }
    QTest::newRow("most points") << wavy;
    StrandProfile parts;
    for (int i = 0; i < static_cast<int>(kMostProfileLoops); ++i)
        parts.boundaries.push_back(
            rectangle(1.0F, 1.0F, Vec2(static_cast<float>(2 * (i % 8)), static_cast<float>(2 * (i / 8))))
                .boundaries.front());
    QTest::newRow("most outlines") << parts;
}

void MedialAxisTest::axis_isInsideEveryProfileAndQuick()
{
    QFETCH(const StrandProfile, profile);
    QCOMPARE(profileFault(profile), QString());
    QElapsedTimer timer;
    timer.start();
    const std::vector<MedialSegment> axis = medialAxis(profile);
    const double elapsed = static_cast<double>(timer.nsecsElapsed()) / 1e6;
    qInfo("%.2f ms, %zu segments", elapsed, axis.size());
    for (const auto& [from, to] : axis) {
        QVERIFY(isInside(profile, from));
        QVERIFY(isInside(profile, to));
        QVERIFY(isInside(profile, (from + to) / 2.0F));
    }
    // The machine may be busy: much less than that is usual.
    QVERIFY2(elapsed < 40.0, qPrintable(QString::number(elapsed)));
}

static const TestClass<MedialAxisTest> medialAxisTest;

} // namespace espalier::test

#include "MedialAxisTest.moc"
