// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/LeafPlacement.h"

#include <algorithm>

namespace espalier {

namespace {

/// The sine of the angle between the midrib and the view below which the upper side is any.
constexpr double kAlongView = 1e-6;

template <class T>
void addCell(CellChanges<T>& changes, LeafId leaf, const T& before, const T& after)
{
    if (!(before == after))
        changes.push_back({leaf, before, after});
}

} // namespace

std::optional<LeafBlade> bladeOf(std::span<const Eigen::Vector3d> outline, const Eigen::Vector3d& toViewer)
{
    Eigen::Vector3d midrib = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& point : outline) {
        const Eigen::Vector3d reach = point - outline.front();
        if (reach.squaredNorm() > midrib.squaredNorm())
            midrib = reach;
    }
    const double length = midrib.norm();
    if (!(length >= double{kSmallestLeaf}))
        return std::nullopt;
    midrib /= length;
    Eigen::Vector3d upper = toViewer.normalized();
    upper -= upper.dot(midrib) * midrib;
    if (!(upper.norm() > kAlongView))
        upper = midrib.unitOrthogonal();
    upper.normalize();
    Eigen::Matrix3d frame;
    frame.col(0) = midrib.cross(upper);
    frame.col(1) = midrib;
    frame.col(2) = upper;
    return LeafBlade{.frame = Eigen::Quaterniond(frame).normalized().cast<float>(),
                     .length = static_cast<float>(std::min(length, double{kGreatestLeaf}))};
}

LeafRow leafOn(const Tree& tree, const TreeIndex& index, InternodeId id, float along, const LeafBlade& blade)
{
    LeafRow row;
    row.internode = id;
    row.along = along;
    row.rotation = (index.rotation(id).conjugate() * blade.frame).normalized();
    row.length = blade.length;
    row.birth = tree.step();
    return row;
}

bool isLeafPlace(const Tree& tree, const LeafRow& leaf)
{
    return tree.isAlive(leaf.internode) && faults::ofShare(leaf.along) == nullptr &&
           faults::ofRotation(leaf.rotation) == nullptr && faults::ofLeafLength(leaf.length) == nullptr &&
           leaf.length >= kSmallestLeaf && faults::ofLeafKind(leaf.kind) == nullptr;
}

void addLeaf(TreeDelta& delta, const LeafRow& leaf)
{
    if (!delta.rows)
        delta.rows = std::make_shared<TreeRows>();
    LeafRow born = leaf;
    born.birth = delta.stepAfter;
    born.death = kNever;
    delta.rows->leaves.append(born);
    ++delta.bornLeaves.count;
}

void moveLeaf(TreeDelta& delta, const Tree& tree, LeafId leaf, const LeafRow& to)
{
    const LeafColumns& rows = tree.placedLeaves();
    addCell(delta.leaves.internode, leaf, rows.internode[leaf], to.internode);
    addCell(delta.leaves.along, leaf, rows.along[leaf], to.along);
    addCell(delta.leaves.rotation, leaf, rows.rotation[leaf], to.rotation);
    addCell(delta.leaves.length, leaf, rows.length[leaf], to.length);
    addCell(delta.leaves.kind, leaf, rows.kind[leaf], to.kind);
}

void removeLeaf(TreeDelta& delta, const Tree& tree, LeafId leaf)
{
    delta.leaves.death.push_back({leaf, tree.placedLeaves().death[leaf], delta.stepAfter});
}

LeafRow leafRow(const Tree& tree, LeafId leaf)
{
    const LeafColumns& rows = tree.placedLeaves();
    LeafRow row;
    row.internode = rows.internode[leaf];
    row.along = rows.along[leaf];
    row.rotation = rows.rotation[leaf];
    row.length = rows.length[leaf];
    row.kind = rows.kind[leaf];
    row.birth = rows.birth[leaf];
    row.death = rows.death[leaf];
    return row;
}

} // namespace espalier
