// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LeafPlacer.h"

#include "model/mesh/LeafCard.h"
#include "model/mesh/Tubes.h"
#include "model/mesh/WoodMesh.h"
#include "model/texture/Textures.h"
#include "tests/support/Growing.h"
#include "tests/support/Leaves.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

#include <tbb/global_control.h>

#include <cmath>

namespace espalier::test {

class LeafPlacerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void leaves_areOnYoungShootsAlone();
    void woodThatTheUserMadeThick_isBare();
    void leaves_followTheParametersInForce();
    void azimuth_turnsByThePhyllotaxis_data();
    void azimuth_turnsByThePhyllotaxis();
    void angle_isThatBetweenShootAndPetiole();
    void droop_turnsLeavesDown();
    void frames_areOrthonormal();
    void faces_lookUp();
    void sizes_varyAsMuchAsAsked();
    void needles_areAlongTheInternode();
    void spiral_goesOnAlongTheAxisWhateverTheShoot();
    void opposite_standsInTheGapsOfTheNodeBelow_data();
    void opposite_standsInTheGapsOfTheNodeBelow();
    void flat_liesLeftAndRightOfTheTwig();
    void flat_ofAnUprightShootKeepsItsPlane();
    void arrangement_isThatOfTheAxisWhereverATubeBegins();
    void foot_isOnTheBark_data();
    void foot_isOnTheBark();
    void foot_ofStrands_isOnTheirSurface_data();
    void foot_ofStrands_isOnTheirSurface();
    void turn_ofAStraightBranch_isThatOfTheArrangement_data();
    void turn_ofAStraightBranch_isThatOfTheArrangement();
    void turn_ofABentAxis_isNeverSudden_data();
    void turn_ofABentAxis_isNeverSudden();
    void leaves_dependOnSeedAndNodeAlone();
    void leaves_areTheSameOnOneThreadAndMany();
    void hue_shiftsFromGreenToRedWithWeakness();
    void hue_ofPlacedLeaves_followsVigour();
    void leaves_nearTheGround_turnUpward();
    void leaves_belowTheGround_areHidden();
};

namespace {

/// Parameters without randomness, droop or turning toward light.
TreeParameters exact()
{
    TreeParameters parameters;
    parameters.growth.irregularity = 0.0;
    parameters.leaves.droop = 0.0;
    parameters.leaves.upward = 0.0;
    parameters.leaves.sizeVariation = 0.0;
    parameters.leaves.hueVariation = 0.0;
    parameters.leaves.vigourHue = 0.0;
    return parameters;
}

Rotation rotationOf(const LeafInstance& leaf)
{
    return Rotation(leaf.rotation[3], leaf.rotation[0], leaf.rotation[1], leaf.rotation[2]);
}

Vec3 directionOf(const LeafInstance& leaf)
{
    return rotationOf(leaf) * Vec3(Vec3::UnitY());
}

Vec3 normalOf(const LeafInstance& leaf)
{
    return rotationOf(leaf) * Vec3(Vec3::UnitZ());
}

float distanceToTriangle(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 normal = (b - a).cross(c - a);
    const auto toEdge = [&](const Vec3& from, const Vec3& to) {
        const Vec3 edge = to - from;
        const float t =
            std::clamp((point - from).dot(edge) / std::max(edge.squaredNorm(), 1e-20F), 0.0F, 1.0F);
        return (point - from - t * edge).norm();
    };
    const bool isOver = normal.squaredNorm() > 1e-20F && (b - a).cross(point - a).dot(normal) >= 0.0F &&
                        (c - b).cross(point - b).dot(normal) >= 0.0F &&
                        (a - c).cross(point - c).dot(normal) >= 0.0F;
    if (isOver)
        return std::abs((point - a).dot(normal)) / normal.norm();
    return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

/// Distance of a leaf's foot from the line along an internode, m.
float distanceFromAxis(const TreeBuilder& builder, InternodeId id, const LeafInstance& leaf)
{
    const Vec3 axis = builder.index.heading(id);
    const Vec3 off = toVec3(leaf.position) - builder.index.nodePosition(id);
    return (off - off.dot(axis) * axis).norm();
}

} // namespace

void LeafPlacerTest::leaves_areOnYoungShootsAlone()
{
    for (const int maxTips : {1, 3, 20}) {
        for (const int perNode : {1, 2, 5}) {
            TreeParameters parameters;
            parameters.leaves.maxTips = maxTips;
            parameters.leaves.perNode = perNode;
            const TreeBuilder builder = raisedTree(800, 1, parameters);
            const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
            std::size_t expected = 0;
            for (InternodeId id = 0; id < builder.tree.size(); ++id) {
                const std::uint32_t tips = builder.index.tipCount(id);
                if (tips < 1 || tips > static_cast<std::uint32_t>(maxTips))
                    continue;
                for (const LeafInstance& leaf : leavesOf(builder, id)) {
                    QVERIFY(std::ranges::find(leaves, leaf) != leaves.end());
                    ++expected;
                }
            }
            QCOMPARE(leaves.size(), expected);
        }
    }
}

void LeafPlacerTest::woodThatTheUserMadeThick_isBare()
{
    TreeParameters parameters;
    parameters.leaves.length = 0.08;
    TreeBuilder builder(1, parameters);
    const InternodeId tip = builder.growAxis(0, kTerminalSlot, continuing(), 4);
    QVERIFY(LeafRule(builder.tree, builder.index).bears(tip));
    builder.apply(widthChange(builder.tree, tip, 0.04F));
    QVERIFY(!LeafRule(builder.tree, builder.index).bears(tip));
    QVERIFY(LeafRule(builder.tree, builder.index).bears(tip - 1));
    builder.apply(widthChange(builder.tree, tip, 0.015F));
    QVERIFY(LeafRule(builder.tree, builder.index).bears(tip));
}

void LeafPlacerTest::leaves_followTheParametersInForce()
{
    TreeBuilder builder = raisedTree(300, 2, exact());
    TreeParameters parameters = builder.tree.parameters();
    parameters.leaves.shape = LeafShape::Lobed;
    parameters.leaves.length = 0.2;
    parameters.leaves.aspect = 0.5;
    builder.apply(parameterChange(builder.tree, parameters));
    const auto leaves = leavesOf(builder);
    QVERIFY(!leaves.empty());
    for (const LeafInstance& leaf : leaves) {
        QCOMPARE(leaf.shape, static_cast<std::int32_t>(LeafShape::Lobed));
        QCOMPARE(leaf.length, 0.2F);
        QCOMPARE(leaf.width, 0.1F);
    }
    parameters.leaves.visible = false;
    builder.apply(parameterChange(builder.tree, parameters));
    QVERIFY(leavesOf(builder).empty());
    parameters.leaves.visible = true;
    parameters.leaves.perNode = 0;
    builder.apply(parameterChange(builder.tree, parameters));
    QVERIFY(leavesOf(builder).empty());
}

void LeafPlacerTest::azimuth_turnsByThePhyllotaxis_data()
{
    QTest::addColumn<double>("turn"); // degrees from node to node
    QTest::addColumn<int>("perNode");
    QTest::newRow("golden spiral") << 137.507764 << 1;
    QTest::newRow("distichous") << 180.0 << 1;
    QTest::newRow("decussate") << 90.0 << 2;
    QTest::newRow("whorls of three") << 60.0 << 3;
    QTest::newRow("two fifths") << 144.0 << 1;
}

void LeafPlacerTest::azimuth_turnsByThePhyllotaxis()
{
    QFETCH(double, turn);
    QFETCH(int, perNode);
    TreeParameters parameters = exact();
    parameters.leaves.perNode = perNode;
    TreeBuilder builder(1, parameters);
    // Bent by 5° a node: azimuths are measured in frames that are carried along without twist.
    builder.growAxis(0, kTerminalSlot, continuing(0.0, 0.0, radians(turn)), 12,
                     continuing(radians(5), 1.0, radians(turn)));
    Rotation carried = builder.index.rotation(0);
    std::vector<double> azimuths;
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        const Rotation bend(
            Rotation::FromTwoVectors(carried * Vec3(Vec3::UnitY()), builder.index.heading(id)));
        carried = (bend * carried).normalized();
        const std::vector<LeafInstance> leaves = leavesOf(builder, id);
        QCOMPARE(leaves.size(), static_cast<std::size_t>(perNode));
        for (std::size_t i = 0; i < leaves.size(); ++i) {
            const Vec3 local = carried.conjugate() * directionOf(leaves[i]);
            const double azimuth = std::atan2(local.z(), local.x());
            if (i == 0)
                azimuths.push_back(azimuth);
            const double expected =
                azimuths.back() + 2.0 * std::numbers::pi * static_cast<double>(i) / perNode;
            QVERIFY(std::abs(std::remainder(azimuth - expected, 2.0 * std::numbers::pi)) < 1e-4);
        }
    }
    for (std::size_t i = 1; i < azimuths.size(); ++i) {
        // The frames roll about +Y, from +Z toward +X; azimuths are measured the other way.
        const double step = azimuths[i - 1] - azimuths[i];
        QVERIFY2(std::abs(std::remainder(step - radians(turn), 2.0 * std::numbers::pi)) < 1e-4,
                 qPrintable(QString::number(degrees(step))));
    }
}

void LeafPlacerTest::angle_isThatBetweenShootAndPetiole()
{
    for (const double angle : {0.0, 30.0, 60.0, 120.0}) {
        TreeParameters parameters = exact();
        parameters.leaves.angle = radians(angle);
        const TreeBuilder builder = raisedTree(200, 3, parameters);
        for (InternodeId id = 0; id < builder.tree.size(); ++id) {
            if (!LeafRule(builder.tree, builder.index).bears(id))
                continue;
            for (const LeafInstance& leaf : leavesOf(builder, id)) {
                const double cosine = directionOf(leaf).dot(builder.index.heading(id));
                QVERIFY(std::abs(cosine - std::cos(radians(angle))) < 1e-5);
            }
        }
    }
}

void LeafPlacerTest::droop_turnsLeavesDown()
{
    double above = 2.0;
    for (const double droop : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        TreeParameters parameters = exact();
        parameters.leaves.droop = droop;
        const TreeBuilder builder = raisedTree(300, 4, parameters);
        double mean = 0.0;
        const auto leaves = leavesOf(builder);
        for (const LeafInstance& leaf : leaves)
            mean += directionOf(leaf).y() / static_cast<double>(leaves.size());
        QVERIFY(mean < above);
        above = mean;
        if (droop == 1.0) {
            for (const LeafInstance& leaf : leaves)
                QVERIFY(directionOf(leaf).y() < -0.9999F);
        }
    }
}

void LeafPlacerTest::frames_areOrthonormal()
{
    for (const double upward : {0.0, 0.5, 1.0}) {
        TreeParameters parameters;
        parameters.growth.irregularity = 1.0;
        parameters.leaves.upward = upward;
        const TreeBuilder builder = raisedTree(600, 5, parameters);
        for (const LeafInstance& leaf : leavesOf(builder)) {
            QVERIFY(std::abs(rotationOf(leaf).norm() - 1.0F) < 1e-5F);
            const Vec3 direction = directionOf(leaf);
            const Vec3 normal = normalOf(leaf);
            QVERIFY(std::abs(direction.norm() - 1.0F) < 1e-5F);
            QVERIFY(std::abs(direction.dot(normal)) < 1e-5F);
        }
    }
}

void LeafPlacerTest::faces_lookUp()
{
    for (const double upward : {0.1, 0.6, 1.0}) {
        TreeParameters parameters;
        parameters.growth.irregularity = 1.0;
        parameters.leaves.upward = upward;
        parameters.leaves.droop = 0.4;
        const TreeBuilder builder = raisedTree(600, 6, parameters);
        double worst = 1.0;
        for (const LeafInstance& leaf : leavesOf(builder)) {
            worst = std::min(worst, static_cast<double>(normalOf(leaf).y()));
            // As far up as its direction allows.
            if (upward == 1.0)
                QVERIFY(std::abs(normalOf(leaf).y() -
                                 std::sqrt(1.0F - std::pow(directionOf(leaf).y(), 2.0F))) < 1e-3F);
        }
        QVERIFY2(worst >= -1e-5, qPrintable(QString::number(worst)));
    }
}

void LeafPlacerTest::sizes_varyAsMuchAsAsked()
{
    for (const double variation : {0.0, 0.25, 0.5}) {
        TreeParameters parameters = exact();
        parameters.leaves.length = 0.1;
        parameters.leaves.sizeVariation = variation;
        const TreeBuilder builder = raisedTree(1500, 7, parameters);
        double least = 1.0;
        double most = 0.0;
        double mean = 0.0;
        const auto leaves = leavesOf(builder);
        for (const LeafInstance& leaf : leaves) {
            QVERIFY(std::abs(leaf.width - 0.6F * leaf.length) < 1e-6F);
            least = std::min(least, static_cast<double>(leaf.length));
            most = std::max(most, static_cast<double>(leaf.length));
            mean += leaf.length / static_cast<double>(leaves.size());
        }
        QVERIFY(least >= 0.1 * (1.0 - variation) - 1e-6 && least <= 0.1 * (1.0 - 0.95 * variation) + 1e-6);
        QVERIFY(most <= 0.1 * (1.0 + variation) + 1e-6 && most >= 0.1 * (1.0 + 0.95 * variation) - 1e-6);
        QVERIFY(std::abs(mean - 0.1) < 0.003);
    }
}

void LeafPlacerTest::needles_areAlongTheInternode()
{
    TreeParameters parameters = exact();
    parameters.leaves.shape = LeafShape::Needles;
    parameters.leaves.perNode = 4;
    TreeBuilder builder(1, parameters);
    const InternodeId id = builder.grow({.rotation = continuing(), .length = 0.08F});
    const std::vector<LeafInstance> leaves = leavesOf(builder, id);
    const float top = builder.index.nodePosition(id).y();
    for (std::size_t i = 0; i < leaves.size(); ++i)
        QVERIFY(std::abs(leaves[i].position[1] - (top - 0.02F * static_cast<float>(i))) < 1e-6F);
}

void LeafPlacerTest::spiral_goesOnAlongTheAxisWhateverTheShoot()
{
    for (const int perNode : {1, 3}) {
        TreeParameters parameters = exact();
        parameters.leaves.arrangement = LeafArrangement::Spiral;
        parameters.leaves.perNode = perNode;
        TreeBuilder builder(1, parameters);
        // The buds stand in two rows; this does not affect the leaves.
        builder.growAxis(0, kTerminalSlot, continuing(0.0, 0.0, radians(180)), 12,
                         continuing(0.0, 0.0, radians(180)));
        std::vector<LeafInstance> upward; // from the foot of the axis
        for (InternodeId id = 0; id < builder.tree.size(); ++id) {
            const std::vector<LeafInstance> leaves = leavesOf(builder, id);
            upward.insert(upward.end(), leaves.rbegin(), leaves.rend());
        }
        for (std::size_t i = 1; i < upward.size(); ++i) {
            const Vec3 before = directionOf(upward[i - 1]);
            const Vec3 after = directionOf(upward[i]);
            const double turn =
                std::remainder(std::atan2(after.z(), after.x()) - std::atan2(before.z(), before.x()),
                               2.0 * std::numbers::pi);
            QVERIFY2(std::abs(std::abs(degrees(turn)) - 137.507764) < 0.01,
                     qPrintable(QString::number(degrees(turn))));
            QVERIFY(upward[i].position[1] > upward[i - 1].position[1]);
        }
    }
}

void LeafPlacerTest::opposite_standsInTheGapsOfTheNodeBelow_data()
{
    QTest::addColumn<int>("perNode");
    QTest::newRow("alternate") << 1;
    QTest::newRow("decussate") << 2;
    QTest::newRow("whorls of three") << 3;
}

void LeafPlacerTest::opposite_standsInTheGapsOfTheNodeBelow()
{
    QFETCH(int, perNode);
    TreeParameters parameters = exact();
    parameters.leaves.arrangement = LeafArrangement::Opposite;
    parameters.leaves.perNode = perNode;
    TreeBuilder builder(1, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(0.0, 0.0, radians(137.5)), 6,
                     continuing(0.0, 0.0, radians(137.5)));
    const double gap = 2.0 * std::numbers::pi / perNode;
    for (InternodeId id = 1; id < builder.tree.size(); ++id) {
        const std::vector<LeafInstance> below = leavesOf(builder, id - 1);
        for (const LeafInstance& leaf : leavesOf(builder, id)) {
            const Vec3 off = toVec3(leaf.position) - builder.index.nodePosition(id);
            QVERIFY(std::abs(off.dot(builder.index.heading(id))) < 1e-5F);
            const Vec3 direction = directionOf(leaf);
            for (const LeafInstance& other : below) {
                const double turn = std::atan2(direction.z(), direction.x()) -
                                    std::atan2(directionOf(other).z(), directionOf(other).x());
                QVERIFY(std::abs(std::abs(std::remainder(turn, gap)) - gap / 2.0) < 1e-3);
            }
        }
    }
}

void LeafPlacerTest::flat_liesLeftAndRightOfTheTwig()
{
    TreeParameters parameters = exact();
    parameters.leaves.arrangement = LeafArrangement::Flat;
    parameters.leaves.perNode = 3;
    TreeBuilder builder(1, parameters);
    const InternodeId twig = builder.tree.size();
    // A level twig whose buds go around it.
    builder.growAxis(0, 0, branching(radians(90)), 8, continuing(0.0, 0.0, radians(137.5)));
    const Vec3 axis = builder.index.heading(twig);
    const Vec3 side = axis.cross(up()).normalized();
    QVERIFY(std::abs(axis.y()) < 1e-5F);
    std::vector<LeafInstance> outward;
    for (InternodeId id = twig; id < builder.tree.size(); ++id) {
        const std::vector<LeafInstance> leaves = leavesOf(builder, id);
        outward.insert(outward.end(), leaves.rbegin(), leaves.rend());
    }
    QCOMPARE(outward.size(), std::size_t{24});
    for (std::size_t i = 0; i < outward.size(); ++i) {
        QVERIFY(std::abs(directionOf(outward[i]).y()) < 1e-4F);
        QVERIFY(std::abs(normalOf(outward[i]).y() - 1.0F) < 1e-4F);
        QVERIFY(std::abs(directionOf(outward[i]).dot(axis) - std::cos(parameters.leaves.angle)) < 1e-4);
        if (i > 0)
            QVERIFY(directionOf(outward[i]).dot(side) * directionOf(outward[i - 1]).dot(side) < 0.0F);
    }
}

void LeafPlacerTest::flat_ofAnUprightShootKeepsItsPlane()
{
    TreeParameters parameters = exact();
    parameters.leaves.arrangement = LeafArrangement::Flat;
    parameters.leaves.perNode = 1;
    TreeBuilder builder(1, parameters);
    // The axis sways by a few degrees around upright.
    for (int i = 0; i < 40; ++i)
        builder.grow({.parent = builder.tree.size() - 1,
                      .rotation = continuing(radians(4), static_cast<float>(i), radians(137.5))});
    for (InternodeId id = 1; id < builder.tree.size(); ++id) {
        if (builder.index.heading(id).y() < std::cos(radians(10)))
            continue;
        const Vec3 before = directionOf(leavesOf(builder, id - 1)[0]);
        const Vec3 after = directionOf(leavesOf(builder, id)[0]);
        // To the other side, as seen from above.
        QVERIFY(before.x() * after.x() + before.z() * after.z() < 0.0F);
    }
}

void LeafPlacerTest::arrangement_isThatOfTheAxisWhereverATubeBegins()
{
    for (const auto arrangement :
         {LeafArrangement::Spiral, LeafArrangement::Opposite, LeafArrangement::Flat}) {
        TreeParameters parameters;
        parameters.leaves.arrangement = arrangement;
        parameters.leaves.maxTips = 1000;
        const TreeBuilder builder = raisedTree(900, 11, parameters);
        const Widths widths(builder.tree, builder.index);
        const LeafPlacer placer(builder.tree, builder.index, widths);
        bool someTubeBeginsWithinAnAxis = false;
        for (const InternodeId base : tubesOf(builder.tree, builder.index)) {
            someTubeBeginsWithinAnAxis |= builder.index.axis(base) != base;
            std::vector<InternodeId> internodes;
            for (InternodeId id = base; id != kNoInternode; id = tubeContinuation(builder.index, id))
                internodes.push_back(id);
            std::vector<LeafInstance> tube(placer.rule().count(internodes));
            placer.place(internodes, tube);
            std::size_t done = 0;
            for (const InternodeId id : internodes) {
                for (const LeafInstance& leaf : leavesOf(builder, id))
                    QVERIFY(leaf == tube[done++]);
            }
            QCOMPARE(done, tube.size());
        }
        QVERIFY(someTubeBeginsWithinAnAxis);
    }
}

void LeafPlacerTest::foot_isOnTheBark_data()
{
    QTest::addColumn<LeafShape>("shape");
    QTest::addColumn<LeafArrangement>("arrangement");
    QTest::newRow("at nodes") << LeafShape::Ovate << LeafArrangement::Shoot;
    QTest::newRow("along internodes") << LeafShape::Needles << LeafArrangement::Spiral;
}

void LeafPlacerTest::foot_isOnTheBark()
{
    QFETCH(LeafShape, shape);
    QFETCH(LeafArrangement, arrangement);
    TreeParameters parameters = exact();
    parameters.leaves.shape = shape;
    parameters.leaves.arrangement = arrangement;
    parameters.leaves.perNode = 3;
    parameters.leaves.maxTips = 12;
    const TreeBuilder builder = raisedTree(900, 12, parameters);
    const Widths widths(builder.tree, builder.index);
    const LeafRule rule(builder.tree, builder.index);
    int found = 0;
    for (InternodeId id = 0; id < builder.tree.size(); ++id) {
        if (!rule.bears(id))
            continue;
        for (const LeafInstance& leaf : leavesOf(builder, id)) {
            const float radius = widths.radius(builder.index, id);
            QVERIFY(radius > 0.0F);
            QVERIFY(std::abs(distanceFromAxis(builder, id, leaf) - radius) < 1e-5F);
            // Not in the wood that a branch comes out of, unless all of its internode is.
            const InternodeId parent = builder.tree.parent(id);
            if (parent == kNoInternode || builder.index.axis(id) != id)
                continue;
            const float support = widths.radius(builder.index, parent);
            if (builder.tree.length(id) < 4.0F * support)
                continue;
            const Vec3 off = toVec3(leaf.position) - builder.index.nodePosition(parent);
            const Vec3 along = builder.index.heading(parent);
            QVERIFY((off - off.dot(along) * along).norm() > 0.9F * support - radius);
            ++found;
        }
    }
    QVERIFY2(found > 20, qPrintable(QString::number(found)));
}

void LeafPlacerTest::foot_ofStrands_isOnTheirSurface_data()
{
    QTest::addColumn<bool>("isVigorous");
    QTest::addColumn<int>("strandsPerTip");
    QTest::newRow("self-organising, one strand a tip") << false << 1;
    QTest::newRow("self-organising, three strands a tip") << false << 3;
    QTest::newRow("vigour, one strand a tip") << true << 1;
}

void LeafPlacerTest::foot_ofStrands_isOnTheirSurface()
{
    QFETCH(bool, isVigorous);
    QFETCH(int, strandsPerTip);
    TreeParameters parameters;
    parameters.wood.mesher = WoodMesherKind::Strands;
    parameters.wood.strandsPerTip = strandsPerTip;
    parameters.leaves.maxTips = 4;
    parameters.leaves.perNode = 2;
    TreeDocument document;
    if (isVigorous) {
        parameters.growth.model = GrowthModelKind::Vigour;
        parameters.vigour.growthRate = 0.8;
        parameters.vigour.internodeLength = 0.1;
    }
    document.reset(5, parameters);
    QVERIFY(grow(document, isVigorous ? 50 : 9) > 5);
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    const Widths widths(tree, index);
    const ShownWood wood(tree, index, widths);
    const BranchMesh mesh = wood.mesh();
    const StrandLines lines = wood.lines();
    const LeafPlacer strands(tree, index, widths, lines);
    const LeafPlacer tubes(tree, index, widths);
    // The triangles of each internode's wood, and of those below and above it.
    std::vector<std::vector<std::size_t>> triangles(tree.size());
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3)
        triangles[mesh.origins[mesh.indices[i]].internode].push_back(i);
    std::vector<float> off;
    float worstOfTubes = 0.0F;
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || !strands.rule().bears(id))
            continue;
        const auto distance = [&](const LeafInstance& leaf) {
            float nearest = std::numeric_limits<float>::max();
            const auto look = [&](InternodeId at) {
                for (const std::size_t i : triangles[at]) {
                    const auto corner = [&](std::size_t c) {
                        return toVec3(mesh.vertices[mesh.indices[i + c]].position);
                    };
                    nearest = std::min(
                        nearest, distanceToTriangle(toVec3(leaf.position), corner(0), corner(1), corner(2)));
                }
            };
            look(id);
            if (!tree.isRoot(id))
                look(tree.parent(id));
            for (InternodeId child = index.firstChild(id); child != kNoInternode;
                 child = index.nextSibling(child))
                look(child);
            return nearest / widths.radius(index, id);
        };
        std::vector<LeafInstance> leaves(strands.rule().leavesPerInternode());
        strands.place(id, leaves);
        for (const LeafInstance& leaf : leaves)
            off.push_back(distance(leaf));
        tubes.place(id, leaves);
        for (const LeafInstance& leaf : leaves)
            worstOfTubes = std::max(worstOfTubes, distance(leaf));
    }
    QVERIFY(off.size() > 100);
    std::ranges::sort(off);
    // In radii of the twig. Rings have few sides, and a fork's outline is not round.
    qInfo("median %.2f, worst %.2f, at tubes' places %.2f", double(off[off.size() / 2]), double(off.back()),
          double(worstOfTubes));
    QVERIFY(off[off.size() / 2] < 0.3F);
    QVERIFY(off[off.size() * 95 / 100] < 0.6F);
    QVERIFY(off.back() < 1.5F);
    QVERIFY(worstOfTubes > off.back());
}

void LeafPlacerTest::turn_ofAStraightBranch_isThatOfTheArrangement_data()
{
    QTest::addColumn<LeafArrangement>("arrangement");
    QTest::addColumn<double>("turn"); // degrees from node to node, up to half turns of a flat spray
    QTest::newRow("spiral") << LeafArrangement::Spiral << 137.507764;
    QTest::newRow("opposite") << LeafArrangement::Opposite << 180.0;
    QTest::newRow("flat") << LeafArrangement::Flat << 180.0;
    QTest::newRow("shoot") << LeafArrangement::Shoot << 100.0;
}

void LeafPlacerTest::turn_ofAStraightBranch_isThatOfTheArrangement()
{
    QFETCH(LeafArrangement, arrangement);
    QFETCH(double, turn);
    TreeParameters parameters = exact();
    parameters.leaves.arrangement = arrangement;
    parameters.leaves.perNode = 1;
    for (const double lean : {0.0, 35.0, 90.0, 130.0}) {
        TreeBuilder builder(3, parameters);
        builder.growAxis(0, kTerminalSlot, continuing(), 30, continuing());
        const InternodeId first = builder.tree.size();
        builder.growAxis(20, 0, branching(radians(lean)), 12, continuing(0.0, 0.0, radians(100)));
        const Vec3 axis = builder.index.heading(first);
        const auto azimuthOf = [&](InternodeId id) {
            const Vec3 x = anyPerpendicular(axis);
            const Vec3 direction = directionOf(leavesOf(builder, id)[0]);
            return std::atan2(direction.dot(axis.cross(x)), direction.dot(x));
        };
        for (InternodeId id = first + 1; id < builder.tree.size(); ++id) {
            const double step = std::remainder(azimuthOf(id) - azimuthOf(id - 1), 2.0 * std::numbers::pi);
            QVERIFY2(std::abs(std::abs(degrees(step)) - turn) < 0.05,
                     qPrintable(QStringLiteral("%1 at a lean of %2").arg(degrees(step)).arg(lean)));
        }
    }
}

void LeafPlacerTest::turn_ofABentAxis_isNeverSudden_data()
{
    QTest::addColumn<LeafArrangement>("arrangement");
    QTest::addColumn<double>("most"); // degrees that a node may add to the turn of the arrangement
    QTest::newRow("spiral") << LeafArrangement::Spiral << 0.1;
    QTest::newRow("opposite") << LeafArrangement::Opposite << 0.1;
    QTest::newRow("flat") << LeafArrangement::Flat << 22.0;
}

void LeafPlacerTest::turn_ofABentAxis_isNeverSudden()
{
    QFETCH(LeafArrangement, arrangement);
    QFETCH(double, most);
    TreeParameters parameters = exact();
    parameters.leaves.arrangement = arrangement;
    parameters.leaves.perNode = 1;
    // An axis that winds through all directions, upright, level and hanging.
    TreeBuilder builder(7, parameters);
    builder.growAxis(0, kTerminalSlot, continuing(), 40, continuing());
    const InternodeId first = builder.tree.size();
    builder.growAxis(40, kTerminalSlot, continuing(radians(15), 0.3F), 60, continuing(radians(15), 0.9F));
    const double turn = arrangement == LeafArrangement::Spiral ? 137.507764 : 180.0;
    for (InternodeId id = first + 1; id < builder.tree.size(); ++id) {
        const Vec3 below = builder.index.heading(id - 1);
        const Vec3 axis = builder.index.heading(id);
        const Vec3 before = Rotation::FromTwoVectors(below, axis) * directionOf(leavesOf(builder, id - 1)[0]);
        const Vec3 after = directionOf(leavesOf(builder, id)[0]);
        const double step =
            std::atan2(axis.dot(before.cross(after)),
                       (before - before.dot(axis) * axis).dot(after - after.dot(axis) * axis));
        QVERIFY2(std::abs(std::abs(degrees(step)) - turn) < most,
                 qPrintable(QStringLiteral("%1 at %2").arg(degrees(step)).arg(id - first)));
    }
}

void LeafPlacerTest::leaves_dependOnSeedAndNodeAlone()
{
    TreeBuilder small = raisedTree(200, 8);
    const InternodeId node = small.tree.size() - 1;
    const std::vector<LeafInstance> before = leavesOf(small, node);
    // The rest of the tree grows elsewhere; the leaves of this branch do not change.
    small.grow({.parent = 0, .slot = 0, .rotation = branching(0.5)});
    QCOMPARE(leavesOf(small, node), before);
    const std::vector<LeafInstance> again = leavesOf(raisedTree(200, 8), node);
    QCOMPARE(again, before);

    TreeBuilder otherSeed(99);
    TreeBuilder sameShape(8);
    for (TreeBuilder* builder : {&otherSeed, &sameShape})
        builder->grow({.rotation = continuing()});
    QVERIFY(leavesOf(otherSeed, 1) != leavesOf(sameShape, 1));
    QVERIFY(leavesOf(sameShape, 0)[0].rotation != leavesOf(sameShape, 1)[0].rotation);
}

void LeafPlacerTest::leaves_areTheSameOnOneThreadAndMany()
{
    const TreeBuilder builder = raisedTree(12000, 9);
    MeshBuffer<LeafInstance> single;
    {
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        single = leavesOf(builder);
    }
    const tbb::global_control four(tbb::global_control::max_allowed_parallelism, 4);
    QVERIFY(leavesOf(builder) == single);
}

void LeafPlacerTest::hue_shiftsFromGreenToRedWithWeakness()
{
    QCOMPARE(shootWeakness(0.0, 0.5), 1.0);
    QCOMPARE(shootWeakness(0.25, 0.5), 0.5);
    QCOMPARE(shootWeakness(0.5, 0.5), 0.0);
    QCOMPARE(shootWeakness(1.0, 0.5), 0.0);
    QCOMPARE(shootWeakness(0.3, 0.0), 0.0); // no NaN where nothing has vigour
    QCOMPARE(shootWeakness(0.0, 0.0), 0.0);

    // Half way from green (110°) to red (10°) is yellow (60°).
    QVERIFY(std::abs(degrees(shiftedLeafHue(radians(110), 0.5)) - 60.0) < 1e-9);
    for (int hue = 0; hue < 360; ++hue) {
        QCOMPARE(shiftedLeafHue(radians(hue), 0.0), radians(hue));
        double last = radians(hue);
        const double direction = shiftedLeafHue(radians(hue), 1.0) - last;
        for (int step = 1; step <= 20; ++step) {
            const double shifted = shiftedLeafHue(radians(hue), step / 20.0);
            QVERIFY((shifted - last) * direction >= 0.0); // monotone
            // Hues do not pass through blue: leaves that are not blue do not become blue.
            if (hue < 210 || hue > 270)
                QVERIFY(degrees(shifted) < 210.0 || degrees(shifted) > 270.0);
            last = shifted;
        }
        QVERIFY(std::abs(std::remainder(degrees(last) - 10.0, 360.0)) < 1e-9);
    }
}

void LeafPlacerTest::hue_ofPlacedLeaves_followsVigour()
{
    TreeParameters parameters = exact();
    parameters.leaves.vigourHue = 0.5;
    parameters.leaves.perNode = 1;
    TreeBuilder builder(1, parameters);
    float above = -10.0F;
    float brighter = 0.0F;
    for (const float vigour : {0.0F, 0.1F, 0.3F, 0.6F, 1.0F}) {
        const InternodeId id =
            builder.grow({.parent = builder.tree.size() - 1, .rotation = continuing(), .vigour = vigour});
        const LeafInstance leaf = leavesOf(builder, id).front();
        const double expected =
            shiftedLeafHue(parameters.leaves.hue, 0.5 * shootWeakness(vigour)) - kLeafTextureHue;
        QVERIFY(std::abs(leaf.hueShift - expected) < 1e-6);
        QVERIFY(leaf.hueShift >= above);
        QVERIFY(leaf.value >= brighter && leaf.value >= 0.9F && leaf.value <= 1.0F);
        above = leaf.hueShift;
        brighter = leaf.value;
    }
}

void LeafPlacerTest::leaves_nearTheGround_turnUpward()
{
    for (const LeafShape shape : {LeafShape::Ovate, LeafShape::Needles, LeafShape::Frond}) {
        TreeParameters parameters;
        parameters.leaves.shape = shape;
        parameters.leaves.length = 0.8;
        parameters.leaves.aspect = 0.4;
        parameters.leaves.droop = 0.9;
        parameters.leaves.perNode = 5;
        TreeBuilder builder(1, parameters);
        builder.growAxis(0, kTerminalSlot, continuing(), 4, continuing(), 0.05F);
        const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
        QVERIFY(leaves.size() >= 20);
        for (const LeafInstance& leaf : leaves)
            QVERIFY(leaf.length > 0.0F);
        for (const MeshVertex& vertex : expandLeaves(leaves).vertices)
            QVERIFY2(vertex.position[1] > -1e-5F, qPrintable(QString::number(vertex.position[1])));
    }
}

void LeafPlacerTest::leaves_belowTheGround_areHidden()
{
    TreeBuilder builder;
    builder.apply(bend(builder.tree, 0, continuing(2.5, 0.0, 0.0), 3.0F));
    const MeshBuffer<LeafInstance> leaves = leavesOf(builder);
    QVERIFY(!leaves.empty());
    for (const LeafInstance& leaf : leaves)
        QVERIFY(leaf.length == 0.0F || leaf.position[1] >= 0.0F);
    QVERIFY(std::ranges::any_of(leaves, [](const LeafInstance& leaf) { return leaf.length == 0.0F; }));
}

const TestClass<LeafPlacerTest> leafPlacerTest;

} // namespace espalier::test

#include "LeafPlacerTest.moc"
