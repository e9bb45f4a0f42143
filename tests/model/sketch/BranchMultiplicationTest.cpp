// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchMultiplication.h"

#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <functional>
#include <optional>

namespace espalier::test {

class BranchMultiplicationTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void newBranch_fillsTheWidestGap();
    void newBranch_isLikeItsNeighbours();
    void newBranch_isFarthestFromTheOthers();
    void manyBranches_neverPointFarDown();
    void hangingBranch_getsBranchesThatRise();
    void oppositeBranches_getOneBetweenThem();
    void branchAlone_getsOneOnTheLongerSide();
    void seed_choosesTheShape();
    void nothingToImitate_isAnError();
};

namespace {

double lengthOfBranch(const TreeBuilder& builder, InternodeId id)
{
    return BranchAxis(builder.tree, builder.index, id).length();
}

double fromUp(const TreeBuilder& builder, InternodeId id)
{
    return std::acos(std::clamp(double{builder.index.heading(id).normalized().y()}, -1.0, 1.0));
}

double angleBetween(double a, double b)
{
    return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
}

/// The branch that multiplication adds, which it applies, and those that were there before.
struct Multiplied {
    std::vector<ChildBranch> before;
    ChildBranch added;
    double length; ///< Of the axis that carries them
};

Multiplied multiply(TreeBuilder& builder, InternodeId axis, std::uint64_t seed)
{
    const std::vector<ChildBranch> before = childrenOf(builder, axis);
    Result<TreeDelta> delta = multiplied(builder.tree, builder.index, axis, seed);
    if (!delta)
        qFatal("%s", qPrintable(delta.error().message));
    const InternodeId added = builder.tree.size();
    if (const QString fault = deltaFault(builder, std::move(*delta)); !fault.isEmpty())
        qFatal("%s", qPrintable(fault));
    const std::vector<ChildBranch> after = childrenOf(builder, axis);
    const auto found = std::ranges::find(after, added, &ChildBranch::id);
    if (found == after.end() || after.size() != before.size() + 1)
        qFatal("the axis of internode %u has not got one branch more", axis);
    return {before, *found, lengthOfBranch(builder, axis)};
}

/// The two branches beside the widest gap; nothing if all begin at the same place.
std::optional<std::pair<ChildBranch, ChildBranch>> neighboursOfGap(const Multiplied& m)
{
    std::optional<std::pair<ChildBranch, ChildBranch>> widest;
    double width = 1e-4 * m.length;
    for (std::size_t i = 1; i < m.before.size(); ++i) {
        if (m.before[i].distance - m.before[i - 1].distance > width) {
            width = m.before[i].distance - m.before[i - 1].distance;
            widest = {m.before[i - 1], m.before[i]};
        }
    }
    return widest;
}

/// Calls @p check for each axis of all trees that carries branches.
void forEachBearer(const std::function<void(TreeBuilder&, InternodeId)>& check)
{
    int count = 0;
    for (TreeBuilder& builder : branchTrees()) {
        std::vector<InternodeId> axes = branchesOf(builder);
        axes.push_back(0);
        for (const InternodeId axis : axes) {
            if (childrenOf(builder, axis).empty())
                continue;
            check(builder, axis);
            builder.revert();
            ++count;
        }
    }
    QVERIFY(count > 60);
}

} // namespace

void BranchMultiplicationTest::newBranch_fillsTheWidestGap()
{
    int between = 0;
    forEachBearer([&](TreeBuilder& builder, InternodeId axis) {
        const Multiplied m = multiply(builder, axis, 3);
        if (const auto gap = neighboursOfGap(m)) {
            ++between;
            QVERIFY(gap->first.distance < m.added.distance);
            QVERIFY(m.added.distance < gap->second.distance);
            QVERIFY(std::abs(m.added.distance - 0.5 * (gap->first.distance + gap->second.distance)) <
                    1e-5 * m.length);
        } else {
            const double toBase = m.before.front().distance;
            const double toTip = m.length - m.before.back().distance;
            const double expected = toBase > toTip ? 0.5 * toBase : m.length - 0.5 * toTip;
            QVERIFY(std::abs(m.added.distance - expected) < 1e-5 * m.length);
        }
    });
    QVERIFY(between > 20);
}

void BranchMultiplicationTest::newBranch_isLikeItsNeighbours()
{
    forEachBearer([](TreeBuilder& builder, InternodeId axis) {
        const Multiplied m = multiply(builder, axis, 5);
        const auto gap = neighboursOfGap(m);
        const ChildBranch& below = gap ? gap->first : m.before.front();
        const ChildBranch& above = gap ? gap->second : m.before.back();
        const double length = 0.5 * (lengthOfBranch(builder, below.id) + lengthOfBranch(builder, above.id));
        QVERIFY(std::abs(lengthOfBranch(builder, m.added.id) - length) < 1e-5 * length);
        // The down angle is the mean, unless only a greater one is allowed.
        const double down = 0.5 * (below.downAngle() + above.downAngle());
        QVERIFY(m.added.downAngle() > down - 1e-3);
        if (m.added.downAngle() > down + 1e-3)
            QVERIFY(std::abs(fromUp(builder, m.added.id) - kMostFromUp) < 1e-3);
        // It is one of the others, scaled: as many internodes in the same order.
        const std::vector<InternodeId> added = internodesOf(builder, m.added.id);
        const bool isCopy = std::ranges::any_of(m.before, [&](const ChildBranch& other) {
            const std::vector<InternodeId> original = internodesOf(builder, other.id);
            const float scale = builder.tree.length(added[0]) / builder.tree.length(original[0]);
            return std::ranges::equal(added, original, [&](InternodeId a, InternodeId b) {
                return std::abs(builder.tree.length(a) - scale * builder.tree.length(b)) < 1e-5F;
            });
        });
        QVERIFY(isCopy);
    });
}

void BranchMultiplicationTest::newBranch_isFarthestFromTheOthers()
{
    forEachBearer([](TreeBuilder& builder, InternodeId axis) {
        const Multiplied m = multiply(builder, axis, 7);
        std::vector<double> others;
        for (const ChildBranch& child : m.before) {
            if (std::sin(child.downAngle()) > 1e-3)
                others.push_back(child.rotationAngle());
        }
        const auto nearest = [&](double angle) {
            double least = std::numbers::pi;
            for (const double other : others)
                least = std::min(least, angleBetween(angle, other));
            return least;
        };
        const BranchAxis line(builder.tree, builder.index, axis);
        const Eigen::Vector3d up =
            line.frame(m.added.place.number).conjugate() * Eigen::Vector3d(Eigen::Vector3d::UnitY());
        double best = 0.0;
        for (int i = 0; i < 3600; ++i) {
            const double angle = radians(0.1 * i);
            const double down = m.added.downAngle();
            const Eigen::Vector3d way(std::sin(down) * std::cos(angle), std::cos(down),
                                      std::sin(down) * std::sin(angle));
            if (way.dot(up) >= std::cos(kMostFromUp - radians(0.02)))
                best = std::max(best, nearest(angle));
        }
        QVERIFY(nearest(m.added.rotationAngle()) > best - radians(0.3));
    });
}

void BranchMultiplicationTest::manyBranches_neverPointFarDown()
{
    for (TreeBuilder& builder : branchTrees()) {
        const std::vector<InternodeId> axes = branchesOf(builder);
        const InternodeId axis = *std::ranges::max_element(
            axes, {}, [&](InternodeId id) { return childrenOf(builder, id).size(); });
        for (std::uint64_t click = 0; click < 25; ++click) {
            const Multiplied m = multiply(builder, axis, click);
            QVERIFY(fromUp(builder, m.added.id) <= kMostFromUp);
        }
    }
}

void BranchMultiplicationTest::hangingBranch_getsBranchesThatRise()
{
    for (const double lean : {0.0, 0.05, 0.4}) {
        TreeBuilder builder;
        builder.apply(bend(
            builder.tree, 0,
            Rotation(Eigen::AngleAxisf(3.1415927F - static_cast<float>(lean), Vec3(Vec3::UnitZ()))), 1.0F));
        builder.growAxis(0, kTerminalSlot, continuing(), 8);
        for (const InternodeId id : {2U, 5U})
            builder.growAxis(id, 0, branching(radians(30)), 3);
        for (std::uint64_t click = 0; click < 6; ++click) {
            const Multiplied m = multiply(builder, 0, click);
            QVERIFY(fromUp(builder, m.added.id) <= kMostFromUp);
            QVERIFY(m.added.downAngle() > radians(30));
        }
    }
}

void BranchMultiplicationTest::oppositeBranches_getOneBetweenThem()
{
    TreeBuilder builder;
    const Rotation straight = Rotation::Identity();
    builder.growAxis(0, kTerminalSlot, straight, 9, straight);
    builder.growAxis(2, 0, branching(radians(60)), 2, straight);
    builder.growAxis(6, 0, continuing(radians(40), std::numbers::pi, 0.0), 4, straight);
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
        const Multiplied m = multiply(builder, 4, seed);
        QVERIFY(std::abs(m.added.downAngle() - radians(50)) < 1e-5);
        QVERIFY(std::abs(std::abs(m.added.heading.normalized().z()) - std::sin(radians(50))) < 1e-5);
        QVERIFY(std::abs(lengthOfBranch(builder, m.added.id) - 0.3) < 1e-6);
        QVERIFY(std::abs(m.added.distance - 0.5) < 1e-6);
        builder.revert();
    }
}

void BranchMultiplicationTest::branchAlone_getsOneOnTheLongerSide()
{
    TreeBuilder builder;
    const Rotation straight = Rotation::Identity();
    builder.growAxis(0, kTerminalSlot, straight, 9, straight);
    builder.growAxis(2, 0, branching(radians(60)), 2, straight);
    const Multiplied m = multiply(builder, 0, 1);
    QVERIFY(std::abs(m.added.distance - 0.65) < 1e-6); // Between 0.3 and 1.0
    QVERIFY(std::abs(angleBetween(m.added.rotationAngle(), m.before[0].rotationAngle()) - std::numbers::pi) <
            1e-4);
    builder.revert();
    builder.revert();
    builder.growAxis(7, 0, branching(radians(60)), 2, straight);
    QVERIFY(std::abs(multiply(builder, 0, 1).added.distance - 0.4) < 1e-6);
}

void BranchMultiplicationTest::seed_choosesTheShape()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 9);
    for (const InternodeId id : {2U, 4U, 6U})
        builder.growAxis(id, 0, branching(1.0), id);
    std::vector<std::uint32_t> sizes;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Result<TreeDelta> one = multiplied(builder.tree, builder.index, 0, seed);
        const Result<TreeDelta> other = multiplied(builder.tree, builder.index, 3, seed);
        QVERIFY(one && other);
        QVERIFY(*one == *other);
        QCOMPARE(one->rows->internodes.rotation, other->rows->internodes.rotation);
        sizes.push_back(one->born.count);
    }
    for (const std::uint32_t size : {2U, 4U, 6U})
        QVERIFY(std::ranges::count(sizes, size) > 0);
}

void BranchMultiplicationTest::nothingToImitate_isAnError()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 4);
    builder.growAxis(1, 0, branching(1.0), 2);
    const InternodeId twig = builder.tree.size() - 1;
    QCOMPARE(messageOf(multiplied(builder.tree, builder.index, twig, 1)),
             QStringLiteral("the branch of internode %1 carries no branch to imitate").arg(twig));
    QCOMPARE(messageOf(multiplied(builder.tree, builder.index, 99, 1)),
             QStringLiteral("internode 99 is not alive"));
    builder.apply(death(builder.tree, builder.index, twig - 1));
    QCOMPARE(messageOf(multiplied(builder.tree, builder.index, twig, 1)),
             QStringLiteral("internode %1 is not alive").arg(twig));
    QCOMPARE(messageOf(multiplied(builder.tree, builder.index, 0, 1)),
             QStringLiteral("the branch of internode 0 carries no branch to imitate"));
}

static const TestClass<BranchMultiplicationTest> branchMultiplicationTest;

} // namespace espalier::test

#include "BranchMultiplicationTest.moc"
