// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/import/SkeletonTree.h"
#include "model/io/import/SketchSkeleton.h"
#include "model/sketch/BranchAxis.h"
#include "tests/model/sketch/DrawnTrees.h"
#include "tests/support/TreeBuilder.h"

#include <QTest>

namespace espalier::test {

/// A tree that was drawn, with branches between the nodes of others.
inline TreeBuilder treeOfDrawing(std::uint64_t seed, int strokes)
{
    TreeBuilder builder(seed);
    Result<TreeDelta> delta = growSkeleton(
        builder.tree,
        skeletonOf(inferDepth(SketchedTree::ofStrokes(drawnTree(seed, strokes)), {.seed = seed}), 0.1));
    if (!delta)
        qFatal("%s", qPrintable(delta.error().message));
    builder.apply(std::move(*delta));
    return builder;
}

/// Random trees and drawn ones, with placed leaves, widths, twists and dead branches.
inline std::vector<TreeBuilder> branchTrees()
{
    std::vector<TreeBuilder> trees;
    for (std::uint64_t seed = 1; seed <= 6; ++seed)
        trees.push_back(seed % 2 == 0 ? treeOfDrawing(seed, 30) : randomTree(250, seed));
    for (TreeBuilder& builder : trees) {
        std::vector<InternodeId> bearers;
        TreeDelta delta = deltaStartingAt(builder.tree);
        for (InternodeId id = 3; id < builder.tree.size(); id += 7) {
            bearers.push_back(id);
            delta.sparse.width.push_back({id, builder.tree.content().sparse.width.at(id), 0.002F});
            delta.sparse.twist.push_back({id, std::nullopt, 0.3F});
            delta.sparse.clearLength.push_back({id, std::nullopt, 0.05F});
        }
        builder.apply(std::move(delta));
        builder.apply(leafPlacement(builder.tree, bearers));
        builder.apply(leafRemoval(builder.tree, 1));
        builder.apply(death(builder.tree, builder.index, builder.tree.size() / 2));
    }
    return trees;
}

/// The living axes but for the trunks.
inline std::vector<InternodeId> branchesOf(const TreeBuilder& builder)
{
    std::vector<InternodeId> branches;
    for (InternodeId id = 1; id < builder.tree.size(); ++id) {
        if (builder.tree.isAlive(id) && builder.index.axis(id) == id && !builder.tree.isRoot(id))
            branches.push_back(id);
    }
    return branches;
}

inline std::vector<ChildBranch> childrenOf(const TreeBuilder& builder, InternodeId id)
{
    return childBranches(builder.tree, builder.index, BranchAxis(builder.tree, builder.index, id));
}

/// The living internodes of a branch, each after the one that carries it, children by ascending id.
inline std::vector<InternodeId> internodesOf(const TreeBuilder& builder, InternodeId branch)
{
    std::vector<InternodeId> all{branch};
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (InternodeId child = builder.index.firstChild(all[i]); child != kNoInternode;
             child = builder.index.nextSibling(child))
            all.push_back(child);
    }
    return all;
}

/// What is wrong with a tree that has followed @p delta, or with its index, or with the tree after the delta
/// is reverted; the delta stays applied. Empty if nothing is.
inline QString deltaFault(TreeBuilder& builder, TreeDelta delta)
{
    const Tree before = builder.tree;
    builder.apply(std::move(delta));
    const Tree after = builder.tree;
    if (const QString fault = treeFault(after.content()); !fault.isEmpty())
        return fault;
    const TreeIndex fresh(after);
    for (InternodeId id = 0; id < after.size(); ++id) {
        if (fresh.subtreeSize(id) != builder.index.subtreeSize(id) ||
            fresh.nodePosition(id) != builder.index.nodePosition(id) ||
            fresh.firstChild(id) != builder.index.firstChild(id))
            return QStringLiteral("the index of internode %1 differs from a new one").arg(id);
    }
    TreeDelta reverted = builder.revert();
    if (!(builder.tree == before))
        return QStringLiteral("the tree is another one after the delta was reverted");
    builder.apply(std::move(reverted));
    return builder.tree == after ? QString() : QStringLiteral("the delta does not come back");
}

inline QString messageOf(const Result<TreeDelta>& result)
{
    return result ? QString() : result.error().message;
}

} // namespace espalier::test
