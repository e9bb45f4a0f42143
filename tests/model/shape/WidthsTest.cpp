// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/Widths.h"

#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <cmath>

namespace espalier::test {

class WidthsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void exponent_ofSixteenTwigsOnAFourfoldBase_isTwo();
    void exponent_ofEqualTips_hasTheKnownValues();
    void exponent_solvesItsEquation();
    void exponent_withoutASolution_isTheFallback();
    void exponent_isKeptWithinItsLimits();
    void radii_keepDaVincisRuleAtEveryFork();
    void base_hasTheDiameterAskedFor();
    void base_ofASingleStem_hasTheDiameterAskedForAndTapersByLength();
    void base_ofAFewTips_hasTheDiameterAskedFor();
    void seedling_ofAThickTree_isNoDisc();
    void parent_isNeverThinnerThanAChild();
    void scale_ofTipAndBase_scalesAllRadii();
    void dead_haveNoWidth();
    void radii_onBothSidesOfTheTable_agree();
};

void WidthsTest::exponent_ofSixteenTwigsOnAFourfoldBase_isTwo()
{
    QVERIFY(std::abs(widthExponent(16, 1.0, 4.0, 9.0) - 2.0) < 1e-15);
}

void WidthsTest::exponent_ofEqualTips_hasTheKnownValues()
{
    QVERIFY(std::abs(widthExponent(2, 1.0, 3.0, 9.0) - 0.6309297536) < 1e-10);
    QVERIFY(std::abs(widthExponent(9, 0.001, 0.003, 9.0) - 2.0) < 1e-12);
}

void WidthsTest::exponent_solvesItsEquation()
{
    for (const std::uint32_t tips : {2U, 10U, 1000U, 1000000U}) {
        for (const double base : {2.0, 5.0, 40.0}) {
            const double n = widthExponent(tips, 1.0, base, 0.0);
            if (n > 0.5 && n < 10.0)
                QVERIFY(std::abs(std::pow(base, n) / tips - 1.0) < 1e-9);
        }
    }
}

void WidthsTest::exponent_withoutASolution_isTheFallback()
{
    QCOMPARE(widthExponent(1, 0.003, 0.1, 2.2), 2.2);
    QCOMPARE(widthExponent(0, 0.003, 0.1, 2.2), 2.2);
    QCOMPARE(widthExponent(10, 0.003, 0.0, 2.2), 2.2);
    QCOMPARE(widthExponent(10, 0.003, 0.003, 2.2), 2.2);
    QCOMPARE(widthExponent(10, 0.003, 0.001, 2.2), 2.2);
}

void WidthsTest::exponent_isKeptWithinItsLimits()
{
    QCOMPARE(widthExponent(2, 1.0, 1e9, 2.2), 0.5);
    QCOMPARE(widthExponent(1000000, 1.0, 1.001, 2.2), 10.0);
}

void WidthsTest::radii_keepDaVincisRuleAtEveryFork()
{
    for (const double exponent : {0.5, 1.7, 2.2, 3.0, 10.0}) {
        TreeParameters parameters;
        parameters.widths.exponent = exponent;
        const TreeBuilder builder = randomTree(2500, 1, parameters);
        const Widths widths(builder.tree, builder.index);
        QCOMPARE(widths.exponent(), exponent);
        for (InternodeId id = 0; id < builder.tree.size(); ++id) {
            double sum = 0.0;
            for (InternodeId child = builder.index.firstChild(id); child != kNoInternode;
                 child = builder.index.nextSibling(child))
                sum += std::pow(diameterOf(widths, builder.index, child), exponent);
            const double own = std::pow(diameterOf(widths, builder.index, id), exponent);
            if (builder.index.firstChild(id) == kNoInternode)
                QVERIFY(std::abs(diameterOf(widths, builder.index, id) - parameters.widths.tipDiameter) <
                        1e-9);
            else
                QVERIFY(std::abs(own - sum) <= 1e-5 * own); // of float radii
        }
    }
}

void WidthsTest::base_hasTheDiameterAskedFor()
{
    for (const double base : {0.03, 0.2, 1.0}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = base;
        const TreeBuilder builder = randomTree(2000, 2, parameters);
        const Widths widths(builder.tree, builder.index);
        QVERIFY(widths.exponent() > 0.5 && widths.exponent() < 10.0);
        QVERIFY(std::abs(diameterOf(widths, builder.index, 0) - base) < 1e-6 * base + 1e-9);
    }
}

void WidthsTest::base_ofASingleStem_hasTheDiameterAskedForAndTapersByLength()
{
    TreeParameters parameters;
    parameters.widths.baseDiameter = 0.12;
    parameters.widths.tipDiameter = 0.01;
    TreeBuilder builder(1, parameters);
    const InternodeId middle = builder.growAxis(0, kTerminalSlot, continuing(), 9, continuing(), 0.1F);
    const InternodeId tip = builder.growAxis(middle, kTerminalSlot, continuing(), 20, continuing(), 0.05F);
    const Widths widths(builder.tree, builder.index);
    QVERIFY(std::abs(diameterOf(widths, builder.index, 0) - 0.12) < 1e-6);
    QVERIFY(std::abs(diameterOf(widths, builder.index, tip) - 0.01) < 1e-6);
    // Half of the length lies on either side: the geometric mean.
    QVERIFY(std::abs(diameterOf(widths, builder.index, middle) - std::sqrt(0.12 * 0.01)) < 0.003);
    for (InternodeId id = 1; id < builder.tree.size(); ++id)
        QVERIFY(widths.radius(builder.index, id) < widths.radius(builder.index, id - 1));
}

void WidthsTest::base_ofAFewTips_hasTheDiameterAskedFor()
{
    // So few or so many tips that no exponent within the limits leads to the base diameter.
    for (const auto& [laterals, base] : {std::pair{1, 0.5}, std::pair{3, 0.5}, std::pair{30, 0.0055}}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = base;
        parameters.widths.tipDiameter = 0.005;
        TreeBuilder builder(1, parameters);
        InternodeId tip = 0;
        for (int i = 0; i < laterals; ++i) {
            tip = builder.grow({.parent = tip, .rotation = continuing()});
            builder.grow({.parent = tip, .slot = 0, .rotation = branching(0.8)});
        }
        builder.grow({.parent = tip, .rotation = continuing()});
        const Widths widths(builder.tree, builder.index);
        QVERIFY(std::abs(diameterOf(widths, builder.index, 0) - base) < 1e-5 * base);
    }
}

void WidthsTest::seedling_ofAThickTree_isNoDisc()
{
    TreeParameters parameters;
    parameters.widths.baseDiameter = 0.4;
    const TreeBuilder seedling(1, parameters);
    const Widths widths(seedling.tree, seedling.index);
    QVERIFY(diameterOf(widths, seedling.index, 0) <= static_cast<double>(seedling.tree.length(0)) / 2.0);
}

void WidthsTest::parent_isNeverThinnerThanAChild()
{
    const TreeBuilder builder = randomTree(2000, 3);
    const Widths widths(builder.tree, builder.index);
    for (InternodeId id = 1; id < builder.tree.size(); ++id)
        QVERIFY(widths.radius(builder.index, builder.tree.parent(id)) >= widths.radius(builder.index, id));
}

void WidthsTest::scale_ofTipAndBase_scalesAllRadii()
{
    const Widths widths(WidthParameters{2.0, 0.004, 0.3}, 1500);
    const Widths scaled(WidthParameters{2.0, 0.02, 1.5}, 1500);
    QVERIFY(std::abs(widths.exponent() - scaled.exponent()) < 1e-12);
    for (const std::uint32_t tips : {1U, 2U, 17U, 1023U, 1024U, 1500U})
        QVERIFY(std::abs(scaled.radiusOfTips(tips) / widths.radiusOfTips(tips) - 5.0F) < 1e-5F);
}

void WidthsTest::dead_haveNoWidth()
{
    TreeBuilder builder = randomTree(300, 4);
    const InternodeId branch = builder.tree.size() / 2;
    builder.apply(death(builder.tree, builder.index, branch));
    QCOMPARE(Widths(builder.tree, builder.index).radius(builder.index, branch), 0.0F);
}

void WidthsTest::radii_onBothSidesOfTheTable_agree()
{
    const Widths widths(WidthParameters{2.3, 0.003, 0.0}, 100000);
    float last = 0.0F;
    for (std::uint32_t tips = 1; tips < 5000; ++tips) {
        const float radius = widths.radiusOfTips(tips);
        QVERIFY(radius > last);
        QVERIFY(std::abs(static_cast<double>(radius) - 0.0015 * std::pow(tips, 1.0 / 2.3)) < 1e-8);
        last = radius;
    }
}

const TestClass<WidthsTest> widthsTest;

} // namespace espalier::test

#include "WidthsTest.moc"
