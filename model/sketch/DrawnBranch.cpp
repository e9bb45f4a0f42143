// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/DrawnBranch.h"

#include "model/base/Random.h"
#include "model/sketch/CurvePieces.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace espalier {

namespace {

/// Shorter lines are no branches, m.
constexpr float kShortestLine = 1e-3F;
/// A branch that begins nearer than this share of an internode to a node begins at the node.
constexpr float kAtNode = 0.02F;

float lengthOfLine(const std::vector<Vec3>& line)
{
    float length = 0.0F;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    return length;
}

/// Moves the first point to @p base, and the others the less the farther they are from it.
void moveBase(std::vector<Vec3>& line, const Vec3& base)
{
    const float length = lengthOfLine(line);
    const Vec3 shift = base - line.front();
    float passed = 0.0F;
    Vec3 last = line.front();
    for (Vec3& point : line) {
        passed += (point - last).norm();
        last = point;
        if (length > 0.0F)
            point += (1.0F - passed / length) * shift;
    }
    line.front() = base;
}

/// The longest side of the box around the nodes of the living wood, m.
float woodSize(const Tree& tree, const TreeIndex& index)
{
    Box3 box;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            box.extend(index.nodePosition(id));
    }
    return box.sizes().maxCoeff();
}

float radiusOn(const std::vector<float>& radii, float share)
{
    const float place = share * static_cast<float>(radii.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(place), radii.size() - 1);
    const std::size_t above = std::min(below + 1, radii.size() - 1);
    return std::lerp(radii[below], radii[above], place - static_cast<float>(below));
}

/// The slot that a branch beside the axis takes: an adventitious one without a bud or a child, or the last
/// one.
int freeSlot(const Tree& tree, const TreeIndex& index, InternodeId parent)
{
    int slot = kFirstAdventitiousSlot;
    const auto isTaken = [&](int candidate) {
        for (InternodeId child = index.firstChild(parent); child != kNoInternode;
             child = index.nextSibling(child)) {
            if (tree.columns().slot[child] == candidate)
                return true;
        }
        return tree.budStates(parent).state(candidate) != BudState::None;
    };
    while (slot < kBudSlots - 1 && isTaken(slot))
        ++slot;
    return slot;
}

Error drawnError(const QString& message)
{
    return {Error::Kind::Input, message};
}

} // namespace

Vec3 positionOf(const Tree& tree, const TreeIndex& index, const BranchPlace& place)
{
    return index.nodePosition(place.internode) -
           (1.0F - place.along) * tree.length(place.internode) * index.heading(place.internode);
}

std::optional<Attachment> nearestAttachment(const Tree& tree, const TreeIndex& index,
                                            const Projection& projection, const Eigen::Vector2d& first,
                                            const Eigen::Vector2d& last,
                                            const std::function<bool(InternodeId)>& isWood)
{
    std::optional<Attachment> nearest;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || (isWood && !isWood(id)))
            continue;
        const std::optional<Eigen::Vector2d> from = projection(index.basePosition(tree, id));
        const std::optional<Eigen::Vector2d> to = projection(index.nodePosition(id));
        if (!from || !to)
            continue;
        const Eigen::Vector2d way = *to - *from;
        const double square = way.squaredNorm();
        for (const bool isLast : {false, true}) {
            const Eigen::Vector2d& end = isLast ? last : first;
            const double along = square > 0.0 ? std::clamp((end - *from).dot(way) / square, 0.0, 1.0) : 1.0;
            const double distance = (end - *from - along * way).norm();
            if (!nearest || distance < nearest->distance)
                nearest = {{id, static_cast<float>(along)}, isLast, distance};
        }
    }
    return nearest;
}

Result<TreeDelta> growDrawnBranch(const Tree& tree, const TreeIndex& index, DrawnBranch branch,
                                  double internodeLength)
{
    const bool isTrunk = !branch.base;
    if (isTrunk && index.livingCount() > 1)
        return drawnError(SketchText::tr("a trunk can only be drawn where nothing has grown"));
    BranchPlace base = branch.base.value_or(BranchPlace());
    if (!tree.isAlive(base.internode))
        return drawnError(SketchText::tr("the wood that it would grow from is gone"));
    if (base.along > 1.0F - kAtNode)
        base.along = 1.0F;
    if (lengthOfLine(branch.line) < kShortestLine)
        return drawnError(SketchText::tr("the stroke has no length"));
    moveBase(branch.line, isTrunk ? Vec3(branch.line.front().x(), 0.0F, branch.line.front().z())
                                  : positionOf(tree, index, base));
    const float length = lengthOfLine(branch.line);
    if (length < kShortestLine) // It was drawn to its base
        return drawnError(SketchText::tr("the stroke has no length"));
    for (const Vec3& point : branch.line) {
        const float farthest = isTrunk ? kFarthestRoot : kFarthestNode;
        if (!point.allFinite() || point.cwiseAbs().maxCoeff() > farthest || length > kGreatestLength)
            return drawnError(SketchText::tr("the stroke is longer than %1 m, or more than %2 m away")
                                  .arg(static_cast<double>(kGreatestLength))
                                  .arg(static_cast<double>(farthest)));
    }

    std::vector<Eigen::Vector3d> curve;
    for (const Vec3& point : branch.line)
        curve.emplace_back(point.cast<double>());
    // A trunk is about as large as the drawing will be.
    const float size = isTrunk ? length : std::max(length, woodSize(tree, index));
    const CurvePieces division =
        curvePieces(curve, std::max(internodeLength, double{length} / kMostCurvePieces),
                    kDrawingTolerance * double{size});
    std::vector<Vec3> ends;
    for (const Eigen::Vector3d& end : division.ends)
        ends.emplace_back(end.cast<float>());
    const std::size_t pieces = ends.size() - 1;
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    delta.born.count = static_cast<std::uint32_t>(isTrunk ? pieces - 1 : pieces);
    delta.rows = std::make_shared<TreeRows>();
    const auto laterals = static_cast<BudMask>((1U << tree.parameters().growth.lateralsPerNode) - 1U);
    InternodeId parent = base.internode;
    InternodeKey key = tree.key(parent);
    Placement below{ends.front(), isTrunk ? Rotation(Rotation::Identity()) : index.rotation(parent)};
    for (std::size_t i = 0; i < pieces; ++i) {
        Vec3 way = below.rotation.conjugate() * Vec3(ends[i + 1] - below.node);
        const float shortest = kShortestLine / static_cast<float>(kMostCurvePieces);
        const float pieceLength = std::max(way.norm(), shortest);
        if (way.norm() < shortest) // The line turns back on itself
            way = Vec3::UnitY();
        const Rotation local =
            Rotation(Eigen::Quaternionf::FromTwoVectors(Vec3(Vec3::UnitY()), way)).normalized();
        const BudStates buds =
            BudStates::active(static_cast<BudMask>(i + 1 == pieces ? laterals | kTerminalBud : laterals));
        const bool isSeedling = isTrunk && i == 0;
        InternodeId id = 0;
        if (isSeedling) {
            delta.addFrame(id, tree.columns().rotation[id], local, tree.length(id), pieceLength);
            if (tree.budStates(id) != buds)
                delta.internodes.buds.push_back({id, tree.budStates(id), buds});
            const std::optional<Vec3> foot(ends.front());
            if (tree.content().sparse.rootPosition.at(id) != foot)
                delta.sparse.rootPosition.push_back({id, tree.content().sparse.rootPosition.at(id), foot});
        } else {
            const bool isFirst = i == 0;
            const bool continues =
                !isFirst || (base.along == 1.0F && index.mainChild(parent) == kNoInternode);
            const int slot = continues ? kTerminalSlot : freeSlot(tree, index, parent);
            if (isFirst && continues && (tree.budStates(parent).living & kTerminalBud) != 0) {
                BudStates rest = tree.budStates(parent);
                rest.living = static_cast<BudMask>(rest.living & ~kTerminalBud);
                rest.other = static_cast<BudMask>(rest.other & ~kTerminalBud);
                delta.internodes.buds.push_back({parent, tree.budStates(parent), rest});
            }
            key = childKey(key, slot, delta.stepAfter);
            id = delta.born.first + delta.rows->internodes.size();
            delta.rows->internodes.append(
                {.parent = parent,
                 .along = isFirst ? base.along : 1.0F,
                 .rotation = local,
                 .length = pieceLength,
                 .vigour = 1.0F,
                 .slot = static_cast<std::uint8_t>(slot),
                 .buds = buds,
                 .birth = delta.stepAfter,
                 .parameterSet = static_cast<std::uint16_t>(tree.currentParameterSet()),
                 .key = key});
        }
        if (!branch.radii.empty()) {
            const auto share = static_cast<float>(division.shares[i + 1]);
            const float diameter = std::min(2.0F * radiusOn(branch.radii, share), kGreatestDiameter);
            if (diameter > 0.0F && tree.content().sparse.width.at(id) != diameter)
                delta.sparse.width.push_back({id, tree.content().sparse.width.at(id), diameter});
        }
        below = placeOn(below.node, below.rotation, local, pieceLength);
        parent = id;
    }
    return delta;
}

} // namespace espalier
