// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/WidthRegions.h"

#include "model/shape/BranchBend.h"
#include "model/shape/Widths.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace espalier::test {

class WidthRegionsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void exponent_hasTheKnownValues();
    void exponent_solvesItsEquationWithinItsBracket();
    void exponentOutsideItsLimits_leavesAFactor();
    void singleExtremity_leavesAFactor();
    void withoutConstraints_radiiAreAsBefore();
    void radii_areAsByRecursionOverTips();
    void constrainedInternodes_haveTheirDiameters();
    void oneConstraint_changesItsRegionsAlone();
    void scale_ofAllDiameters_scalesAllRadii();
    void singleTwig_tapersFromItsConstraint();
    void pathBetweenConstraints_tapersByLength();
    void thickBranchOnAThinBase_blends();
    void veryThickBase_blends();
    void constraintOfNothing_isATwig();
    void deadConstraint_sleeps();
    void baseDiameter_holdsBelowConstraints();
    void hostileConstraints_giveFiniteRadii();
};

namespace {

using Constraints = std::vector<WidthConstraint>;

WidthLaw solve(double base, std::initializer_list<double> extremities)
{
    std::vector<WidthExtremities> all;
    for (const double d : extremities)
        all.push_back({1.0, std::log(d)});
    return solveWidths(std::log(base), all, 2.2);
}

/// The diameter of @p id for exponent @p n by da Vinci's rule, from each tip and constraint on.
double recursive(const TreeBuilder& builder, const Constraints& constraints, InternodeId base, InternodeId id,
                 double n)
{
    if (id != base) {
        const auto known = std::ranges::find(constraints, id, &WidthConstraint::id);
        if (known != constraints.end())
            return static_cast<double>(known->value);
    }
    const TreeIndex& index = builder.index;
    if (index.firstChild(id) == kNoInternode)
        return builder.tree.parameters().widths.tipDiameter;
    double sum = 0.0;
    for (InternodeId child = index.firstChild(id); child != kNoInternode; child = index.nextSibling(child))
        sum += std::pow(recursive(builder, constraints, base, child, n), n);
    return std::pow(sum, 1.0 / n);
}

/// The internodes above @p base up to the next constraints, these left out.
void collect(const TreeBuilder& builder, const Constraints& constraints, InternodeId id,
             std::vector<InternodeId>& found)
{
    found.push_back(id);
    for (InternodeId child = builder.index.firstChild(id); child != kNoInternode;
         child = builder.index.nextSibling(child)) {
        if (std::ranges::find(constraints, child, &WidthConstraint::id) == constraints.end())
            collect(builder, constraints, child, found);
    }
}

std::vector<InternodeId> regionOf(const TreeBuilder& builder, const Constraints& constraints,
                                  InternodeId base)
{
    std::vector<InternodeId> found;
    collect(builder, constraints, base, found);
    return found;
}

/// Up to @p count constraints on a tree, each @p least to @p most times as thick as it would be without.
Constraints randomConstraints(const TreeBuilder& builder, std::size_t count, double least, double most,
                              std::uint64_t seed)
{
    Random random(seed, 0, 0, Purpose::Direction);
    const Widths widths(builder.tree, builder.index);
    std::set<InternodeId> ids;
    for (std::size_t i = 0; i < 50 * count && ids.size() < count; ++i) {
        const auto id = static_cast<InternodeId>(random.bits() % builder.tree.size());
        if (builder.tree.isAlive(id) && builder.index.tipCount(id) > 4)
            ids.insert(id);
    }
    Constraints constraints;
    for (const InternodeId id : ids) {
        const double factor = random.uniform(least, most);
        constraints.push_back({id, static_cast<float>(factor * diameterOf(widths, builder.index, id))});
    }
    return constraints;
}

} // namespace

void WidthRegionsTest::exponent_hasTheKnownValues()
{
    const std::array<WidthExtremities, 1> twigs{{{16.0, std::log(1.0)}}};
    QVERIFY(std::abs(solveWidths(std::log(4.0), twigs, 9.0).exponent - 2.0) < 1e-14);
    QVERIFY(std::abs(solve(5.0, {3.0, 4.0}).exponent - 2.0) < 1e-12);
    QVERIFY(std::abs(solve(2.0, {1.9, 0.1}).exponent - 1.0) < 1e-12);
    QVERIFY(std::abs(solve(10.0, {1.0, 2.0, 3.0, 4.0, 5.0}).exponent - 1.3865140572) < 1e-10);
    QVERIFY(std::abs(solve(3.0, {1.0, 1.0}).exponent - 0.6309297536) < 1e-10);
    QVERIFY(std::abs(solve(1.001, {1.0, 0.5}).exponent - 7.1278884135) < 1e-9);
    for (const WidthLaw& law : {solve(5.0, {3.0, 4.0}), solve(1.001, {1.0, 0.5})})
        QCOMPARE(law.logFactor, 0.0);
}

void WidthRegionsTest::exponent_solvesItsEquationWithinItsBracket()
{
    Random random(1, 0, 0, Purpose::Direction);
    int solved = 0;
    for (int round = 0; round < 5000; ++round) {
        std::vector<WidthExtremities> extremities;
        double count = 0.0;
        double least = 0.0;
        double most = -100.0;
        for (std::uint64_t i = 0; i < 1 + round % 7U; ++i) {
            extremities.push_back(
                {std::floor(std::exp(random.uniform(0.0, 6.0))), random.uniform(-6.0, -0.001)});
            count += extremities.back().count;
            least = std::min(least, extremities.back().logDiameter);
            most = std::max(most, extremities.back().logDiameter);
        }
        const WidthLaw law = solveWidths(0.0, extremities, 2.2);
        QVERIFY(law.exponent >= 0.5 && law.exponent <= 10.0);
        // For any exponent, the factor leads to the base's diameter.
        QVERIFY(std::abs(logDiameter(law.exponent, extremities) + law.logFactor) < 1e-10);
        if (law.logFactor != 0.0 || count < 2.0)
            continue;
        ++solved;
        QVERIFY(law.exponent >= std::log(count) / -least - 1e-9);
        QVERIFY(law.exponent <= std::log(count) / -most + 1e-9);
    }
    QVERIFY(solved > 1000);
}

void WidthRegionsTest::exponentOutsideItsLimits_leavesAFactor()
{
    const WidthLaw thin = solve(1.0, {3.0, 4.0});
    QCOMPARE(thin.exponent, 10.0);
    QVERIFY(thin.logFactor < 0.0);
    QCOMPARE(solve(4.0, {3.0, 4.0}).exponent, 10.0);
    QCOMPARE(solve(4.00001, {3.99, 4.0}).exponent, 10.0);
    const WidthLaw thick = solve(100.0, {1.0, 1.0});
    QCOMPARE(thick.exponent, 0.5);
    QVERIFY(std::abs(thick.logFactor - std::log(25.0)) < 1e-12);
}

void WidthRegionsTest::singleExtremity_leavesAFactor()
{
    QVERIFY(std::abs(solve(6.0, {3.0}).logFactor - std::log(2.0)) < 1e-12);
    QVERIFY(std::abs(solve(3.0, {3.0}).logFactor) < 1e-12);
    QCOMPARE(solveWidths({}, {}, 2.2).exponent, 2.2);
}

void WidthRegionsTest::withoutConstraints_radiiAreAsBefore()
{
    for (const double base : {0.0, 0.2}) {
        TreeParameters parameters;
        parameters.widths.baseDiameter = base;
        const TreeBuilder builder = randomTree(1500, 1, parameters);
        const Widths plain(parameters.widths, builder.index.tipCount(0));
        const Widths widths(builder.tree, builder.index, {});
        for (InternodeId id = 0; id < builder.tree.size(); ++id)
            QCOMPARE(widths.radius(builder.index, id), plain.radiusOfTips(builder.index.tipCount(id)));
    }
}

void WidthRegionsTest::radii_areAsByRecursionOverTips()
{
    int solved = 0;
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        TreeBuilder builder = randomTree(700, seed);
        builder.apply(death(builder.tree, builder.index, builder.tree.size() * 2 / 3));
        const Constraints constraints = randomConstraints(builder, seed, 0.8, 1.6, seed);
        const Widths widths(builder.tree, builder.index, constraints);
        for (const WidthConstraint& constraint : constraints) {
            const auto wanted = static_cast<double>(constraint.value);
            double low = 0.5;
            double high = 10.0;
            const auto at = [&](double n) {
                return recursive(builder, constraints, constraint.id, constraint.id, n);
            };
            if (at(low) < wanted || at(high) > wanted)
                continue; // blended
            ++solved;
            for (int i = 0; i < 60; ++i)
                (at(0.5 * (low + high)) > wanted ? low : high) = 0.5 * (low + high);
            for (const InternodeId id : regionOf(builder, constraints, constraint.id)) {
                const double expected = recursive(builder, constraints, constraint.id, id, low);
                QVERIFY(std::abs(diameterOf(widths, builder.index, id) / expected - 1.0) < 2e-6);
                const InternodeId parent = builder.tree.parent(id);
                if (id != constraint.id)
                    QVERIFY(widths.radius(builder.index, parent) >= widths.radius(builder.index, id));
            }
        }
        // Below all constraints the exponent is the parameter.
        const double n = builder.tree.parameters().widths.exponent;
        if (constraints.front().id != 0) {
            for (const InternodeId id : regionOf(builder, constraints, 0)) {
                const double expected = recursive(builder, constraints, 0, id, n);
                QVERIFY(std::abs(diameterOf(widths, builder.index, id) / expected - 1.0) < 2e-6);
            }
        }
        for (InternodeId id = 0; id < builder.tree.size(); ++id)
            QCOMPARE(widths.radius(builder.index, id) > 0.0F, builder.tree.isAlive(id));
    }
    QVERIFY(solved > 30);
}

void WidthRegionsTest::constrainedInternodes_haveTheirDiameters()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const TreeBuilder builder = randomTree(800, seed);
        const Constraints constraints = randomConstraints(builder, 12, 0.1, 10.0, seed);
        const Widths widths(builder.tree, builder.index, constraints);
        for (const WidthConstraint& constraint : constraints) {
            const auto wanted = static_cast<double>(constraint.value);
            QVERIFY(std::abs(diameterOf(widths, builder.index, constraint.id) - wanted) <= 1e-6 * wanted);
        }
    }
}

void WidthRegionsTest::oneConstraint_changesItsRegionsAlone()
{
    const TreeBuilder builder = randomTree(1200, 3);
    Constraints constraints = randomConstraints(builder, 6, 1.0, 1.5, 3);
    const Widths before(builder.tree, builder.index, constraints);
    const std::size_t changed = 3;
    constraints[changed].value *= 1.3F;
    const Widths after(builder.tree, builder.index, constraints);

    InternodeId below = builder.tree.parent(constraints[changed].id);
    while (below != 0 && std::ranges::find(constraints, below, &WidthConstraint::id) == constraints.end())
        below = builder.tree.parent(below);
    std::set<InternodeId> mayChange;
    for (const InternodeId base : {constraints[changed].id, below}) {
        for (const InternodeId id : regionOf(builder, constraints, base))
            mayChange.insert(id);
    }
    bool anyChanged = false;
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        const bool differs = before.radius(builder.index, id) != after.radius(builder.index, id);
        anyChanged = anyChanged || differs;
        QVERIFY(!differs || mayChange.contains(id));
    }
    QVERIFY(anyChanged);
}

void WidthRegionsTest::scale_ofAllDiameters_scalesAllRadii()
{
    TreeParameters parameters;
    const TreeBuilder one = randomTree(900, 4, parameters);
    parameters.widths.tipDiameter *= 4.0;
    const TreeBuilder other = randomTree(900, 4, parameters);
    Constraints constraints = randomConstraints(one, 8, 0.3, 4.0, 4);
    const Widths widths(one.tree, one.index, constraints);
    for (WidthConstraint& constraint : constraints)
        constraint.value *= 4.0F;
    const Widths scaled(other.tree, other.index, constraints);
    for (InternodeId id = 0; id < one.tree.size(); ++id)
        QVERIFY(std::abs(scaled.radius(other.index, id) / widths.radius(one.index, id) - 4.0F) < 1e-5F);
}

void WidthRegionsTest::singleTwig_tapersFromItsConstraint()
{
    TreeBuilder builder;
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 10);
    const Constraints constraints{{2, 0.192F}};
    const Widths widths(builder.tree, builder.index, constraints);
    const double tipDiameter = builder.tree.parameters().widths.tipDiameter;
    QVERIFY(std::abs(diameterOf(widths, builder.index, tip) - tipDiameter) < 1e-8);
    const double factor = std::pow(tipDiameter / 0.192, 1.0 / (tip - 2));
    for (InternodeId id = 3; id <= tip; ++id) {
        const double step = diameterOf(widths, builder.index, id) / diameterOf(widths, builder.index, id - 1);
        QVERIFY(std::abs(step - factor) < 1e-4);
    }
    // Below it, there is only one extremity.
    QVERIFY(std::abs(diameterOf(widths, builder.index, 0) - 0.192) < 1e-6);
}

void WidthRegionsTest::pathBetweenConstraints_tapersByLength()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 4);
    const InternodeId last = builder.growAxis(4, kTerminalSlot, continuing(), 4, continuing(), 0.3F);
    builder.growAxis(last, 0, branching(1.0), 3);
    builder.growAxis(last, kTerminalSlot, continuing(), 3);
    const Constraints constraints{{1, 0.4F}, {last, 0.1F}};
    const Widths widths(builder.tree, builder.index, constraints);
    const double length = 3 * 0.1 + 4 * 0.3;
    for (InternodeId id = 1; id <= last; ++id) {
        const double along = id <= 4 ? (id - 1) * 0.1 : 0.3 + (id - 4) * 0.3;
        const double expected = 0.4 * std::pow(0.25, along / length);
        QVERIFY(std::abs(diameterOf(widths, builder.index, id) / expected - 1.0) < 1e-5);
    }
}

void WidthRegionsTest::thickBranchOnAThinBase_blends()
{
    const TreeBuilder builder = randomTree(600, 5);
    // The thickest way up, as far as it carries many twigs.
    InternodeId end = builder.tree.size() - 1;
    while (builder.index.tipCount(end) < 20)
        end = builder.tree.parent(end);
    QVERIFY(end > 3);
    for (const float base : {0.001F, 0.02F, 0.3F}) {
        const Widths widths(builder.tree, builder.index, Constraints{{1, base}, {end, 0.3F}});
        QVERIFY(std::abs(widths.radius(builder.index, 1) - base / 2.0F) < 1e-6F);
        QVERIFY(std::abs(widths.radius(builder.index, end) - 0.15F) < 1e-6F);
        // The radius changes gradually; internodes are up to 2.4 times as long as others.
        const auto count = static_cast<float>(pathBetween(builder.tree, 1, end).size() - 1);
        const float most = 1.1F * std::pow(0.3F / base, 2.4F / count);
        float before = widths.radius(builder.index, end);
        for (InternodeId id = builder.tree.parent(end); id != 0; id = builder.tree.parent(id)) {
            const float radius = widths.radius(builder.index, id);
            QVERIFY(radius >= base / 2.0F * 0.99F && radius <= 0.16F);
            QVERIFY(radius < most * before && before < most * radius);
            before = radius;
        }
    }
}

void WidthRegionsTest::veryThickBase_blends()
{
    TreeBuilder builder;
    const InternodeId fork = builder.growAxis(0, kTerminalSlot, continuing(), 3);
    const InternodeId left = builder.growAxis(fork, 0, branching(0.5), 3);
    const InternodeId right = builder.growAxis(fork, kTerminalSlot, continuing(), 3);
    const Widths widths(builder.tree, builder.index, Constraints{{1, 5.0F}});
    QVERIFY(std::abs(diameterOf(widths, builder.index, 1) - 5.0) < 1e-5);
    const double tip = builder.tree.parameters().widths.tipDiameter;
    QVERIFY(std::abs(diameterOf(widths, builder.index, left) - tip) < 1e-8);
    QVERIFY(std::abs(diameterOf(widths, builder.index, right) - tip) < 1e-8);
}

void WidthRegionsTest::constraintOfNothing_isATwig()
{
    const TreeBuilder builder = randomTree(400, 6);
    const auto tip = static_cast<float>(builder.tree.parameters().widths.tipDiameter);
    const InternodeId id = builder.index.mainChild(builder.index.mainChild(0));
    for (const float nothing : {0.0F, -1.0F, std::numeric_limits<float>::quiet_NaN()}) {
        const Widths widths(builder.tree, builder.index, Constraints{{id, nothing}});
        QVERIFY(std::abs(widths.radius(builder.index, id) - tip / 2.0F) < 1e-8F);
    }
}

void WidthRegionsTest::deadConstraint_sleeps()
{
    TreeBuilder builder = randomTree(500, 7);
    InternodeId branch = builder.tree.size() / 2;
    while (builder.index.subtreeSize(branch) < 5)
        --branch;
    const Constraints constraints{{branch, 0.2F}, {builder.tree.size() + 9, 0.4F}};
    const Widths awake(builder.tree, builder.index, constraints);
    builder.apply(death(builder.tree, builder.index, branch));
    const Widths asleep(builder.tree, builder.index, constraints);
    const Widths plain(builder.tree, builder.index);
    for (InternodeId id = 0; id < builder.tree.size(); ++id)
        QCOMPARE(asleep.radius(builder.index, id), plain.radius(builder.index, id));
    builder.revert();
    const Widths again(builder.tree, builder.index, constraints);
    for (InternodeId id = 0; id < builder.tree.size(); ++id)
        QCOMPARE(again.radius(builder.index, id), awake.radius(builder.index, id));
    QVERIFY(std::abs(again.radius(builder.index, branch) - 0.1F) < 1e-7F);
}

void WidthRegionsTest::baseDiameter_holdsBelowConstraints()
{
    TreeParameters parameters;
    parameters.widths.baseDiameter = 0.25;
    const TreeBuilder builder = randomTree(1000, 8, parameters);
    Constraints constraints = randomConstraints(builder, 5, 1.0, 1.2, 8);
    std::erase_if(constraints, [](const WidthConstraint& constraint) { return constraint.id < 20; });
    const Widths widths(builder.tree, builder.index, constraints);
    QVERIFY(std::abs(diameterOf(widths, builder.index, 0) - 0.25) < 1e-6);
    constraints.insert(constraints.begin(), {0, 0.4F});
    const Widths held(builder.tree, builder.index, constraints);
    QVERIFY(std::abs(diameterOf(held, builder.index, 0) - 0.4) < 1e-6);
}

void WidthRegionsTest::hostileConstraints_giveFiniteRadii()
{
    const TreeBuilder builder = randomTree(500, 9);
    constexpr std::array<float, 8> kDiameters{0.0F,
                                              -1.0F,
                                              1e-38F,
                                              1e38F,
                                              1e-3F,
                                              100.0F,
                                              std::numeric_limits<float>::infinity(),
                                              std::numeric_limits<float>::quiet_NaN()};
    for (std::uint32_t shift = 0; shift < 8; ++shift) {
        Constraints constraints;
        for (InternodeId id = shift; id < builder.tree.size(); id += 1 + 2 * shift)
            constraints.push_back({id, kDiameters[(id + shift) % 8]});
        const Widths widths(builder.tree, builder.index, constraints);
        for (InternodeId id = 0; id < builder.tree.size(); ++id) {
            const float radius = widths.radius(builder.index, id);
            QVERIFY(std::isfinite(radius) && radius > 0.0F);
        }
    }
}

const TestClass<WidthRegionsTest> widthRegionsTest;

} // namespace espalier::test

#include "WidthRegionsTest.moc"
