// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/WeberPenn.h"

#include "tests/support/TestClasses.h"

#include <QTest>

#include <cmath>
#include <vector>

namespace espalier::test {

class WeberPennTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void shapeRatio_hasItsKnownAnswers();
    void shapeRatio_isBoundedAndContinuous();
    void childLength_fallsTowardTheParentsTip();
    void drawnLengthShares_admitWhatWasDrawn();
};

void WeberPennTest::shapeRatio_hasItsKnownAnswers()
{
    const auto isNear = [](double value, double expected) { return std::abs(value - expected) < 1e-12; };
    QVERIFY(isNear(shapeRatio(CrownShape::TendFlame, 0.35), 0.75));
    QVERIFY(isNear(shapeRatio(CrownShape::TendFlame, 0.85), 0.75));
    QVERIFY(isNear(shapeRatio(CrownShape::Flame, 0.35), 0.5));
    QVERIFY(isNear(shapeRatio(CrownShape::Flame, 0.85), 0.5));
    QVERIFY(isNear(shapeRatio(CrownShape::Conical, 0.25), 0.4));
    QVERIFY(isNear(shapeRatio(CrownShape::Spherical, 0.5), 1.0));
    QVERIFY(isNear(shapeRatio(CrownShape::Spherical, 1.0), 0.2));
    QVERIFY(isNear(shapeRatio(CrownShape::Hemispherical, 1.0), 1.0));
    QVERIFY(isNear(shapeRatio(CrownShape::Cylindrical, 0.3), 1.0));
    QVERIFY(isNear(shapeRatio(CrownShape::TaperedCylindrical, 0.5), 0.75));
    QVERIFY(isNear(shapeRatio(CrownShape::InverseConical, 1.0), 0.2));
}

void WeberPennTest::shapeRatio_isBoundedAndContinuous()
{
    for (int shape = 0; shape <= static_cast<int>(CrownShape::TendFlame); ++shape) {
        double before = shapeRatio(static_cast<CrownShape>(shape), 0.0);
        for (int i = -10; i <= 1010; ++i) {
            const double ratio = shapeRatio(static_cast<CrownShape>(shape), i / 1000.0);
            QVERIFY(ratio >= 0.0 && ratio <= 1.0);
            QVERIFY(std::abs(ratio - before) < 0.005);
            before = ratio;
        }
    }
}

void WeberPennTest::childLength_fallsTowardTheParentsTip()
{
    QVERIFY(std::abs(childLength(0.5, 4.0, 0.0) - 2.0) < 1e-12);
    QVERIFY(std::abs(childLength(0.5, 4.0, 4.0) - 0.8) < 1e-12);
    QVERIFY(childLength(0.5, 4.0, 1.0) > childLength(0.5, 4.0, 2.0));
}

void WeberPennTest::drawnLengthShares_admitWhatWasDrawn()
{
    const std::vector<BranchLength> branches{
        {.order = 1, .length = 2.0, .parentLength = 5.0, .offset = 1.0},
        {.order = 2, .length = 1.0, .parentLength = 2.0, .offset = 1.0},
        {.order = 2, .length = 0.5, .parentLength = 2.0, .offset = 0.5},
        {.order = 4, .length = 0.5, .parentLength = 0.0, .offset = 0.0},
    };
    const std::vector<double> shares = drawnLengthShares(branches);
    QCOMPARE(shares.size(), std::size_t{5});
    QVERIFY(std::abs(shares[2] - 1.0 / 1.4) < 1e-12);
    QCOMPARE(shares[0], 0.0);
    QCOMPARE(shares[3], 0.0);
    QCOMPARE(shares[4], 0.0);
    for (const BranchLength& branch : branches) {
        const double share = shares[static_cast<std::size_t>(branch.order)];
        if (branch.parentLength > 0.0)
            QVERIFY(branch.length <= childLength(share, branch.parentLength, branch.offset) + 1e-12);
    }
    QVERIFY(drawnLengthShares({}).empty());
}

const TestClass<WeberPennTest> weberPennTest;

} // namespace espalier::test

#include "WeberPennTest.moc"
