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
    void childLength_fallsTowardTheParentsTip();
    void drawnLengthShares_admitWhatWasDrawn();
};

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
