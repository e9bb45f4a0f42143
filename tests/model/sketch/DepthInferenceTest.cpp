// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/DepthInference.h"

#include "model/sketch/CrownHull.h"
#include "model/sketch/WeberPenn.h"
#include "tests/model/sketch/DrawnTrees.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <algorithm>
#include <limits>

namespace espalier::test {

class DepthInferenceTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void front_ofTheFirstTree_isTheDrawing();
    void bases_lieOnTheirParents();
    void bothTrees_shareOneTrunk();
    void secondTree_isTheDrawingSeenFromTheSide();
    void tips_areInTheHull();
    void lengthsAndAngles_areWithinTheLimits();
    void angleLimit_keepsLimbsUpright();
    void lowerLimits_makeTheTreeFlatter();
    void sideways_holdsUnlessGivenUp();
    void impossibleDrawing_keepsEachBranch();
    void branches_areFartherApartThanAtRandom();
    void secondTree_keepsAwayFromTheFirst();
    void limbs_spreadAllAround();
    void leaves_standOnTheirBranches();
    void radii_comeAlong();
    void sameInput_givesTheSameTree();
    void nothingOrATrunk_isEnough();
};

namespace {

constexpr int kDrawings = 8;

SketchedTree drawing(std::uint64_t seed, int count = 40)
{
    return SketchedTree::ofStrokes(drawnTree(seed, count));
}

Eigen::Vector2d fromAbove(const Eigen::Vector3d& point)
{
    return {point.x(), point.z()};
}

double angleOf(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
    return std::atan2(a.cross(b).norm(), a.dot(b));
}

Eigen::Vector3d chordOf(const PlacedBranch& branch)
{
    return branch.line.back() - branch.line.front();
}

/// The mean, over the branches but the trunk, of the distance between a branch's outer half and the nearest
/// other branch, both seen from above and as straight segments.
double meanSeparation(const PlacedTree& tree)
{
    double sum = 0.0;
    for (std::size_t i = 1; i < tree.branches.size(); ++i) {
        const std::vector<Eigen::Vector3d>& line = tree.branches[i].line;
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < tree.branches.size(); ++j) {
            if (i == j)
                continue;
            const std::vector<Eigen::Vector3d>& other = tree.branches[j].line;
            const SketchLine segment{fromAbove(other.front()), fromAbove(other.back())};
            for (const double share : {0.5, 0.75, 1.0}) {
                const Eigen::Vector3d point = line.front() + share * (line.back() - line.front());
                nearest = std::min(nearest, nearestPlace(segment, fromAbove(point)).distance);
            }
        }
        sum += nearest;
    }
    return sum / static_cast<double>(tree.branches.size() - 1);
}

} // namespace

void DepthInferenceTest::front_ofTheFirstTree_isTheDrawing()
{
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed));
        const PlacedTree tree = inferDepth(drawn);
        double deepest = 0.0;
        for (std::size_t i = 0; i < drawn.branches().size(); ++i) {
            const SketchedBranch& branch = drawn.branches()[i];
            const PlacedBranch& placed = tree.branches[i];
            QCOMPARE(placed.source, branch.id);
            QVERIFY(!placed.isTurned);
            QCOMPARE(placed.line.size(), branch.line.size());
            for (std::size_t j = 0; j < branch.line.size(); ++j) {
                QCOMPARE(placed.line[j].x(), branch.line[j].x());
                QCOMPARE(placed.line[j].y(), branch.line[j].y());
                QVERIFY(std::isfinite(placed.line[j].z()));
                deepest = std::max(deepest, std::abs(placed.line[j].z()));
            }
        }
        QVERIFY(deepest > 0.5);
    }
}

void DepthInferenceTest::bases_lieOnTheirParents()
{
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const PlacedTree tree = inferDepth(drawing(static_cast<std::uint64_t>(seed)));
        for (std::size_t i = 1; i < tree.branches.size(); ++i) {
            const PlacedBranch& branch = tree.branches[i];
            QVERIFY(branch.parent && *branch.parent < i);
            const PlacedBranch& parent = tree.branches[*branch.parent];
            QCOMPARE(branch.order, parent.order + 1);
            // The place along the parent, in space.
            double whole = 0.0;
            for (std::size_t j = 1; j < parent.line.size(); ++j)
                whole += (parent.line[j] - parent.line[j - 1]).norm();
            double left = branch.along * whole;
            Eigen::Vector3d place = parent.line.back();
            for (std::size_t j = 1; j < parent.line.size(); ++j) {
                const Eigen::Vector3d step = parent.line[j] - parent.line[j - 1];
                if (left <= step.norm()) {
                    place = parent.line[j - 1] + left * step.normalized();
                    break;
                }
                left -= step.norm();
            }
            QVERIFY((branch.line.front() - place).norm() < 1e-6);
        }
    }
}

void DepthInferenceTest::bothTrees_shareOneTrunk()
{
    const SketchedTree drawn = drawing(1);
    const std::size_t count = drawn.branches().size();
    const PlacedTree both = inferDepth(drawn);
    QCOMPARE(both.branches.size(), 2 * (count - 1) + 1);
    for (std::size_t i = 0; i < both.branches.size(); ++i) {
        QCOMPARE(both.branches[i].parent.has_value(), i > 0);
        QCOMPARE(both.branches[i].isTurned, i >= count);
        if (i > 0 && *both.branches[i].parent > 0)
            QCOMPARE(both.branches[*both.branches[i].parent].isTurned, both.branches[i].isTurned);
    }
    const PlacedTree one = inferDepth(drawn, {.secondTree = false});
    QCOMPARE(one.branches.size(), count);
    QVERIFY(one.branches.front().line == both.branches.front().line);
}

void DepthInferenceTest::secondTree_isTheDrawingSeenFromTheSide()
{
    const SketchedTree drawn = drawing(2);
    const std::size_t count = drawn.branches().size();
    const PlacedTree tree = inferDepth(drawn);
    double different = 0.0;
    for (std::size_t i = count; i < tree.branches.size(); ++i) {
        const PlacedBranch& branch = tree.branches[i];
        const SketchedBranch* source = drawn.branch(branch.source);
        QCOMPARE(tree.branches[i - count + 1].source, branch.source);
        // Right of the base in the drawing is in front of it here; heights stay.
        for (std::size_t j = 0; j < branch.line.size(); ++j) {
            QVERIFY(std::abs(branch.line[j].y() - source->line[j].y()) < 1e-12);
            const double ahead = branch.line[j].z() - branch.line.front().z();
            QVERIFY(std::abs(ahead - (source->line[j].x() - source->line.front().x())) < 1e-9);
        }
        const double depth = branch.line.back().x() - branch.line.front().x();
        const double first = chordOf(tree.branches[i - count + 1]).z();
        different = std::max(different, std::abs(depth + first));
    }
    QVERIFY(different > 0.1); // It is not the first tree again
}

void DepthInferenceTest::tips_areInTheHull()
{
    int inside = 0;
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed));
        SketchLine points;
        for (const SketchedBranch& branch : drawn.branches())
            points.insert(points.end(), branch.line.begin(), branch.line.end());
        const CrownHull hull(points);
        for (const PlacedBranch& branch : inferDepth(drawn, {.secondTree = false}).branches) {
            const bool isInside = hull.contains(branch.line.back());
            QVERIFY(isInside || branch.broken.hull);
            inside += isInside ? 1 : 0;
        }
    }
    QVERIFY(inside >= kDrawings * 40 * 95 / 100);
}

void DepthInferenceTest::lengthsAndAngles_areWithinTheLimits()
{
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed));
        double widest = 0.0;
        std::vector<BranchLength> lengths;
        const PlacedTree flat = inferDepth(drawn, {.secondTree = false});
        const auto drawnChord = [&](std::size_t i) -> Eigen::Vector3d {
            const SketchLine& line = drawn.branches()[i].line;
            return {line.back().x() - line.front().x(), line.back().y() - line.front().y(), 0.0};
        };
        for (std::size_t i = 1; i < flat.branches.size(); ++i) {
            const Eigen::Vector3d parent = drawnChord(*flat.branches[i].parent);
            widest = std::max(widest, angleOf(parent, drawnChord(i)));
            lengths.push_back({.order = flat.branches[i].order,
                               .length = drawnChord(i).norm(),
                               .parentLength = parent.norm(),
                               .offset = drawn.branches()[i].along * parent.norm()});
        }
        const std::vector<double> shares = drawnLengthShares(lengths);
        for (std::size_t i = 1; i < flat.branches.size(); ++i) {
            const PlacedBranch& branch = flat.branches[i];
            const Eigen::Vector3d parent = chordOf(flat.branches[*branch.parent]);
            if (!branch.broken.angle)
                QVERIFY(angleOf(parent, chordOf(branch)) <= 1.2 * widest + 1e-6);
            if (branch.order > 1 && !branch.broken.length) {
                const double limit = childLength(1.2 * shares[static_cast<std::size_t>(branch.order)],
                                                 parent.norm(), drawn.branches()[i].along * parent.norm());
                QVERIFY(chordOf(branch).norm() <= limit + 1e-6);
            }
        }
    }
}

void DepthInferenceTest::angleLimit_keepsLimbsUpright()
{
    // Limbs at 45° to the trunk; depth makes the angle wider.
    std::vector<SketchStroke> strokes{openStroke({{0.0, 0.0}, {0.0, 6.0}})};
    for (int i = 0; i < 6; ++i)
        strokes.push_back(openStroke({{0.0, 2.0 + 0.4 * i}, {i % 2 == 0 ? 1.0 : -1.0, 3.0 + 0.4 * i}}));
    const SketchedTree drawn = SketchedTree::ofStrokes(strokes);
    const auto widest = [&](double magnification) {
        double angle = 0.0;
        const DepthOptions options{.sideways = DepthOptions::Sideways::None,
                                   .hullMagnification = 5.0,
                                   .angleMagnification = magnification};
        for (const PlacedBranch& branch : inferDepth(drawn, options).branches) {
            if (branch.order == 1)
                angle = std::max(angle, angleOf({0.0, 1.0, 0.0}, chordOf(branch)));
        }
        return angle;
    };
    QVERIFY(widest(1.2) <= radians(54.0) + 1e-6);
    QVERIFY(widest(1.2) > radians(48.0));
    QVERIFY(widest(4.0) > radians(65.0));
}

void DepthInferenceTest::lowerLimits_makeTheTreeFlatter()
{
    // Mean share of depth in the branches' lengths.
    const auto depth = [](const DepthOptions& options) {
        double sum = 0.0;
        int count = 0;
        for (int seed = 1; seed <= kDrawings; ++seed) {
            for (const PlacedBranch& branch :
                 inferDepth(drawing(static_cast<std::uint64_t>(seed)), options).branches) {
                if (branch.order > 1 && !branch.isTurned) {
                    sum += std::abs(chordOf(branch).z()) / chordOf(branch).norm();
                    ++count;
                }
            }
        }
        return sum / count;
    };
    for (double DepthOptions::*limit : {&DepthOptions::lengthMagnification, &DepthOptions::angleMagnification,
                                        &DepthOptions::hullMagnification}) {
        const auto at = [&](double factor) {
            DepthOptions options{.secondTree = false};
            options.*limit = factor;
            return depth(options);
        };
        const double usual = at(1.2);
        QVERIFY(at(0.5) < 0.95 * usual);
        QVERIFY(at(2.0) >= usual);
    }
}

void DepthInferenceTest::sideways_holdsUnlessGivenUp()
{
    int kept = 0;
    bool isSteep = false;
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed));
        for (const PlacedBranch& branch : inferDepth(drawn).branches) {
            if (branch.order == 0 || branch.broken.sideways)
                continue;
            const Eigen::Vector3d chord = chordOf(branch);
            const double aside = branch.isTurned ? chord.z() : chord.x();
            const double ahead = branch.isTurned ? chord.x() : chord.z();
            QVERIFY(std::abs(ahead) <= std::abs(aside) + 1e-6);
            ++kept;
        }
        const DepthOptions free{.sideways = DepthOptions::Sideways::None};
        for (const PlacedBranch& branch : inferDepth(drawn, free).branches) {
            QVERIFY(!branch.broken.sideways);
            isSteep = isSteep ||
                      (!branch.isTurned && std::abs(chordOf(branch).z()) > std::abs(chordOf(branch).x()));
        }
    }
    QVERIFY(kept > kDrawings * 70);
    QVERIFY(isSteep); // The rule is not just a habit
}

void DepthInferenceTest::impossibleDrawing_keepsEachBranch()
{
    // No hull, no longer lengths and no wider angles than a tenth of those drawn.
    const SketchedTree drawn = drawing(3);
    const PlacedTree tree =
        inferDepth(drawn, {.hullMagnification = 0.1, .lengthMagnification = 0.1, .angleMagnification = 0.1});
    QCOMPARE(tree.branches.size(), 2 * drawn.branches().size() - 1);
    int broken = 0;
    for (const PlacedBranch& branch : tree.branches) {
        QVERIFY(branch.line.back().allFinite());
        broken += branch.broken.any() ? 1 : 0;
    }
    QVERIFY(broken > 60);
}

void DepthInferenceTest::branches_areFartherApartThanAtRandom()
{
    double placed = 0.0;
    double random = 0.0;
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed), 24);
        PlacedTree tree = inferDepth(drawn, {.secondTree = false});
        placed += meanSeparation(tree);
        // Tips at random depths under the sideways rule; bases on their parents.
        Random numbers(static_cast<std::uint64_t>(seed), 0, 0, Purpose::Texture);
        for (std::size_t i = 1; i < tree.branches.size(); ++i) {
            PlacedBranch& branch = tree.branches[i];
            const PlacedBranch& parent = tree.branches[*branch.parent];
            branch.line.front().z() =
                parent.line.front().z() + branch.along * (parent.line.back().z() - parent.line.front().z());
            branch.line.back().z() =
                branch.line.front().z() + numbers.uniform(-1.0, 1.0) * std::abs(chordOf(branch).x());
        }
        random += meanSeparation(tree);
    }
    QVERIFY2(placed > 1.1 * random, qPrintable(QStringLiteral("%1, %2").arg(placed).arg(random)));
}

void DepthInferenceTest::secondTree_keepsAwayFromTheFirst()
{
    // The only limb of the first tree takes one of the limits of the sideways rule; of those of the second,
    // one is at the same place, seen from above, and the other at a right angle to it.
    const std::vector<SketchStroke> strokes{openStroke({{0.0, 0.0}, {0.0, 4.0}}),
                                            openStroke({{0.0, 2.0}, {2.0, 3.0}}),
                                            openStroke({{0.0, 2.5}, {-0.1, 4.5}})};
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        const PlacedTree tree = inferDepth(SketchedTree::ofStrokes(strokes), {.seed = seed});
        std::vector<Eigen::Vector3d> limbs;
        for (const PlacedBranch& branch : tree.branches) {
            if (branch.order == 1 && chordOf(branch).norm() > 2.1)
                limbs.emplace_back(chordOf(branch).x(), 0.0, chordOf(branch).z());
        }
        QCOMPARE(limbs.size(), std::size_t{2});
        QVERIFY(angleOf(limbs[0], limbs[1]) > radians(60.0));
    }

    double aware = 0.0;
    double unaware = 0.0;
    for (int seed = 1; seed <= kDrawings; ++seed) {
        const SketchedTree drawn = drawing(static_cast<std::uint64_t>(seed), 16);
        aware += meanSeparation(inferDepth(drawn));
        unaware += meanSeparation(inferDepth(drawn, {.secondAvoidsFirst = false}));
    }
    QVERIFY2(aware > 1.05 * unaware, qPrintable(QStringLiteral("%1, %2").arg(aware).arg(unaware)));
}

void DepthInferenceTest::limbs_spreadAllAround()
{
    // A trunk with limbs to both sides: seen from above no sector of 60° is empty.
    std::vector<SketchStroke> strokes{openStroke({{0.0, 0.0}, {0.0, 6.0}})};
    for (int i = 0; i < 10; ++i) {
        const double side = i % 2 == 0 ? 1.0 : -1.0;
        strokes.push_back(openStroke({{0.0, 2.0 + 0.35 * i}, {2.0 * side, 2.6 + 0.35 * i}}));
    }
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        std::vector<double> azimuths;
        for (const PlacedBranch& branch :
             inferDepth(SketchedTree::ofStrokes(strokes), {.seed = seed}).branches) {
            if (branch.order == 1)
                azimuths.push_back(std::atan2(chordOf(branch).z(), chordOf(branch).x()));
        }
        QCOMPARE(azimuths.size(), std::size_t{20});
        std::ranges::sort(azimuths);
        double widest = azimuths.front() + 2.0 * std::numbers::pi - azimuths.back();
        for (std::size_t i = 1; i < azimuths.size(); ++i)
            widest = std::max(widest, azimuths[i] - azimuths[i - 1]);
        QVERIFY2(widest < radians(60.0), qPrintable(QString::number(degrees(widest))));
    }
}

void DepthInferenceTest::leaves_standOnTheirBranches()
{
    std::vector<SketchStroke> strokes{
        openStroke({{0.0, 0.0}, {0.0, 4.0}}),
        openStroke({{0.0, 2.0}, {2.0, 3.0}}),
        {.kind = SketchStroke::Kind::Closed, .line = {{2.0, 3.0}, {2.4, 3.0}, {2.2, 3.3}}}};
    const PlacedTree tree = inferDepth(SketchedTree::ofStrokes(strokes));
    QCOMPARE(tree.leaves.size(), std::size_t{2});
    for (const PlacedLeaf& leaf : tree.leaves) {
        const PlacedBranch& branch = tree.branches[leaf.branch];
        QCOMPARE(branch.order, 1);
        QCOMPARE(leaf.outline.size(), std::size_t{3});
        QVERIFY((leaf.outline.front() - branch.line.back()).norm() < 1e-9);
        QVERIFY(std::abs(leaf.along - 1.0) < 1e-9);
    }
    QVERIFY(tree.branches[tree.leaves[1].branch].isTurned);
    QVERIFY(std::abs(tree.leaves[1].outline[1].x() - tree.leaves[1].outline[0].x()) < 1e-9);
    QVERIFY(std::abs(tree.leaves[1].outline[1].z() - tree.leaves[1].outline[0].z() - 0.4) < 1e-9);
}

void DepthInferenceTest::radii_comeAlong()
{
    const std::vector<SketchStroke> strokes{openStroke({{-0.2, 0.0}, {-0.1, 4.0}}),
                                            openStroke({{0.2, 0.0}, {0.1, 4.0}}),
                                            openStroke({{0.0, 2.0}, {2.0, 3.0}})};
    const SketchedTree drawn = SketchedTree::ofStrokes(strokes);
    const PlacedTree tree = inferDepth(drawn);
    QVERIFY(!drawn.branches()[0].radii.empty());
    QCOMPARE(tree.branches[0].radii, drawn.branches()[0].radii);
    QVERIFY(tree.branches[1].radii.empty());
}

void DepthInferenceTest::sameInput_givesTheSameTree()
{
    const auto lines = [](const PlacedTree& tree) -> std::vector<std::vector<Eigen::Vector3d>> {
        std::vector<std::vector<Eigen::Vector3d>> result;
        for (const PlacedBranch& branch : tree.branches)
            result.push_back(branch.line);
        return result;
    };
    const SketchedTree drawn = drawing(5);
    QVERIFY(lines(inferDepth(drawn)) == lines(inferDepth(drawn)));
    QVERIFY(lines(inferDepth(drawn)) != lines(inferDepth(drawn, {.seed = 2})));
}

void DepthInferenceTest::nothingOrATrunk_isEnough()
{
    QVERIFY(inferDepth({}).branches.empty());
    SketchedTree drawn;
    drawn.attach(openStroke({{0.0, 0.0}, {0.0, 4.0}}));
    QCOMPARE(inferDepth(drawn).branches.size(), std::size_t{1});
    // Branches along the trunk leave no room beside it.
    drawn.attach(openStroke({{0.0, 4.0}, {0.0, 5.0}}));
    const PlacedTree tree = inferDepth(drawn);
    QCOMPARE(tree.branches.size(), std::size_t{3});
    for (const PlacedBranch& branch : tree.branches)
        QVERIFY(branch.line.back().allFinite());
}

const TestClass<DepthInferenceTest> depthInferenceTest;

} // namespace espalier::test

#include "DepthInferenceTest.moc"
