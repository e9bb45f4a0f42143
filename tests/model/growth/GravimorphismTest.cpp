// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Gravimorphism.h"

#include "model/base/Random.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class GravimorphismTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void ellipse_hasTheKnownDistances_data();
    void ellipse_hasTheKnownDistances();
    void ellipse_isWhatARayMarchFinds();
    void ellipse_isSymmetricAndScales();
    void bias_hasTheKnownValues_data();
    void bias_hasTheKnownValues();
    void bias_isOneForAVerticalAxisWhateverTheEllipse();
    void bias_isTheDistanceForALevelAxis();
    void bias_doesNotDependOnRotationAboutTheVertical();
    void bias_isNeverNegative();
};

namespace {

/// A unit axis τ away from up and a unit bud χ around it, 50° off the axis, both turned by @p azimuth about
/// the vertical.
struct AxisWithBud {
    Vec3 heading;
    Vec3 bud;
};
AxisWithBud axisWithBud(double tau, double chi, double azimuth = 0.0)
{
    // H leans toward +X: then P = H × Y points to +Z and V = P × H is up within the plane of H and Y.
    const Eigen::Vector3d h(std::sin(tau), std::cos(tau), 0.0);
    const Eigen::Vector3d p(0.0, 0.0, 1.0);
    const Eigen::Vector3d v(-std::cos(tau), std::sin(tau), 0.0);
    const double psi = radians(50);
    const Eigen::Vector3d bud = std::cos(psi) * h + std::sin(psi) * (std::cos(chi) * v + std::sin(chi) * p);
    const Eigen::AngleAxisd turn(azimuth, Eigen::Vector3d::UnitY());
    return {(turn * h).cast<float>(), (turn * bud).cast<float>()};
}

GravimorphismEllipse randomEllipse(Random& random)
{
    const double vertical = random.uniform(0.05, 3.0);
    return {vertical, random.uniform(0.05, 3.0), random.uniform(-3.0, 3.0)};
}

} // namespace

void GravimorphismTest::ellipse_hasTheKnownDistances_data()
{
    QTest::addColumn<double>("vertical");
    QTest::addColumn<double>("parallel");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("chi");
    QTest::addColumn<double>("distance");
    const auto row = [](const char* name, double sv, double sp, double ev, double chi, double d) {
        QTest::newRow(name) << sv << sp << ev << chi << d;
    };
    row("neutral", 1, 1, 0, 77, 1);
    row("epitony, top", 1, 1, 0.8, 0, 1.8);
    row("epitony, side", 1, 1, 0.8, 90, 0.6);
    row("epitony, bottom", 1, 1, 0.8, 180, 0.2);
    row("epitony, oblique", 1, 1, 0.8, 45, 1.390307);
    row("hypotony, top", 1, 1, -0.8, 0, 0.2);
    row("hypotony, side", 1, 1, -0.8, 90, 0.6);
    row("hypotony, bottom", 1, 1, -0.8, 180, 1.8);
    row("amphitony, top", 0.4, 1.5, 0, 0, 0.4);
    row("amphitony, side", 0.4, 1.5, 0, 90, 1.5);
    row("amphitony, oblique", 0.4, 1.5, 0, 30, 0.456502);
    row("axis outside, top", 1, 1, 1.25, 0, 2);
    row("axis outside, oblique", 1, 1, 1.25, 50, 0.576498);
    row("axis outside, missed", 1, 1, 1.25, 60, 0);
    row("axis outside, bottom", 1, 1, 1.25, 180, 0);
}

void GravimorphismTest::ellipse_hasTheKnownDistances()
{
    QFETCH(double, vertical);
    QFETCH(double, parallel);
    QFETCH(double, offset);
    QFETCH(double, chi);
    QFETCH(double, distance);
    QVERIFY(std::abs(ellipseDistance({vertical, parallel, offset}, radians(chi)) - distance) < 1e-6);
}

void GravimorphismTest::ellipse_isWhatARayMarchFinds()
{
    Random random(1, 0, 0, Purpose::Direction);
    for (int i = 0; i < 300; ++i) {
        const GravimorphismEllipse e = randomEllipse(random);
        const double chi = random.uniform(0.0, 2.0 * std::numbers::pi);
        constexpr int steps = 20000;
        constexpr double farthest = 8.0;
        int inside = 0;
        for (int step = 0; step < steps; ++step) {
            const double t = farthest * (step + 0.5) / steps;
            const double v = (t * std::cos(chi) - e.offset) / e.vertical;
            const double p = t * std::sin(chi) / e.parallel;
            inside += v * v + p * p < 1.0 ? 1 : 0;
        }
        QVERIFY2(std::abs(ellipseDistance(e, chi) - farthest * inside / steps) < 2.0 * farthest / steps,
                 qPrintable(QStringLiteral("s_v %1, s_p %2, e_v %3, chi %4")
                                .arg(e.vertical)
                                .arg(e.parallel)
                                .arg(e.offset)
                                .arg(degrees(chi))));
    }
}

void GravimorphismTest::ellipse_isSymmetricAndScales()
{
    Random random(2, 0, 0, Purpose::Direction);
    for (int i = 0; i < 300; ++i) {
        const GravimorphismEllipse e = randomEllipse(random);
        const GravimorphismEllipse upsideDown{e.vertical, e.parallel, -e.offset};
        const GravimorphismEllipse scaled{2.0 * e.vertical, 2.0 * e.parallel, 2.0 * e.offset};
        const double chi = random.uniform(0.0, std::numbers::pi);
        const double d = ellipseDistance(e, chi);
        QVERIFY(std::abs(ellipseDistance(e, -chi) - d) < 1e-9);
        QVERIFY(std::abs(ellipseDistance(upsideDown, std::numbers::pi - chi) - d) < 1e-6);
        QVERIFY(std::abs(ellipseDistance(scaled, chi) - 2.0 * d) < 1e-9);
    }
}

void GravimorphismTest::bias_hasTheKnownValues_data()
{
    QTest::addColumn<double>("vertical");
    QTest::addColumn<double>("parallel");
    QTest::addColumn<double>("offset");
    QTest::addColumn<double>("chi");
    QTest::addColumn<double>("tau");
    QTest::addColumn<double>("bias");
    QTest::newRow("epitony") << 1.0 << 1.0 << 0.8 << 45.0 << 60.0 << 1.292730;
    QTest::newRow("amphitony") << 0.4 << 1.5 << 0.0 << 30.0 << 45.0 << 0.728251;
}

void GravimorphismTest::bias_hasTheKnownValues()
{
    QFETCH(double, vertical);
    QFETCH(double, parallel);
    QFETCH(double, offset);
    QFETCH(double, chi);
    QFETCH(double, tau);
    QFETCH(double, bias);
    const auto [heading, bud] = axisWithBud(radians(tau), radians(chi));
    QVERIFY(std::abs(gravimorphicBias({vertical, parallel, offset}, heading, bud) - bias) < 2e-6);
}

void GravimorphismTest::bias_isOneForAVerticalAxisWhateverTheEllipse()
{
    Random random(3, 0, 0, Purpose::Direction);
    for (int i = 0; i < 100; ++i) {
        const GravimorphismEllipse e = randomEllipse(random);
        const double chi = random.uniform(0.0, 2.0 * std::numbers::pi);
        for (const double vertical : {0.0, std::numbers::pi}) {
            const auto [heading, bud] = axisWithBud(vertical, chi);
            QVERIFY(std::abs(gravimorphicBias(e, heading, bud) - 1.0) < 1e-6);
        }
        // Near the vertical it comes near to 1 as sin²τ does to 0; d is at most 6.
        const auto [heading, bud] = axisWithBud(radians(1), chi);
        QVERIFY(std::abs(gravimorphicBias(e, heading, bud) - 1.0) < 6.0 * 3.1e-4);
    }
}

void GravimorphismTest::bias_isTheDistanceForALevelAxis()
{
    Random random(4, 0, 0, Purpose::Direction);
    for (int i = 0; i < 100; ++i) {
        const double vertical = random.uniform(0.2, 3.0);
        const GravimorphismEllipse e{vertical, random.uniform(0.2, 3.0),
                                     0.9 * vertical * random.uniform(-1.0, 1.0)};
        const double chi = random.uniform(0.0, std::numbers::pi);
        const auto [heading, bud] = axisWithBud(radians(90), chi);
        QVERIFY(std::abs(gravimorphicBias(e, heading, bud) - ellipseDistance(e, chi)) < 1e-4);
    }
}

void GravimorphismTest::bias_doesNotDependOnRotationAboutTheVertical()
{
    Random random(5, 0, 0, Purpose::Direction);
    for (int i = 0; i < 100; ++i) {
        const double vertical = random.uniform(0.2, 3.0);
        const GravimorphismEllipse e{vertical, random.uniform(0.2, 3.0),
                                     0.9 * vertical * random.uniform(-1.0, 1.0)};
        const double tau = random.uniform(0.0, std::numbers::pi);
        const double chi = random.uniform(0.0, 2.0 * std::numbers::pi);
        const auto [heading, bud] = axisWithBud(tau, chi);
        const auto [turnedHeading, turnedBud] = axisWithBud(tau, chi, random.uniform(0.0, 6.0));
        QVERIFY(std::abs(gravimorphicBias(e, heading, bud) - gravimorphicBias(e, turnedHeading, turnedBud)) <
                1e-4);
    }
}

void GravimorphismTest::bias_isNeverNegative()
{
    Random random(6, 0, 0, Purpose::Direction);
    for (int i = 0; i < 2000; ++i)
        QVERIFY(gravimorphicBias(randomEllipse(random), random.direction(), random.direction()) >= 0.0);
}

const TestClass<GravimorphismTest> gravimorphismTest;

} // namespace espalier::test

#include "GravimorphismTest.moc"
