// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/FlatTree.h"

#include "model/base/Random.h"
#include "model/sketch/LeafPlacement.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_set>

namespace espalier {

namespace {

/// Of a tree's size: how far its nodes may be from the plane of the drawing.
constexpr float kFlatShare = 0.002F;
/// Shorter than all internodes that a drawing has, m.
constexpr float kShortestDrawn = 1e-6F;

Eigen::Vector2d seenFromTheFront(const Vec3& point)
{
    return {double{point.x()}, double{point.y()}};
}

/// The local frame that turns as little as possible from @p local and points along @p way, in the parent's
/// frame.
Rotation turnedTo(const Rotation& local, const Vec3& way)
{
    const Vec3 heading = local * Vec3(Vec3::UnitY());
    return Rotation(Rotation(Eigen::Quaternionf::FromTwoVectors(heading, way)) * local).normalized();
}

/// Moves the nodes of the first tree and lets the second one grow.
class DepthEdit {
public:
    DepthEdit(const Tree& tree, const TreeDrawing& flat, const PlacedTree& placed)
        : m_tree(tree), m_flat(flat), m_placed(placed), m_delta(deltaStartingAt(tree))
    {
        m_delta.stepAfter = m_delta.stepBefore + 1;
        m_delta.rows = std::make_shared<TreeRows>();
        for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf) {
            if (tree.placedLeaves().death[leaf] == kNever)
                m_leaves.emplace(tree.placedLeaves().internode[leaf], leaf);
        }
    }

    TreeDelta make()
    {
        m_worlds.resize(m_placed.branches.size());
        m_rows.resize(m_placed.branches.size());
        m_keys.resize(m_placed.branches.size());
        for (std::size_t i = 0; i < m_placed.branches.size(); ++i) {
            if (m_placed.branches[i].isTurned)
                copyBranch(i);
            else
                moveBranch(i);
        }
        m_delta.born.count = m_delta.rows->internodes.size();
        if (m_delta.born.count == 0 && m_delta.bornLeaves.count == 0)
            m_delta.rows.reset();
        return std::move(m_delta);
    }
    /// Whether something would be longer or farther away than is possible.
    bool isFar() const { return m_isFar; }

private:
    /// The axis of the drawing that a placed branch is.
    const std::vector<InternodeId>& axisOf(std::size_t branch) const
    {
        return m_flat.axes[m_placed.branches[branch].source];
    }

    /// The number on its axis of the internode that carries the branch.
    std::size_t carrierOf(std::size_t branch) const
    {
        const InternodeId parent = m_tree.parent(axisOf(branch).front());
        const std::vector<InternodeId>& axis = axisOf(*m_placed.branches[branch].parent);
        return static_cast<std::size_t>(std::ranges::lower_bound(axis, parent) - axis.begin());
    }

    /// Where the first internode of a branch begins, and the frame that it is attached to.
    Placement baseOf(std::size_t branch) const
    {
        const PlacedBranch& placed = m_placed.branches[branch];
        const InternodeId first = axisOf(branch).front();
        if (!placed.parent)
            return {placed.line.front().cast<float>(), Rotation::Identity()};
        const std::size_t carrier = carrierOf(branch);
        const Placement& end = m_worlds[*placed.parent][carrier];
        const Vec3& node = end.node;
        const Vec3 below = carrier > 0 ? m_worlds[*placed.parent][carrier - 1].node : m_bases[*placed.parent];
        const float along = m_tree.columns().along[first];
        return {Vec3(below + along * (node - below)), end.rotation};
    }

    /// Calls @p visit(number, frame, length) for the internodes of a branch as they are to be.
    template <class Visit>
    void forEachFrame(std::size_t branch, Visit&& visit)
    {
        const std::vector<InternodeId>& axis = axisOf(branch);
        const std::vector<Eigen::Vector3d>& line = m_placed.branches[branch].line;
        Placement below = baseOf(branch);
        m_bases.resize(std::max(m_bases.size(), branch + 1));
        m_bases[branch] = below.node;
        for (std::size_t i = 0; i < axis.size(); ++i) {
            const Vec3 way = below.rotation.conjugate() * Vec3(line[i + 1].cast<float>() - below.node);
            const float length = way.norm();
            const Rotation old = m_tree.columns().rotation[axis[i]];
            const Rotation local = length > kShortestDrawn ? turnedTo(old, way) : old;
            visit(i, local, std::max(length, kShortestDrawn));
            below = placeOn(below.node, below.rotation, local, std::max(length, kShortestDrawn));
            m_isFar = m_isFar || !(length <= kGreatestLength) ||
                      !(below.node.cwiseAbs().maxCoeff() <= kFarthestNode);
            m_worlds[branch].push_back(below);
        }
    }

    void moveBranch(std::size_t branch)
    {
        const std::vector<InternodeId>& axis = axisOf(branch);
        m_rows[branch] = axis;
        for (const InternodeId id : axis)
            m_keys[branch].push_back(m_tree.key(id));
        forEachFrame(branch, [&](std::size_t i, const Rotation& local, float length) {
            const InternodeId id = axis[i];
            m_delta.addFrame(id, m_tree.columns().rotation[id], local, m_tree.length(id), length);
        });
    }

    void copyBranch(std::size_t branch)
    {
        const std::vector<InternodeId>& axis = axisOf(branch);
        const PlacedBranch& placed = m_placed.branches[branch];
        const std::size_t carrier = carrierOf(branch);
        InternodeId parent = m_rows[*placed.parent][carrier];
        InternodeKey key = m_keys[*placed.parent][carrier];
        forEachFrame(branch, [&](std::size_t i, const Rotation& local, float length) {
            const InternodeId source = axis[i];
            const InternodeId id = m_delta.born.first + m_delta.rows->internodes.size();
            const int slot = i == 0 ? kBudSlots - 1 : kTerminalSlot;
            key = childKey(key, slot, i == 0 ? m_delta.stepAfter + m_tree.birth(source) : m_delta.stepAfter);
            // Siblings of one slot can have been born in one step: where branches were copied.
            if (!m_usedKeys.insert(key).second)
                key = mixedBits(key ^ m_tree.key(source));
            const InternodeColumns& c = m_tree.columns();
            m_delta.rows->internodes.append({.parent = parent,
                                             .along = c.along[source],
                                             .rotation = local,
                                             .length = length,
                                             .vigour = c.vigour[source],
                                             .slot = static_cast<std::uint8_t>(slot),
                                             .buds = c.buds[source],
                                             .birth = m_delta.stepAfter,
                                             .parameterSet = c.parameterSet[source],
                                             .key = key});
            if (const float width = m_tree.widthConstraint(source); width > 0.0F)
                m_delta.sparse.width.push_back({id, std::nullopt, width});
            copyLeaves(source, id);
            m_rows[branch].push_back(id);
            m_keys[branch].push_back(key);
            parent = id;
        });
    }

    /// The copy of an internode bears its leaves, in the same frames.
    void copyLeaves(InternodeId source, InternodeId copy)
    {
        const auto [first, last] = m_leaves.equal_range(source);
        for (auto i = first; i != last; ++i) {
            LeafRow row = leafRow(m_tree, i->second);
            row.internode = copy;
            addLeaf(m_delta, row);
        }
    }

    const Tree& m_tree;
    const TreeDrawing& m_flat;
    const PlacedTree& m_placed;
    TreeDelta m_delta;
    std::unordered_set<InternodeKey> m_usedKeys; ///< Of the copies' first internodes
    bool m_isFar = false;
    std::multimap<InternodeId, LeafId> m_leaves;   ///< That live, by the internode that bears them
    std::vector<Vec3> m_bases;                     ///< By placed branch, m
    std::vector<std::vector<Placement>> m_worlds;  ///< By placed branch and internode
    std::vector<std::vector<InternodeId>> m_rows;  ///< In the same way
    std::vector<std::vector<InternodeKey>> m_keys; ///< In the same way
};

Error depthError(const QString& message)
{
    return {Error::Kind::Input, message};
}

bool hasOtherRoots(const Tree& tree, const TreeIndex& index)
{
    return std::ranges::any_of(index.roots(), [&](InternodeId id) { return id != 0 && tree.isAlive(id); });
}

} // namespace

bool isFlat(const Tree& tree, const TreeIndex& index)
{
    Box3 box;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            box.extend(index.nodePosition(id));
    }
    box.extend(tree.rootPosition(0));
    const float size = Vec2(box.sizes().x(), box.sizes().y()).norm();
    return std::max(std::abs(box.min().z()), std::abs(box.max().z())) <= kFlatShare * size;
}

TreeDrawing drawingOf(const Tree& tree, const TreeIndex& index)
{
    TreeDrawing result;
    std::vector<SketchId> branchOf(tree.size(), 0); // By internode
    std::vector<SketchedBranch> branches;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || index.axis(id) != id || index.rootOf(tree, id) != 0)
            continue;
        const auto branch = static_cast<SketchId>(branches.size());
        SketchedBranch drawn{.id = branch, .parent = std::nullopt, .along = 0.0, .line = {}, .radii = {}};
        drawn.line.push_back(seenFromTheFront(index.basePosition(tree, id)));
        std::vector<InternodeId>& axis = result.axes.emplace_back();
        for (InternodeId on = id; on != kNoInternode; on = index.mainChild(on)) {
            drawn.line.push_back(seenFromTheFront(index.nodePosition(on)));
            axis.push_back(on);
            branchOf[on] = branch;
        }
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode) {
            drawn.parent = branchOf[parent];
            const SketchedBranch& carrier = branches[branchOf[parent]];
            const std::vector<InternodeId>& below = result.axes[branchOf[parent]];
            const auto number =
                static_cast<std::size_t>(std::ranges::lower_bound(below, parent) - below.begin());
            const std::vector<double> shares = arcShares(carrier.line);
            drawn.along = std::lerp(shares[number], shares[number + 1], double{tree.columns().along[id]});
        }
        branches.push_back(std::move(drawn));
    }
    result.drawing = SketchedTree::ofBranches(std::move(branches));
    return result;
}

Result<TreeDelta> giveDepth(const Tree& tree, const TreeIndex& index, const DepthOptions& options)
{
    if (hasOtherRoots(tree, index))
        return depthError(SketchText::tr("only a tree with one root can be given depth"));
    if (!isFlat(tree, index))
        return depthError(SketchText::tr("the tree has depth already"));
    const TreeDrawing flat = drawingOf(tree, index);
    if (flat.axes.size() < 2)
        return depthError(SketchText::tr("draw branches first: a trunk alone has no depth to find"));
    const PlacedTree placed = inferDepth(flat.drawing, options);
    DepthEdit edit(tree, flat, placed);
    TreeDelta delta = edit.make();
    if (edit.isFar())
        return depthError(SketchText::tr("an internode would be longer than %1 m or lie more than %2 m away")
                              .arg(static_cast<double>(kGreatestLength))
                              .arg(static_cast<double>(kFarthestNode)));
    return delta;
}

} // namespace espalier
