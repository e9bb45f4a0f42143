// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchPropagation.h"

#include "model/sketch/BranchAxis.h"
#include "model/sketch/BranchCopy.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace espalier {

namespace {

/// A placed leaf on the reference.
struct ReferenceLeaf {
    LeafId id;
    BranchAxis::Place place;
    double distance; ///< From the base, m
};

/// What the reference carries.
struct ReferenceBranch {
    BranchAxis axis;
    std::vector<ChildBranch> children;
    std::vector<ReferenceLeaf> leaves;
};

ReferenceBranch referenceAt(const Tree& tree, const TreeIndex& index, const BranchCopies& copies,
                            InternodeId id)
{
    ReferenceBranch reference{.axis = BranchAxis(tree, index, id), .children = {}, .leaves = {}};
    reference.children = childBranches(tree, index, reference.axis);
    for (std::size_t i = 0; i < reference.axis.internodes().size(); ++i) {
        for (const auto& [internode, leaf] : copies.leavesOf(reference.axis.internodes()[i])) {
            const BranchAxis::Place place{i, tree.placedLeaves().along[leaf]};
            reference.leaves.push_back(
                {.id = leaf, .place = place, .distance = reference.axis.distanceOf(place)});
        }
    }
    return reference;
}

/// Ids of the axes that get copies, ascending.
std::vector<InternodeId> targetAxes(const Tree& tree, const TreeIndex& index, const Propagation& propagation)
{
    const InternodeId reference = index.axis(propagation.reference);
    std::vector<InternodeId> targets;
    if (propagation.targets == Propagation::Targets::Listed) {
        for (const InternodeId id : propagation.axes) {
            if (tree.isAlive(id) && index.axis(id) != reference)
                targets.push_back(index.axis(id));
        }
        std::ranges::sort(targets);
        targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
        return targets;
    }
    std::vector<std::uint32_t> order(tree.size(), 0);
    std::vector<bool> isOnReference(tree.size(), false);
    std::vector<InternodeId> others;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        const InternodeId parent = tree.parent(id);
        if (parent != kNoInternode) {
            order[id] = order[parent] + (tree.continuesAxis(id) ? 0U : 1U);
            isOnReference[id] = isOnReference[parent];
        }
        isOnReference[id] = isOnReference[id] || id == reference;
        if (tree.isAlive(id) && parent != kNoInternode && index.axis(id) == id && !isOnReference[id])
            others.push_back(id);
    }
    for (const InternodeId id : others) {
        if (propagation.targets == Propagation::Targets::All || order[id] == order[reference])
            targets.push_back(id);
    }
    return targets;
}

/// Removes what @p target carries, apart from the branches that carry the reference, which are @p kept.
void clearTarget(const Tree& tree, const TreeIndex& index, const std::vector<InternodeId>& kept,
                 const BranchAxis& target, BranchCopies& copies)
{
    for (const ChildBranch& child : childBranches(tree, index, target)) {
        if (!std::ranges::binary_search(kept, child.id))
            copies.remove(child.id);
    }
    for (const InternodeId id : target.internodes()) {
        for (const auto& [internode, leaf] : copies.leavesOf(id))
            copies.removeLeaf(leaf);
    }
}

/// Copies all that the reference carries to one target.
class CopyToTarget {
public:
    CopyToTarget(const TreeIndex& index, const ReferenceBranch& reference, const BranchAxis& target,
                 bool scaling)
        : m_index(index),
          m_reference(reference),
          m_target(target),
          m_scaling(scaling),
          m_scale(scaling ? target.length() / reference.axis.length() : 1.0)
    {
    }

    void copy(const Tree& tree, BranchCopies& copies) const
    {
        for (const ChildBranch& child : m_reference.children) {
            const std::optional<BranchAxis::Place> place = placeOf(child.distance);
            if (!place)
                continue;
            const InternodeId parent = m_target.internodes()[place->number];
            copies.add(child.id, {.parent = parent,
                                  .along = place->along,
                                  .rotation = rotationOn(*place, child.place, m_index.rotation(child.id)),
                                  .scale = m_scale});
        }
        for (const ReferenceLeaf& leaf : m_reference.leaves) {
            const std::optional<BranchAxis::Place> place = placeOf(leaf.distance);
            if (!place)
                continue;
            const InternodeId bearer = m_reference.axis.internodes()[leaf.place.number];
            const Rotation world = m_index.rotation(bearer) * tree.placedLeaves().rotation[leaf.id];
            copies.addLeaf(leaf.id, m_target.internodes()[place->number], place->along,
                           rotationOn(*place, leaf.place, world), m_scale);
        }
    }

private:
    std::optional<BranchAxis::Place> placeOf(double distance) const
    {
        const double there =
            m_scaling ? m_scale * distance : m_target.length() - (m_reference.axis.length() - distance);
        if (there < 0.0)
            return std::nullopt;
        return m_target.at(there);
    }

    /// The rotation, in the frame of the target's internode at a place, of what has the rotation @p world at
    /// a place of the reference.
    Rotation rotationOn(const BranchAxis::Place& place, const BranchAxis::Place& onReference,
                        const Rotation& world) const
    {
        const InternodeId parent = m_target.internodes()[place.number];
        const Eigen::Quaterniond there = m_target.frame(place.number) *
                                         m_reference.axis.frame(onReference.number).conjugate() *
                                         world.cast<double>();
        const Eigen::Quaterniond local = m_index.rotation(parent).cast<double>().conjugate() * there;
        return Rotation(local.normalized().cast<float>());
    }

    const TreeIndex& m_index;
    const ReferenceBranch& m_reference;
    const BranchAxis& m_target;
    bool m_scaling;
    double m_scale;
};

} // namespace

Result<TreeDelta> propagated(const Tree& tree, const TreeIndex& index, const Propagation& propagation)
{
    const InternodeId id = propagation.reference;
    if (!tree.isAlive(id))
        return Error{Error::Kind::Input, SketchText::tr("internode %1 is not alive").arg(id)};
    BranchCopies copies(tree, index);
    const ReferenceBranch reference = referenceAt(tree, index, copies, id);
    if (reference.children.empty() && reference.leaves.empty())
        return Error{Error::Kind::Input,
                     SketchText::tr("the branch of internode %1 carries nothing to copy").arg(id)};
    if (propagation.targets == Propagation::Targets::Listed &&
        propagation.axes.size() > Propagation::kMostListed)
        return Error{Error::Kind::Input,
                     SketchText::tr("more than %1 branches are listed").arg(Propagation::kMostListed)};
    const std::vector<InternodeId> targets = targetAxes(tree, index, propagation);
    if (targets.empty())
        return Error{Error::Kind::Input, SketchText::tr("there is no other branch to copy to")};
    std::vector<InternodeId> kept; // The reference and what carries it
    for (InternodeId on = index.axis(id); on != kNoInternode; on = tree.parent(on))
        kept.push_back(on);
    std::ranges::reverse(kept); // Ascending
    for (const InternodeId target : targets) {
        if (copies.isRemoved(target))
            continue;
        const BranchAxis axis(tree, index, target);
        if (propagation.replaces)
            clearTarget(tree, index, kept, axis, copies);
        CopyToTarget(index, reference, axis, propagation.scaling).copy(tree, copies);
    }
    Result<TreeDelta> delta = copies.finish();
    if (delta && delta->isEmpty())
        return Error{Error::Kind::Input,
                     SketchText::tr("all other branches are too short for what the branch of internode %1 "
                                    "carries")
                         .arg(id)};
    return delta;
}

} // namespace espalier
