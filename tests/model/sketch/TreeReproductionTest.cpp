// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/TreeReproduction.h"

#include "model/sketch/CrownHull.h"
#include "tests/model/sketch/BranchTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class TreeReproductionTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void topology_stays();
    void trunk_followsItsStroke();
    void limbs_touchTheHull();
    void tips_areInTheHull();
    void branches_keepTheirDirections();
    void ratioOfALimb_isThatOfAllItCarries();
    void limbOutside_isShort();
    void strokes_areMovedToTheTree();
    void azimuth_turnsTheDrawing();
    void emptyStrokes_areErrors();
};

namespace {

/// A leaning trunk and a broad crown around it, m.
const SketchLine kTrunk = bentLine({0.4, -0.2}, radians(80), 6.0, 0.5, 20);

SketchLine crownOutline()
{
    SketchLine outline;
    for (int i = 0; i < 40; ++i) {
        const double angle = radians(9.0 * i);
        outline.emplace_back(0.6 + 3.0 * std::cos(angle), 3.1 + 3.6 * std::sin(angle));
    }
    return outline;
}

/// The outline where the tree stands, as a hull.
CrownHull hullOf(const SketchLine& outline)
{
    SketchLine moved;
    for (const Eigen::Vector2d& point : outline)
        moved.emplace_back(point - kTrunk.front());
    return CrownHull(moved, 1.0);
}

constexpr double kHullSize = 7.2; ///< m

Reproduction reproduce(TreeBuilder& builder, const SketchLine& trunk, const SketchLine& outline)
{
    Result<Reproduction> result = reproduced(builder.tree, builder.index, trunk, outline);
    if (!result)
        qFatal("%s", qPrintable(result.error().message));
    if (const QString fault = deltaFault(builder, result->delta); !fault.isEmpty())
        qFatal("%s", qPrintable(fault));
    return *result;
}

Eigen::Vector3d tipOf(const TreeBuilder& builder, InternodeId branch)
{
    return builder.index.nodePosition(BranchAxis(builder.tree, builder.index, branch).internodes().back())
        .cast<double>();
}

Eigen::Vector3d baseOf(const TreeBuilder& builder, InternodeId branch)
{
    return builder.index.basePosition(builder.tree, branch).cast<double>();
}

/// How far a point is out of the hull, m; negative inside. For points between its bottom and top.
double beyondHull(const CrownHull& hull, const Eigen::Vector3d& point)
{
    const CrownHull::Circle circle = hull.circle(point.y());
    return std::hypot(point.x() - circle.middle, point.z()) - circle.radius;
}

/// Whether the hull's surface comes within @p distance of a point.
bool isOnHull(const CrownHull& hull, const Eigen::Vector3d& point, double distance)
{
    const Eigen::Vector3d middle(hull.circle(point.y()).middle, 0.5 * (hull.bottom() + hull.top()), 0.0);
    const Eigen::Vector3d out = (point - middle).normalized();
    return hull.contains(point - distance * out) && !hull.contains(point + distance * out);
}

/// Deeper in the hull than rounding.
bool isWellInside(const CrownHull& hull, const Eigen::Vector3d& point)
{
    return point.y() > hull.bottom() + 1e-4 && point.y() < hull.top() - 1e-4 &&
           beyondHull(hull, point) < -1e-4;
}

} // namespace

void TreeReproductionTest::topology_stays()
{
    for (TreeBuilder& builder : branchTrees()) {
        const Tree before = builder.tree;
        reproduce(builder, kTrunk, crownOutline());
        TreeContent expected = before.content();
        expected.internodes.rotation = builder.tree.columns().rotation;
        expected.internodes.length = builder.tree.columns().length;
        QVERIFY(expected == builder.tree.content());
        QVERIFY(!(before == builder.tree));
        for (InternodeId id = 0; id < before.size(); ++id) {
            if (!before.isAlive(id))
                QCOMPARE(builder.tree.length(id), before.length(id));
        }
    }
}

void TreeReproductionTest::trunk_followsItsStroke()
{
    for (TreeBuilder& builder : branchTrees()) {
        const BranchAxis before(builder.tree, builder.index, 0);
        std::vector<double> shares;
        for (std::size_t i = 0; i < before.internodes().size(); ++i)
            shares.push_back(before.distanceOf({.number = i, .along = 1.0F}) / before.length());
        SketchLine downward = kTrunk;
        std::ranges::reverse(downward);
        for (const SketchLine& stroke : {kTrunk, downward}) {
            reproduce(builder, stroke, crownOutline());
            for (std::size_t i = 0; i < shares.size(); ++i) {
                const Eigen::Vector2d wanted = pointAlong(kTrunk, shares[i]) - kTrunk.front();
                const Vec3 node = builder.index.nodePosition(before.internodes()[i]);
                QVERIFY((node.cast<double>() - Eigen::Vector3d(wanted.x(), wanted.y(), 0.0)).norm() < 1e-4);
            }
            builder.revert();
        }
    }
}

void TreeReproductionTest::limbs_touchTheHull()
{
    const CrownHull hull = hullOf(crownOutline());
    int touching = 0;
    for (TreeBuilder& builder : branchTrees()) {
        const Reproduction result = reproduce(builder, kTrunk, crownOutline());
        for (const ChildBranch& limb : childrenOf(builder, 0)) {
            if (!isWellInside(hull, baseOf(builder, limb.id)))
                continue;
            QVERIFY(isOnHull(hull, tipOf(builder, limb.id), 0.01 * kHullSize));
            ++touching;
        }
    }
    QVERIFY(touching > 40);
}

void TreeReproductionTest::tips_areInTheHull()
{
    const CrownHull hull = hullOf(crownOutline());
    for (TreeBuilder& builder : branchTrees()) {
        const Reproduction result = reproduce(builder, kTrunk, crownOutline());
        std::uint32_t outside = 0;
        for (const InternodeId branch : branchesOf(builder)) {
            const Eigen::Vector3d base = baseOf(builder, branch);
            outside += hull.contains(base) ? 0U : 1U;
            if (!isWellInside(hull, base))
                continue;
            const Eigen::Vector3d tip = tipOf(builder, branch);
            QVERIFY(tip.y() > hull.bottom() - 1e-3 && tip.y() < hull.top() + 1e-3);
            QVERIFY(beyondHull(hull, tip) < 1e-3);
        }
        // Bases on the hull itself may count or not.
        QVERIFY(std::abs(static_cast<int>(outside) - static_cast<int>(result.outside)) <= 3);
        QVERIFY(4 * result.outside < branchesOf(builder).size());
    }
}

void TreeReproductionTest::branches_keepTheirDirections()
{
    for (TreeBuilder& builder : branchTrees()) {
        const std::vector<InternodeId> branches = branchesOf(builder);
        const auto directionsOn = [&](InternodeId id) {
            std::vector<std::pair<InternodeId, Eigen::Vector3d>> directions;
            for (const ChildBranch& child : childrenOf(builder, id))
                directions.emplace_back(child.id, child.heading);
            std::ranges::sort(directions, {}, &std::pair<InternodeId, Eigen::Vector3d>::first);
            return directions;
        };
        std::vector<InternodeId> axes{0};
        axes.insert(axes.end(), branches.begin(), branches.end());
        std::vector<std::vector<std::pair<InternodeId, Eigen::Vector3d>>> before;
        for (const InternodeId axis : axes)
            before.push_back(directionsOn(axis));
        // The turtle of the trunk turns with its first internode.
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond::FromTwoVectors(builder.index.heading(0).cast<double>(), [&] {
                const double share =
                    builder.tree.length(0) / BranchAxis(builder.tree, builder.index, 0).length();
                const Eigen::Vector2d end = pointAlong(kTrunk, share) - kTrunk.front();
                return Eigen::Vector3d(end.x(), end.y(), 0.0);
            }());
        const Eigen::Quaterniond frame = turn * BranchAxis(builder.tree, builder.index, 0).frame(0);
        reproduce(builder, kTrunk, crownOutline());
        QVERIFY(BranchAxis(builder.tree, builder.index, 0).frame(0).angularDistance(frame) < 1e-3);
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const auto after = directionsOn(axes[i]);
            QCOMPARE(after.size(), before[i].size());
            for (std::size_t j = 0; j < after.size(); ++j) {
                QCOMPARE(after[j].first, before[i][j].first);
                QVERIFY((after[j].second - before[i][j].second).norm() < 1e-4);
            }
        }
    }
}

void TreeReproductionTest::ratioOfALimb_isThatOfAllItCarries()
{
    const CrownHull hull = hullOf(crownOutline());
    int scaled = 0;
    for (TreeBuilder& builder : branchTrees()) {
        const Tree before = builder.tree;
        reproduce(builder, kTrunk, crownOutline());
        for (const ChildBranch& limb : childrenOf(builder, 0)) {
            const float ratio = builder.tree.length(limb.id) / before.length(limb.id);
            for (const InternodeId id : internodesOf(builder, limb.id)) {
                const InternodeId branch = builder.index.axis(id);
                const float own = builder.tree.length(id) / before.length(id);
                QVERIFY(own <= 1.0001F * ratio);
                if (own < 0.9999F * ratio) {
                    // It was shortened: its tip is on the hull, or its base is outside.
                    QVERIFY(isOnHull(hull, tipOf(builder, branch), 1e-3) ||
                            !isWellInside(hull, baseOf(builder, branch)));
                } else {
                    ++scaled;
                }
            }
        }
    }
    QVERIFY(scaled > 300);
}

void TreeReproductionTest::limbOutside_isShort()
{
    TreeBuilder builder;
    builder.growAxis(0, kTerminalSlot, continuing(), 9);
    builder.growAxis(1, 0, branching(1.0), 4);
    const InternodeId low = builder.tree.size() - 4;
    builder.growAxis(7, 0, branching(1.0), 4);
    const InternodeId high = builder.tree.size() - 4;
    const SketchLine trunk{{0.0, 0.0}, {0.0, 4.0}};
    const SketchLine crown{{-1.0, 2.0}, {1.0, 2.0}, {1.0, 5.0}, {-1.0, 5.0}};
    const Reproduction result = reproduce(builder, trunk, crown);
    QCOMPARE(result.outside, 1U);
    QVERIFY(std::abs(BranchAxis(builder.tree, builder.index, low).length() - 0.4 * kShrunkLimb) < 1e-6);
    const Eigen::Vector3d tip = tipOf(builder, high);
    QVERIFY(std::abs(std::hypot(tip.x(), tip.z()) - 1.0) < 1e-4);
    QVERIFY(std::abs(tip.y() - (3.2 + 1.0 / std::tan(1.0))) < 1e-3);
}

void TreeReproductionTest::strokes_areMovedToTheTree()
{
    TreeBuilder raised = raisedTree(150, 3);
    TreeBuilder low = randomTree(150, 3);
    reproduce(raised, kTrunk, crownOutline());
    reproduce(low, kTrunk, crownOutline());
    for (InternodeId id = 0; id < low.tree.size(); ++id)
        QVERIFY((raised.index.nodePosition(id) - low.index.nodePosition(id) - 8.0F * up()).norm() < 1e-4F);
    // Other trees of the document stay.
    low.apply(rootBirth(low.tree, low.index, Vec3(2.0F, 0.0F, 0.0F)));
    const InternodeId root = low.tree.size() - 1;
    low.growAxis(root, 0, branching(1.0), 3);
    const Vec3 there = low.index.nodePosition(root + 3);
    reproduce(low, {{0.0, 0.0}, {0.0, 2.0}}, crownOutline());
    QCOMPARE(low.index.nodePosition(root + 3), there);
}

void TreeReproductionTest::azimuth_turnsTheDrawing()
{
    constexpr double kAzimuth = radians(70);
    const Eigen::Quaterniond toDrawing(Eigen::AngleAxisd(-kAzimuth, Eigen::Vector3d::UnitY()));
    const CrownHull hull = hullOf(crownOutline());
    int touching = 0;
    for (TreeBuilder& builder : branchTrees()) {
        const Result<Reproduction> result =
            reproduced(builder.tree, builder.index, kTrunk, crownOutline(), kAzimuth);
        QVERIFY(result);
        QCOMPARE(deltaFault(builder, result->delta), QString());
        // Seen from there, the trunk is as drawn, and limbs end at the hull.
        const Eigen::Vector3d tip = toDrawing * tipOf(builder, 0);
        const Eigen::Vector2d wanted = kTrunk.back() - kTrunk.front();
        QVERIFY((tip - Eigen::Vector3d(wanted.x(), wanted.y(), 0.0)).norm() < 1e-4);
        for (const ChildBranch& limb : childrenOf(builder, 0)) {
            if (!isWellInside(hull, toDrawing * baseOf(builder, limb.id)))
                continue;
            QVERIFY(isOnHull(hull, toDrawing * tipOf(builder, limb.id), 0.01 * kHullSize));
            ++touching;
        }
    }
    QVERIFY(touching > 40);
}

void TreeReproductionTest::emptyStrokes_areErrors()
{
    const TreeBuilder builder = randomTree(60);
    const auto fault = [&](const SketchLine& trunk, const SketchLine& outline) {
        const Result<Reproduction> result = reproduced(builder.tree, builder.index, trunk, outline);
        return result ? QString() : result.error().message;
    };
    const QString noTrunk = QStringLiteral("the new trunk has no length");
    const QString noCrown = QStringLiteral("the silhouette encloses nothing");
    QCOMPARE(fault({}, crownOutline()), noTrunk);
    QCOMPARE(fault({{1.0, 1.0}, {1.0, 1.0}}, crownOutline()), noTrunk);
    QCOMPARE(fault(kTrunk, {}), noCrown);
    QCOMPARE(fault(kTrunk, {{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}}), noCrown);
    QCOMPARE(fault(kTrunk, {{-1.0, 0.0}, {0.0, 1.0}, {1.0, 2.0}}), noCrown);
    QCOMPARE(fault({{0.0, 0.0}, {0.0, 90'000.0}}, crownOutline()),
             QStringLiteral("an internode would be longer than 1000 m or lie more than 10000 m away"));
}

static const TestClass<TreeReproductionTest> treeReproductionTest;

} // namespace espalier::test

#include "TreeReproductionTest.moc"
