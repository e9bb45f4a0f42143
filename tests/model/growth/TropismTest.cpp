// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Tropism.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class TropismTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void tropism_hasTheKnownVector();
    void tropism_liesInTheVerticalPlaneOfTheHeadingAtTheSetPointAngle();
    void tropism_ofAVerticalHeadingUsesTheGivenDirection();
    void setPointAngle_isAFixedPoint();
    void heading_convergesToTheSetPointAngle();
    void rotationAboutTheVertical_turnsTheResultToo();
    void direction_isAUnitVectorInTheConeOfItsParts();
    void noFreeSpace_leavesTheOthersTheirProportion();
    void vanishingSum_keepsTheHeading();
};

namespace {

double angleToUp(const Vec3& direction)
{
    return std::acos(std::clamp(static_cast<double>(direction.normalized().y()), -1.0, 1.0));
}

} // namespace

void TropismTest::tropism_hasTheKnownVector()
{
    const Vec3 heading = Vec3::UnitX();
    const Vec3 tropism = tropismVector(heading, radians(30), Vec3::UnitZ());
    QVERIFY((tropism - Vec3(0.5F, 0.866025F, 0.0F)).norm() < 1e-6F);
    const Vec3 direction = growthDirection({0.5, 0.5, 0.0}, heading, tropism, Vec3::Zero());
    QVERIFY((direction - Vec3(0.866025F, 0.5F, 0.0F)).norm() < 1e-6F);
    QVERIFY(std::abs(angleToUp(direction) - radians(60)) < 1e-6);
}

void TropismTest::tropism_liesInTheVerticalPlaneOfTheHeadingAtTheSetPointAngle()
{
    Random random(1, 0, 0, Purpose::Direction);
    for (int i = 0; i < 500; ++i) {
        const Vec3 heading = random.direction();
        const double theta = random.uniform(0.0, std::numbers::pi);
        const Vec3 tropism = tropismVector(heading, theta, Vec3::UnitX());
        QVERIFY(std::abs(tropism.norm() - 1.0F) < 1e-5F);
        QVERIFY(std::abs(static_cast<double>(tropism.y()) - std::cos(theta)) < 1e-5);
        const Vec3 level(heading.x(), 0.0F, heading.z());
        QVERIFY(std::abs(tropism.dot(heading.cross(up()).normalized())) < 1e-4F); // coplanar
        QVERIFY(tropism.dot(level) >= -1e-5F);                                    // on the heading's side
    }
}

void TropismTest::tropism_ofAVerticalHeadingUsesTheGivenDirection()
{
    for (const Vec3& heading : {Vec3(up()), Vec3(-up())}) {
        const Vec3 tropism = tropismVector(heading, radians(90), Vec3::UnitZ());
        QVERIFY((tropism - Vec3(Vec3::UnitZ())).norm() < 1e-6F);
    }
}

void TropismTest::setPointAngle_isAFixedPoint()
{
    Random random(2, 0, 0, Purpose::Direction);
    for (int i = 0; i < 200; ++i) {
        const Vec3 heading = random.direction();
        if (std::abs(heading.y()) > 0.999F)
            continue;
        const Vec3 tropism = tropismVector(heading, angleToUp(heading), Vec3::UnitX());
        QVERIFY((tropism - heading).norm() < 1e-3F);
    }
}

void TropismTest::heading_convergesToTheSetPointAngle()
{
    // From 115° off the set point with α = 0.7 and β = 0.3: 115, 89, 66, 48, 34, 24, 17, 12°.
    const double theta = radians(40);
    Vec3 heading(static_cast<float>(std::sin(radians(155))), static_cast<float>(std::cos(radians(155))),
                 0.0F);
    double off = radians(115);
    for (const double expected : {89, 66, 48, 34, 24, 17, 12}) {
        heading = growthDirection({0.7, 0.3, 0.0}, heading, tropismVector(heading, theta, Vec3::UnitZ()),
                                  Vec3::Zero());
        const double now = angleToUp(heading) - theta;
        QVERIFY(std::abs(degrees(now) - expected) < 1.0);
        QVERIFY(std::abs(now - std::atan2(0.7 * std::sin(off), 0.3 + 0.7 * std::cos(off))) < 1e-5);
        QVERIFY(std::abs(heading.z()) < 1e-6F); // the azimuth stays
        off = now;
    }
}

void TropismTest::rotationAboutTheVertical_turnsTheResultToo()
{
    Random random(3, 0, 0, Purpose::Direction);
    for (int i = 0; i < 200; ++i) {
        const Vec3 heading = random.direction();
        const double theta = random.uniform(0.0, std::numbers::pi);
        const Rotation turn(Eigen::AngleAxisf(static_cast<float>(random.uniform(0.0, 6.0)), up()));
        const Vec3 level = Vec3::UnitX();
        QVERIFY(
            (turn * tropismVector(heading, theta, level) - tropismVector(turn * heading, theta, turn * level))
                .norm() < 1e-3F);
    }
}

void TropismTest::direction_isAUnitVectorInTheConeOfItsParts()
{
    Random random(4, 0, 0, Purpose::Direction);
    for (int i = 0; i < 500; ++i) {
        const Vec3 h = random.direction();
        const Vec3 t = random.direction();
        const Vec3 e = random.direction();
        const double a = random.uniform();
        const double b = random.uniform() * (1.0 - a);
        const Vec3 direction = growthDirection({a, b, 1.0 - a - b}, h, t, e);
        QVERIFY(std::abs(direction.norm() - 1.0F) < 1e-5F);
        Eigen::Matrix3d parts;
        parts << h.cast<double>(), t.cast<double>(), e.cast<double>();
        if (std::abs(parts.determinant()) < 0.05)
            continue;
        const Eigen::Vector3d coordinates = parts.inverse() * direction.cast<double>();
        QVERIFY(coordinates.minCoeff() >= -1e-4);
        // In the proportion of the weights.
        QVERIFY(std::abs(coordinates.x() * b - coordinates.y() * a) < 1e-3);
    }
}

void TropismTest::noFreeSpace_leavesTheOthersTheirProportion()
{
    const Vec3 h = Vec3::UnitX();
    const Vec3 t = Vec3::UnitY();
    QVERIFY((growthDirection({0.3, 0.2, 0.5}, h, t, Vec3::Zero()) -
             growthDirection({0.6, 0.4, 0.0}, h, t, Vec3::Zero()))
                .norm() < 1e-6F);
}

void TropismTest::vanishingSum_keepsTheHeading()
{
    const Vec3 heading = Vec3(1.0F, 2.0F, 3.0F).normalized();
    QCOMPARE(growthDirection({0.5, 0.5, 0.0}, heading, -heading, Vec3::Zero()), heading);
    QCOMPARE(growthDirection({0.0, 0.0, 1.0}, heading, up(), Vec3::Zero()), heading);
}

const TestClass<TropismTest> tropismTest;

} // namespace espalier::test

#include "TropismTest.moc"
