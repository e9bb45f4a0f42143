// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/TreeReproduction.h"

#include "model/sketch/BranchAxis.h"
#include "model/sketch/CrownHull.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace espalier {

namespace {

/// Of a silhouette's hull, in areas of its box.
constexpr double kLeastArea = 1e-6;

/// Internodes of a trunk are at least this long, m.
constexpr double kShortestOfTrunk = 1e-5;
/// Limbs become at most this many diagonals of the hull long.
constexpr double kLongestLimb = 2.0;
/// Scaled internodes are at least this long, m.
constexpr double kShortestScaled = 1e-6;

Eigen::Vector3d onDrawing(const Eigen::Vector2d& point)
{
    return {point.x(), point.y(), 0.0};
}

/// The seedling's tree while it gets its new figure. Places are relative to the base of the trunk. The world
/// is turned so that the drawing faces +Z.
class NewFigure {
public:
    NewFigure(const Tree& tree, const TreeIndex& index, const CrownHull& hull, double azimuth)
        : m_tree(tree),
          m_index(index),
          m_hull(hull),
          m_toWorld(Eigen::AngleAxisd(azimuth, Eigen::Vector3d::UnitY())),
          m_longest(kLongestLimb * diagonalOf(hull)),
          m_nodes(tree.size(), Eigen::Vector3d::Zero()),
          m_rotations(tree.size(), Eigen::Quaterniond::Identity()),
          m_lengths(tree.size(), 0.0),
          m_ratios(tree.size(), 0.0),
          m_isPart(tree.size(), false)
    {
    }

    void drawTrunk(const SketchLine& stroke);
    void drawBranches();
    Result<Reproduction> finish();

private:
    /// A branch as it begins in the new figure.
    struct Start {
        Eigen::Vector3d base; ///< m
        Eigen::Vector3d way;  ///< From base to tip while it has its old length, m
        double length;        ///< The old one, arc length, m
    };

    static double diagonalOf(const CrownHull& hull)
    {
        const Eigen::AlignedBox2d footprint = hull.footprint();
        return Eigen::Vector2d(hull.top() - hull.bottom(), footprint.diagonal().norm()).norm();
    }
    bool isTrunk(InternodeId id) const { return m_index.axis(id) == 0; }
    Start startOf(InternodeId branch) const;
    double limbRatio(const Start& start);
    double farthestInHull(const Start& start, double most) const;
    void place(InternodeId branch, const Start& start, double ratio);

    const Tree& m_tree;
    const TreeIndex& m_index;
    const CrownHull& m_hull;
    Eigen::Quaterniond m_toWorld; ///< From the turned world
    double m_longest;             ///< m
    std::vector<Eigen::Vector3d> m_nodes;
    std::vector<Eigen::Quaterniond> m_rotations; ///< In the turned world
    std::vector<double> m_lengths;
    std::vector<double> m_ratios; ///< By branch: new length of the limb that carries it, divided by its old
    std::vector<bool> m_isPart;   ///< Living internodes of the tree
    Reproduction m_result{.delta = {}, .outside = 0};
};

void NewFigure::drawTrunk(const SketchLine& stroke)
{
    const BranchAxis axis(m_tree, m_index, 0);
    Eigen::Vector3d node = Eigen::Vector3d::Zero();
    Eigen::Vector3d heading;
    Eigen::Quaterniond frame = m_toWorld.conjugate() * axis.frame(0);
    for (std::size_t i = 0; i < axis.internodes().size(); ++i) {
        const InternodeId id = axis.internodes()[i];
        const double share = axis.distanceOf({.number = i, .along = 1.0F}) / axis.length();
        const Eigen::Vector3d end = onDrawing(pointAlong(stroke, share) - stroke.front());
        const Eigen::Vector3d way = end - node;
        const double length = std::max(way.norm(), kShortestOfTrunk);
        const Eigen::Vector3d before =
            i == 0 ? Eigen::Vector3d(frame * Eigen::Vector3d(Eigen::Vector3d::UnitY())) : heading;
        heading = way.norm() < kShortestOfTrunk ? before : Eigen::Vector3d(way.normalized());
        frame = (Eigen::Quaterniond::FromTwoVectors(before, heading) * frame).normalized();
        node += length * heading;
        // The internode's roll against the turtle stays.
        m_rotations[id] =
            (frame * axis.frame(i).conjugate() * m_index.rotation(id).cast<double>()).normalized();
        m_nodes[id] = node;
        m_lengths[id] = length;
        m_isPart[id] = true;
    }
}

void NewFigure::drawBranches()
{
    // Parents come before their children.
    std::vector<InternodeId> branches;
    for (InternodeId id = 1; id < m_tree.size(); ++id) {
        const InternodeId parent = m_tree.parent(id);
        if (m_isPart[id] || !m_tree.isAlive(id) || parent == kNoInternode || !m_isPart[parent])
            continue;
        m_isPart[id] = true;
        m_rotations[id] = (m_rotations[parent] * m_tree.columns().rotation[id].cast<double>()).normalized();
        if (m_index.axis(id) == id)
            branches.push_back(id);
    }
    for (const InternodeId branch : branches) {
        const InternodeId parent = m_tree.parent(branch);
        const Start start = startOf(branch);
        double ratio = 0.0;
        if (isTrunk(parent)) {
            ratio = limbRatio(start);
            m_ratios[branch] = ratio;
        } else {
            ratio = m_ratios[m_index.axis(parent)];
            m_ratios[branch] = ratio;
            if (!m_hull.contains(start.base)) {
                ++m_result.outside;
                ratio = std::min(ratio, kShrunkLimb);
            } else if (!m_hull.contains(start.base + ratio * start.way)) {
                ratio = farthestInHull(start, ratio);
            }
        }
        place(branch, start, ratio);
    }
}

NewFigure::Start NewFigure::startOf(InternodeId branch) const
{
    const InternodeId parent = m_tree.parent(branch);
    const double below = (1.0 - double{m_tree.columns().along[branch]}) * m_lengths[parent];
    Start start{.base = m_nodes[parent] -
                        below * (m_rotations[parent] * Eigen::Vector3d(Eigen::Vector3d::UnitY())),
                .way = Eigen::Vector3d::Zero(),
                .length = 0.0};
    for (InternodeId id = branch; id != kNoInternode; id = m_index.mainChild(id)) {
        start.way +=
            double{m_tree.length(id)} * (m_rotations[id] * Eigen::Vector3d(Eigen::Vector3d::UnitY()));
        start.length += double{m_tree.length(id)};
    }
    return start;
}

/// New length of a limb, divided by the old one: its tip touches the hull.
double NewFigure::limbRatio(const Start& start)
{
    if (!m_hull.contains(start.base)) {
        ++m_result.outside;
        return kShrunkLimb;
    }
    const double most = m_longest / start.length;
    // A limb can be so curled that no sensible length takes it to the hull.
    if (m_hull.contains(start.base + most * start.way))
        return most;
    return farthestInHull(start, most);
}

/// The greatest ratio up to @p most with which the tip is in the hull. The hull is convex, so it contains the
/// way from the base to there. Precondition: the base is in the hull, and with @p most the tip is not.
double NewFigure::farthestInHull(const Start& start, double most) const
{
    double inside = 0.0;
    double outside = most;
    for (int i = 0; i < 60 && outside - inside > 1e-9 * most; ++i) {
        const double middle = 0.5 * (inside + outside);
        (m_hull.contains(start.base + middle * start.way) ? inside : outside) = middle;
    }
    return inside;
}

void NewFigure::place(InternodeId branch, const Start& start, double ratio)
{
    Eigen::Vector3d node = start.base;
    for (InternodeId id = branch; id != kNoInternode; id = m_index.mainChild(id)) {
        m_lengths[id] = std::max(ratio * double{m_tree.length(id)}, kShortestScaled);
        node += m_lengths[id] * (m_rotations[id] * Eigen::Vector3d(Eigen::Vector3d::UnitY()));
        m_nodes[id] = node;
    }
}

Result<Reproduction> NewFigure::finish()
{
    TreeDelta delta = deltaStartingAt(m_tree);
    const Eigen::Vector3d root = m_tree.rootPosition(0).cast<double>();
    for (InternodeId id = 0; id < m_tree.size(); ++id) {
        if (!m_isPart[id])
            continue;
        if (m_lengths[id] > double{kGreatestLength} ||
            (root + m_toWorld * m_nodes[id]).cwiseAbs().maxCoeff() > double{kFarthestNode})
            return Error{Error::Kind::Input,
                         SketchText::tr("an internode would be longer than %1 m or lie more than %2 m away")
                             .arg(static_cast<double>(kGreatestLength))
                             .arg(static_cast<double>(kFarthestNode))};
        const Rotation before = m_tree.columns().rotation[id];
        Rotation after = before;
        if (isTrunk(id)) {
            const InternodeId parent = m_tree.parent(id);
            const Eigen::Quaterniond below =
                parent == kNoInternode ? Eigen::Quaterniond(m_toWorld.conjugate()) : m_rotations[parent];
            after = Rotation((below.conjugate() * m_rotations[id]).normalized().cast<float>());
        }
        delta.addFrame(id, before, after, m_tree.length(id), static_cast<float>(m_lengths[id]));
    }
    m_result.delta = std::move(delta);
    return std::move(m_result);
}

/// The area that a convex polygon encloses, m².
double areaOf(const SketchLine& corners)
{
    double twice = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d& next = corners[(i + 1) % corners.size()];
        twice += corners[i].x() * next.y() - corners[i].y() * next.x();
    }
    return 0.5 * std::abs(twice);
}

} // namespace

Result<Reproduction> reproduced(const Tree& tree, const TreeIndex& index, const SketchLine& trunk,
                                const SketchLine& silhouette, double azimuth)
{
    if (trunk.size() < 2 || !(lengthOf(trunk) > 0.0))
        return Error{Error::Kind::Input, SketchText::tr("the new trunk has no length")};
    SketchLine stroke = trunk;
    if (stroke.back().y() < stroke.front().y())
        std::ranges::reverse(stroke);
    SketchLine outline;
    Eigen::AlignedBox2d box;
    for (const Eigen::Vector2d& point : silhouette) {
        outline.emplace_back(point - stroke.front());
        box.extend(outline.back());
    }
    if (outline.size() < 3 || !(box.sizes().minCoeff() > 0.0))
        return Error{Error::Kind::Input, SketchText::tr("the silhouette encloses nothing")};
    const CrownHull hull(outline, 1.0);
    if (!(areaOf(hull.corners()) > kLeastArea * box.sizes().prod()))
        return Error{Error::Kind::Input, SketchText::tr("the silhouette encloses nothing")};
    NewFigure figure(tree, index, hull, azimuth);
    figure.drawTrunk(stroke);
    figure.drawBranches();
    return figure.finish();
}

} // namespace espalier
