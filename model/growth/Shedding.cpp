// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/Shedding.h"

#include "model/growth/GrowthIndex.h"

namespace espalier {

namespace {

/// A new branch is in the shadow of older ones for some steps, until its own buds contribute; without this it
/// would be shed at once.
constexpr Step kSparedSteps = 4;

constexpr std::uint8_t kSpared = 1;
constexpr std::uint8_t kCandidate = 2;
constexpr std::uint8_t kShed = 3;

} // namespace

void shedBranches(GrowingTree& growing, const GrowthIndex& growth, VigourFlow& flow,
                  const std::vector<InternodeId>& growingAt, GrowthWorkspace& workspace)
{
    const Tree& tree = growing.tree();
    const TreeIndex& index = growing.index();
    const double threshold = tree.parameters().growth.shedding;
    if (threshold <= 0.0)
        return;

    StampedColumn<std::uint8_t>& marks = workspace.marks; // of axes, by their first internode
    marks.clear(tree.size());
    for (const InternodeId root : index.roots())
        marks.set(root, kSpared);
    for (InternodeId node : growingAt) {
        for (InternodeId axis = index.axis(node); marks.setOnce(axis, kSpared);
             axis = index.axis(tree.parent(axis))) {
        }
    }
    std::vector<InternodeId> candidates;
    growth.space().forEachShaded(growing.newCells(growth.space()), [&](VoxelSpace::Residents residents) {
        for (const InternodeId id : residents) {
            for (InternodeId axis = index.axis(id); marks.setOnce(axis, kCandidate);
                 axis = index.axis(tree.parent(axis)))
                candidates.push_back(axis);
        }
    });

    std::ranges::sort(candidates); // parents come before their children
    std::vector<InternodeId> branch;
    for (const InternodeId axis : candidates) {
        const InternodeId bearer = index.axis(tree.parent(axis));
        if (marks.has(bearer) && marks[bearer] == kShed) {
            marks.set(axis, kShed);
            continue;
        }
        if (tree.step() + 1 < tree.birth(axis) + kSparedSteps || index.isPlacedByHand(tree, axis) ||
            flow.perInternode(axis) >= threshold)
            continue;
        branch.assign(1, axis);
        while (!branch.empty()) {
            const InternodeId id = branch.back();
            branch.pop_back();
            growing.kill(id);
            marks.set(index.axis(id), kShed);
            for (InternodeId child = index.firstChild(id); child != kNoInternode;
                 child = index.nextSibling(child))
                branch.push_back(child);
        }
    }
}

} // namespace espalier
