// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandLayouts.h"

#include "commands/recipe/RecipePlayer.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QFileInfo>
#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class StrandLayoutsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void strands_areConserved();
    void strand_passesEachAncestorOnce();
    void strands_doNotOverlapAtRest();
    void bundles_areDenseAndCentred();
    void samples_keepTheInvariants_data();
    void samples_keepTheInvariants();
    void layouts_areTheSameOnOneThreadAndMany();
    void layouts_followTheTreesTurn();
    void bundles_lieBesideEachOtherBeforePacking();
    void steps_leadFromMergedToPacked();
    void dynamics_keepTheStrandsTogether();
    void frames_areOrthonormal();
    void frames_ofAClosedBendReturn();
    void frames_turnAsLittleAsTheBranch();
    void twist_keepsRadiiAndDistances();
    void twist_turnsTheNodeAndAllAbove();
    void twist_turnsProfiles();
    void profile_drawsItsNode_data();
    void profile_drawsItsNode();
    void profile_ofABaseInternode_holdsTenThousandStrands();
    void profile_ofADeadBranch_hasNoEffect();
    void seedling_hasOneSectionOfItsStrands();
    void fixedStrandRadius_isTheScaleEverywhere();
    void strands_moveLittleFromNodeToNode();
};

namespace {

/// Of the circle around a bundle of 50 strands or more.
constexpr float kLeastFill = 0.698F;

/// Calls @p visit with random trees of several sizes and strands.
template <class Visit>
void forRandomTrees(Visit&& visit)
{
    for (const std::uint32_t count : {1U, 2U, 9U, 120U, 2500U}) {
        for (std::uint64_t seed = 1; seed <= 3; ++seed)
            visit(randomTree(count, seed, strandParameters(static_cast<int>(1 + seed % 5))));
    }
}

/// What the structure of the strands violates; empty for nothing.
QString skeletonFault(const StrandSkeleton& skeleton, std::uint32_t perTip)
{
    std::uint64_t tips = 0;
    std::uint64_t atBases = 0;
    for (std::uint32_t i = 0; i < skeleton.nodes.size(); ++i) {
        const StrandNode& node = skeleton.nodes[i];
        std::uint32_t sum = 0;
        for (const std::uint32_t child : skeleton.childrenOf(i)) {
            if (skeleton.nodes[child].parent != i || child <= i)
                return QStringLiteral("node %1 is no child of %2").arg(child).arg(i);
            if (skeleton.nodes[child].offset != sum)
                return QStringLiteral("the strands of node %1 begin at the wrong place").arg(child);
            sum += skeleton.nodes[child].strands;
        }
        if (node.childCount == 0) {
            sum = perTip;
            ++tips;
        }
        if (node.strands != sum)
            return QStringLiteral("node %1 has %2 strands instead of %3").arg(i).arg(node.strands).arg(sum);
        if (skeleton.isBase(i))
            atBases += node.strands;
    }
    return tips * perTip == atBases ? QString() : QStringLiteral("strands are lost on their way");
}

/// The radius of a section's strands around their middle, discs included.
float radiusOf(std::span<const Vec2> places)
{
    Vec2 middle = Vec2::Zero();
    for (const Vec2& place : places)
        middle += place / static_cast<float>(places.size());
    float radius = 0.0F;
    for (const Vec2& place : places)
        radius = std::max(radius, (place - middle).norm() + 1.0F);
    return radius;
}

/// How far strands of the thickest child move from a node to the one below, in radii of the section.
std::vector<float> movesOf(const StrandLayouts& layouts)
{
    std::vector<float> moves;
    const StrandSkeleton& skeleton = layouts.skeleton();
    for (std::uint32_t i = 0; i < skeleton.nodes.size(); ++i) {
        std::uint32_t main = i;
        for (const std::uint32_t child : skeleton.childrenOf(i)) {
            if (main == i || skeleton.nodes[child].strands > skeleton.nodes[main].strands)
                main = child;
        }
        if (main == i)
            continue;
        const StrandNode& child = skeleton.nodes[main];
        for (std::uint32_t s = 0; s < child.strands; ++s)
            moves.push_back((layouts.place(i, child.offset + s) - layouts.place(main, s)).norm() /
                            bundleRadius(layouts.strandCount(i)));
    }
    std::ranges::sort(moves);
    return moves;
}

bool samePlaces(const StrandLayouts& a, const StrandLayouts& b)
{
    if (a.skeleton().nodes.size() != b.skeleton().nodes.size())
        return false;
    for (std::uint32_t i = 0; i < a.skeleton().nodes.size(); ++i) {
        if (placesAt(a, i) != placesAt(b, i) || a.scale(i) != b.scale(i) || a.centre(i) != b.centre(i))
            return false;
    }
    return true;
}

} // namespace

void StrandLayoutsTest::strands_areConserved()
{
    forRandomTrees([](const TreeBuilder& grown) {
        const StrandLayouts layouts = layoutsOf(grown);
        QCOMPARE(skeletonFault(layouts.skeleton(),
                               static_cast<std::uint32_t>(grown.tree.parameters().wood.strandsPerTip)),
                 QString());
    });
}

void StrandLayoutsTest::strand_passesEachAncestorOnce()
{
    const TreeBuilder grown = randomTree(400, 2, strandParameters(2));
    const StrandLayouts layouts = layoutsOf(grown);
    const StrandSkeleton& skeleton = layouts.skeleton();
    std::vector<std::vector<int>> visits;
    for (const StrandNode& node : skeleton.nodes)
        visits.emplace_back(node.strands, 0);
    for (std::uint32_t tip = 0; tip < skeleton.nodes.size(); ++tip) {
        if (skeleton.nodes[tip].childCount > 0)
            continue;
        for (std::uint32_t i = 0; i < skeleton.nodes[tip].strands; ++i) {
            std::uint32_t strand = i;
            std::uint32_t node = tip;
            for (;; node = skeleton.nodes[node].parent) {
                ++visits[node][strand];
                if (skeleton.isBase(node))
                    break;
                strand += skeleton.nodes[node].offset;
            }
        }
    }
    for (const std::vector<int>& ofNode : visits) {
        for (const int count : ofNode)
            QCOMPARE(count, 1);
    }
}

void StrandLayoutsTest::strands_doNotOverlapAtRest()
{
    forRandomTrees([](const TreeBuilder& grown) {
        const StrandLayouts layouts = layoutsOf(grown);
        QVERIFY(layouts.count().deepest <= 0.05);
        for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i) {
            if (layouts.owner(i) == i && layouts.strandCount(i) > 1)
                QVERIFY(nearestPair(layouts.places(i)) >= 1.9F);
        }
    });
}

void StrandLayoutsTest::bundles_areDenseAndCentred()
{
    forRandomTrees([](const TreeBuilder& grown) {
        const StrandLayouts layouts = layoutsOf(grown);
        for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i) {
            const std::vector<Vec2> places = placesAt(layouts, i);
            QCOMPARE(places.size(), layouts.skeleton().nodes[i].strands);
            Vec2 middle = Vec2::Zero();
            for (const Vec2& place : places)
                middle += place / static_cast<float>(places.size());
            QVERIFY(middle.norm() < 1e-2F);
            const float radius = radiusOf(places);
            if (places.size() >= 50)
                QVERIFY2(static_cast<float>(places.size()) / (radius * radius) >= kLeastFill,
                         qPrintable(QStringLiteral("%1: %2").arg(places.size()).arg(double{radius})));
            // A section's bark is where the widths of branches want it.
            QVERIFY(std::abs(bundleRadius(static_cast<std::uint32_t>(places.size())) - radius) < 1.2F);
        }
    });
}

void StrandLayoutsTest::samples_keepTheInvariants_data()
{
    QTest::addColumn<QString>("name");
    QStringList names;
    for (const QFileInfo& file : QDir(QStringLiteral(SOURCE_DIR "/resources/recipes"))
                                     .entryInfoList({QStringLiteral("*.json")}, QDir::Files, QDir::Name))
        names << file.completeBaseName();
    QVERIFY(names.size() >= 38);
    for (const QString& name : names)
        QTest::newRow(qPrintable(name)) << name;
}

void StrandLayoutsTest::samples_keepTheInvariants()
{
    QFETCH(const QString, name);
    const Result<Recipe> recipe =
        readRecipe(QStringLiteral(SOURCE_DIR "/resources/recipes/%1.json").arg(name));
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument document;
    RecipePlayer(document, *recipe).playAll();
    const StrandLayouts layouts = layoutsOf(document.tree(), document.index());
    QCOMPARE(skeletonFault(layouts.skeleton(),
                           static_cast<std::uint32_t>(document.tree().parameters().wood.strandsPerTip)),
             QString());
    const StrandLayouts::Counts counts = layouts.count();
    QVERIFY(counts.deepest <= 0.05);
    QVERIFY(counts.particles >= counts.strands);
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i) {
        QVERIFY(layouts.centre(i).allFinite());
        QVERIFY(std::isfinite(layouts.scale(i)) && layouts.scale(i) > 0.0F);
        if (layouts.owner(i) != i || layouts.strandCount(i) < 50)
            continue;
        const StrandNode& node = layouts.skeleton().nodes[i];
        const float count = static_cast<float>(layouts.strandCount(i));
        const float scale = layouts.profileScale(i);
        const StrandProfile* const profile =
            node.along == 1.0F ? document.tree().profileOf(node.internode) : nullptr;
        if (profile != nullptr) {
            // A drawn section: its strands are inside, and fill it.
            const float fill = count * std::numbers::pi_v<float> / (scale * scale * areaOf(*profile));
            QVERIFY2(fill >= 0.7F, qPrintable(QStringLiteral("%1: %2").arg(i).arg(double{fill})));
            for (const Vec2& place : layouts.places(i))
                QVERIFY(distanceOutside(*profile, place / scale) * scale < 0.5F);
        } else if (scale == 0.0F) {
            const float radius = radiusOf(layouts.places(i));
            QVERIFY2(count / (radius * radius) >= kLeastFill,
                     qPrintable(QStringLiteral("%1: %2").arg(count).arg(double{radius})));
        }
    }
}

void StrandLayoutsTest::layouts_areTheSameOnOneThreadAndMany()
{
    for (const StrandPacking packing : {StrandPacking::Rest, StrandPacking::Pbd}) {
        TreeBuilder grown = randomTree(1500, 4, strandParameters(1, packing, 40));
        grown.apply(profileChange(grown.tree, 3, profileOf(ProfileShape::CShape)));
        const StrandLayouts many = layoutsOf(grown);
        const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        QVERIFY(samePlaces(layoutsOf(grown), many));
    }
}

void StrandLayoutsTest::layouts_followTheTreesTurn()
{
    // Sections turn with the tree, so their own coordinates stay. Rounding may decide between slots that are
    // equally good.
    TreeBuilder grown = randomTree(600, 5, strandParameters(2));
    const StrandLayouts before = layoutsOf(grown);
    const Rotation turn(Eigen::AngleAxisf(1.234F, Vec3::UnitY()));
    TreeDelta delta = deltaStartingAt(grown.tree);
    const Rotation root = grown.tree.columns().rotation[0];
    delta.addFrame(0, root, (turn * root).normalized(), grown.tree.length(0), grown.tree.length(0));
    grown.apply(std::move(delta));
    const StrandLayouts after = layoutsOf(grown);
    std::size_t strands = 0;
    std::size_t differing = 0;
    for (std::uint32_t i = 0; i < before.skeleton().nodes.size(); ++i) {
        QVERIFY((after.centre(i) - turn * before.centre(i)).norm() < 0.05F);
        for (std::uint32_t s = 0; s < before.strandCount(i); ++s) {
            const Vec3 expected = turn * before.world(i, before.place(i, s));
            ++strands;
            differing +=
                (after.world(i, after.place(i, s)) - expected).norm() > 0.2F * before.scale(i) ? 1 : 0;
        }
    }
    QVERIFY2(100 * differing <= strands, qPrintable(QStringLiteral("%1 of %2").arg(differing).arg(strands)));
}

void StrandLayoutsTest::bundles_lieBesideEachOtherBeforePacking()
{
    // Without a step of packing, the layouts are the merged ones.
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const TreeBuilder grown = randomTree(300, seed, strandParameters(3, StrandPacking::Rest, 0));
        const StrandLayouts layouts = layoutsOf(grown);
        const StrandSkeleton& skeleton = layouts.skeleton();
        for (std::uint32_t i = 0; i < skeleton.nodes.size(); ++i) {
            const auto children = skeleton.childrenOf(i);
            const std::vector<Vec2> places = placesAt(layouts, i);
            for (std::size_t a = 0; a < children.size(); ++a) {
                for (std::size_t b = a + 1; b < children.size(); ++b) {
                    const StrandNode& first = skeleton.nodes[children[a]];
                    const StrandNode& second = skeleton.nodes[children[b]];
                    float nearest = 1e9F;
                    for (std::uint32_t s = 0; s < first.strands; ++s) {
                        for (std::uint32_t t = 0; t < second.strands; ++t)
                            nearest = std::min(nearest,
                                               (places[first.offset + s] - places[second.offset + t]).norm());
                    }
                    QVERIFY2(nearest >= 2.0F - 1e-3F, qPrintable(QString::number(double{nearest})));
                }
            }
        }
    }
}

void StrandLayoutsTest::steps_leadFromMergedToPacked()
{
    const auto radiusAfter = [](int steps) {
        const TreeBuilder grown = randomTree(2000, 1, strandParameters(1, StrandPacking::Rest, steps));
        const StrandLayouts layouts = layoutsOf(grown);
        return radiusOf(placesAt(layouts, layouts.skeleton().bases.front()));
    };
    const float merged = radiusAfter(0);
    const float between = radiusAfter(20);
    const float packed = radiusAfter(10'000);
    QVERIFY2(between < merged && packed < between,
             qPrintable(QStringLiteral("%1 %2 %3").arg(merged).arg(between).arg(packed)));
    QVERIFY(packed < 1.1F * bundleRadius(layoutsOf(randomTree(2000)).strandCount(0)));
}

void StrandLayoutsTest::dynamics_keepTheStrandsTogether()
{
    const TreeBuilder grown = randomTree(200, 1, strandParameters(2, StrandPacking::Pbd, 300));
    const StrandLayouts layouts = layoutsOf(grown);
    QCOMPARE(skeletonFault(layouts.skeleton(), 2), QString());
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i) {
        for (const Vec2& place : placesAt(layouts, i))
            QVERIFY(place.allFinite() && place.norm() < 6.0F * bundleRadius(layouts.strandCount(i)));
    }
}

void StrandLayoutsTest::frames_areOrthonormal()
{
    forRandomTrees([](const TreeBuilder& grown) {
        const StrandLayouts layouts = layoutsOf(grown);
        for (const StrandNode& node : layouts.skeleton().nodes)
            QVERIFY(std::abs(node.frame.norm() - 1.0F) < 1e-5F);
    });
}

void StrandLayoutsTest::frames_ofAClosedBendReturn()
{
    TreeBuilder grown;
    // A bend about one axis, all around.
    const auto step = static_cast<float>(2.0 * std::numbers::pi / 24.0);
    grown.growAxis(0, kTerminalSlot, continuing(double{step}, 0.0, 0.0), 24,
                   continuing(double{step}, 0.0, 0.0));
    const StrandLayouts layouts = layoutsOf(grown);
    const std::vector<StrandNode>& nodes = layouts.skeleton().nodes;
    const Vec3 axis = nodes.front().frame * Vec3::UnitZ();
    for (const StrandNode& node : nodes)
        QVERIFY((node.frame * Vec3::UnitZ() - axis).norm() < 1e-3F);
    // After a whole round both directions across the branch are back.
    const Rotation& early = nodes[2].frame;
    const Rotation& late = nodes[26 - 1].frame;
    const float angle = early.angularDistance(late);
    QVERIFY2(angle < step * 1.6F, qPrintable(QString::number(double{angle})));
}

void StrandLayoutsTest::frames_turnAsLittleAsTheBranch()
{
    // Frames turn with the internodes, and from these to the line of the wood, which is rounder: what they
    // turn about the branch on the way is little, and does not add up.
    const TreeBuilder grown = randomTree(500, 6);
    const StrandLayouts layouts = layoutsOf(grown);
    const std::vector<StrandNode>& nodes = layouts.skeleton().nodes;
    double sum = 0.0;
    float most = 0.0F;
    for (const StrandNode& node : nodes) {
        const Rotation& below = nodes[node.parent].frame;
        const Rotation carried = Rotation::FromTwoVectors(below * up(), node.frame * up()) * below;
        const float about = carried.angularDistance(node.frame);
        sum += double{about};
        most = std::max(most, about);
    }
    const double mean = sum / static_cast<double>(nodes.size());
    QVERIFY2(mean < 0.01 && most < 0.2F, qPrintable(QStringLiteral("%1 %2").arg(mean).arg(double{most})));
}

void StrandLayoutsTest::twist_keepsRadiiAndDistances()
{
    TreeBuilder grown = randomTree(400, 3, strandParameters(2));
    const StrandLayouts before = layoutsOf(grown);
    for (InternodeId id = 1; id < 60; id += 3)
        grown.apply(twistChange(grown.tree, id, 0.05F * static_cast<float>(id % 7)));
    const StrandLayouts after = layoutsOf(grown);
    for (std::uint32_t i = 0; i < before.skeleton().nodes.size(); ++i) {
        const std::vector<Vec2> a = placesAt(before, i);
        const std::vector<Vec2> b = placesAt(after, i);
        // Twisted branches come from other sides, so a strand may have another slot at forks below; the
        // bundle's form stays.
        std::vector<float> radiiA;
        std::vector<float> radiiB;
        for (std::size_t s = 0; s < a.size(); ++s) {
            radiiA.push_back(a[s].norm());
            radiiB.push_back(b[s].norm());
        }
        std::ranges::sort(radiiA);
        std::ranges::sort(radiiB);
        for (std::size_t s = 0; s < a.size(); ++s)
            QVERIFY(std::abs(radiiA[s] - radiiB[s]) < 1e-2F);
        if (b.size() > 1)
            QVERIFY(nearestPair(b) >= 1.9F);
    }
}

void StrandLayoutsTest::twist_turnsTheNodeAndAllAbove()
{
    TreeBuilder grown(1, strandParameters(5));
    const InternodeId tip = grown.growAxis(0, kTerminalSlot, continuing(0.1), 6);
    const StrandLayouts before = layoutsOf(grown);
    grown.apply(twistChange(grown.tree, 3, 0.7F));
    const StrandLayouts after = layoutsOf(grown);
    for (InternodeId id = 0; id <= tip; ++id) {
        const std::uint32_t node = nodeOf(after, id);
        const Vec3 heading = before.skeleton().nodes[node].frame * up();
        for (std::uint32_t s = 0; s < 5; ++s) {
            const Vec3& centre = before.centre(node);
            const Vec3 from = before.world(node, before.place(node, s)) - centre;
            const Vec3 to = after.world(node, after.place(node, s)) - centre;
            // Seen from the tip, it turns clockwise.
            const Vec3 expected = id < 3 ? from : Vec3(Eigen::AngleAxisf(-0.7F, heading) * from);
            QVERIFY((to - expected).norm() < 1e-5F);
        }
    }
}

void StrandLayoutsTest::twist_turnsProfiles()
{
    TreeBuilder grown(1, strandParameters(5));
    grown.growAxis(0, kTerminalSlot, continuing(0.1), 6);
    for (InternodeId id = 1; id <= 4; ++id)
        grown.apply(profileChange(grown.tree, id, profileOf(ProfileShape::Elongated)));
    const StrandLayouts before = layoutsOf(grown);
    for (InternodeId id = 1; id <= 4; ++id)
        grown.apply(twistChange(grown.tree, id, 0.3F));
    const StrandLayouts after = layoutsOf(grown);
    for (InternodeId id = 1; id <= 4; ++id) {
        // Strands keep their places in the profile, which turns with them.
        const std::uint32_t node = nodeOf(after, id);
        QVERIFY(placesAt(before, node) == placesAt(after, node));
        const Rotation& from = before.skeleton().nodes[node].frame;
        const Rotation& to = after.skeleton().nodes[node].frame;
        QVERIFY(std::abs(from.angularDistance(to) - 0.3F * static_cast<float>(id)) < 1e-4F);
    }
}

void StrandLayoutsTest::profile_drawsItsNode_data()
{
    QTest::addColumn<StrandProfile>("profile");
    for (int i = 0; i < kProfileShapeCount; ++i)
        QTest::newRow(qPrintable(QStringLiteral("shape %1").arg(i)))
            << profileOf(static_cast<ProfileShape>(i));
    QTest::newRow("thin C") << thinC(0.1F);
    StrandProfile attracted = profileOf(ProfileShape::Round);
    attracted.attractors = {{Vec2(3.0F, 3.0F), Vec2(4.0F, 3.0F)}};
    QTest::newRow("attractor outside") << attracted;
}

void StrandLayoutsTest::profile_drawsItsNode()
{
    QFETCH(const StrandProfile, profile);
    for (const InternodeId id : {0U, 2U, 5U, 40U}) {
        TreeBuilder grown = randomTree(400, 3);
        const StrandLayouts before = layoutsOf(grown);
        grown.apply(profileChange(grown.tree, id, profile));
        const StrandLayouts after = layoutsOf(grown);
        const std::uint32_t node = nodeOf(after, id);
        QVERIFY(after.profileScale(node) > 0.0F);
        QVERIFY(!after.isDisc(node));
        const std::vector<Vec2> places = placesAt(after, node);
        if (places.size() > 1)
            QVERIFY(nearestPair(places) >= 1.9F);
        for (const Vec2& place : places)
            QVERIFY(distanceOutside(profile, place / after.profileScale(node)) * after.profileScale(node) <
                    0.5F);
        const StrandNode& drawn = after.skeleton().nodes[node];
        for (std::uint32_t i = 0; i < after.skeleton().nodes.size(); ++i) {
            // It fades over twice the radius of the wood. The foot of a trunk has that of its first node.
            const float distance = (after.skeleton().nodes[i].position - drawn.position).norm();
            if (distance < 2.01F * drawn.radius || (id == 0 && after.skeleton().isBase(i)))
                continue;
            QCOMPARE(after.profileScale(i), 0.0F);
            QVERIFY(placesAt(after, i) == placesAt(before, i));
        }
    }
}

void StrandLayoutsTest::profile_ofABaseInternode_holdsTenThousandStrands()
{
    TreeBuilder grown = forkedTree(10'000);
    const StrandProfile ring = profileOf(ProfileShape::Ring);
    grown.apply(profileChange(grown.tree, 1, ring));
    const StrandLayouts layouts = layoutsOf(grown);
    const std::uint32_t node = nodeOf(layouts, 1);
    QCOMPARE(layouts.strandCount(node), 10'000U);
    QVERIFY(layouts.count().deepest <= 0.05);
    for (const Vec2& place : placesAt(layouts, node))
        QVERIFY(distanceOutside(ring, place / layouts.profileScale(node)) * layouts.profileScale(node) <
                0.5F);
}

void StrandLayoutsTest::profile_ofADeadBranch_hasNoEffect()
{
    TreeBuilder grown = randomTree(200, 2);
    InternodeId branch = 1;
    while (grown.tree.continuesAxis(branch))
        ++branch;
    grown.apply(profileChange(grown.tree, branch, profileOf(ProfileShape::Ring)));
    grown.apply(death(grown.tree, grown.index, branch));
    const StrandLayouts layouts = layoutsOf(grown);
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i)
        QCOMPARE(layouts.profileScale(i), 0.0F);
}

void StrandLayoutsTest::seedling_hasOneSectionOfItsStrands()
{
    TreeBuilder grown(1, strandParameters(3));
    const StrandLayouts layouts = layoutsOf(grown);
    QCOMPARE(layouts.skeleton().nodes.size(), 2U);
    QCOMPARE(layouts.strandCount(0), 3U);
    QCOMPARE(layouts.count().particles, 3U);
    grown.apply(profileChange(grown.tree, 0, thinC(0.2F)));
    const StrandLayouts drawn = layoutsOf(grown);
    QVERIFY(drawn.profileScale(1) > 0.0F);
    QVERIFY(nearestPair(placesAt(drawn, 1)) >= 1.9F);
}

void StrandLayoutsTest::fixedStrandRadius_isTheScaleEverywhere()
{
    TreeParameters parameters = strandParameters(2);
    parameters.wood.strandRadius = 0.002;
    parameters.widths.flare = 0.0;
    const StrandLayouts layouts = layoutsOf(randomTree(300, 1, parameters));
    for (std::uint32_t i = 0; i < layouts.skeleton().nodes.size(); ++i)
        QVERIFY(std::abs(layouts.scale(i) - 0.002F) < 1e-6F);
}

void StrandLayoutsTest::strands_moveLittleFromNodeToNode()
{
    const std::vector<float> moves = movesOf(layoutsOf(forkedTree(2000)));
    const auto share = [&](double part) {
        return double{moves[static_cast<std::size_t>(part * static_cast<double>(moves.size() - 1))]};
    };
    const QString found = QStringLiteral("moves: median %1, 90 %: %2, 99 %: %3, most %4")
                              .arg(share(0.5))
                              .arg(share(0.9))
                              .arg(share(0.99))
                              .arg(share(1.0));
    // Half of the strands lie in nodes without a fork. Where a quarter joins from one side, those there go to
    // the rim.
    qInfo("%s", qPrintable(found));
    QVERIFY2(share(0.5) == 0.0 && share(0.9) < 0.45 && share(0.99) < 1.0, qPrintable(found));
}

static const TestClass<StrandLayoutsTest> strandLayoutsTest;

} // namespace espalier::test

#include "StrandLayoutsTest.moc"
