// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Documents.h"

#include "model/document/Edit.h"
#include "model/growth/IndexedModel.h"

#include <algorithm>

namespace espalier::test {

namespace {

QString at(const char* what, InternodeId id)
{
    return QStringLiteral("%1 of internode %2").arg(QLatin1String(what)).arg(id);
}

std::vector<InternodeId> residents(const VoxelSpace& space, const Cell& voxel)
{
    std::vector<InternodeId> result;
    space.anyRun(voxel, voxel, [&](VoxelSpace::Residents run) {
        result.insert(result.end(), run.begin(), run.end());
        return false;
    });
    return result;
}

QString treeIndexFault(const Tree& tree, const TreeIndex& index)
{
    const TreeIndex fresh(tree);
    if (index.size() != fresh.size())
        return QStringLiteral("size of the tree index");
    if (!std::ranges::equal(index.roots(), fresh.roots()) || index.livingCount() != fresh.livingCount())
        return QStringLiteral("roots of the tree index");
    if (index.greatestLength() != fresh.greatestLength())
        return QStringLiteral("greatest length of the tree index");
    for (InternodeId id = 0; id < fresh.size(); ++id) {
        if (index.firstChild(id) != fresh.firstChild(id))
            return at("first child", id);
        if (index.nextSibling(id) != fresh.nextSibling(id))
            return at("next sibling", id);
        if (index.mainChild(id) != fresh.mainChild(id))
            return at("main child", id);
        if (index.axis(id) != fresh.axis(id))
            return at("axis", id);
        if (index.nodePosition(id) != fresh.nodePosition(id))
            return at("position", id);
        if (index.rotation(id).coeffs() != fresh.rotation(id).coeffs())
            return at("rotation", id);
        if (index.subtreeSize(id) != fresh.subtreeSize(id))
            return at("subtree size", id);
        if (index.tipCount(id) != fresh.tipCount(id))
            return at("tip count", id);
    }
    return {};
}

} // namespace

const GrowthIndex& growthIndexOf(const TreeDocument& document)
{
    return dynamic_cast<const IndexedModel&>(document.growthModel()).index();
}

QString indexFault(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    if (const QString fault = treeIndexFault(tree, index); !fault.isEmpty())
        return fault;

    const GrowthIndex& growth = growthIndexOf(document);
    const GrowthIndex fresh(tree, index);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (growth.basipetal(id) != fresh.basipetal(id))
            return at("basipetal Q", id);
        if (!tree.isAlive(id))
            continue;
        if (growth.terminalQ(tree, id) != fresh.terminalQ(tree, id))
            return at("Q of the terminal bud", id);
        for (int slot = 0; slot < kMaxLaterals; ++slot) {
            if ((tree.buds(id) & budBit(slot)) != 0 &&
                growth.lateralQ(tree, index, id, slot) != fresh.lateralQ(tree, index, id, slot))
                return at("Q of a lateral bud", id);
        }
        if (growth.light(index.nodePosition(id)) != fresh.light(index.nodePosition(id)))
            return at("light", id);
    }

    const VoxelSpace& space = growth.space();
    if (space.edge() != fresh.space().edge() || !(space.pyramid() == fresh.space().pyramid()))
        return QStringLiteral("settings of the voxel space");
    // The updated space may have voxels left over from removed nodes: they must be as empty and light as any.
    std::vector<Cell> bricks = space.bricks();
    bricks.insert(bricks.end(), fresh.space().bricks().begin(), fresh.space().bricks().end());
    constexpr int kEdge = VoxelSpace::kBrickEdge;
    for (const Cell& brick : bricks) {
        for (int i = 0; i < kEdge * kEdge * kEdge; ++i) {
            const Cell voxel{kEdge * brick.x + i % kEdge, kEdge * brick.y + i / kEdge % kEdge,
                             kEdge * brick.z + i / (kEdge * kEdge)};
            const auto at = [&voxel](const char* what) {
                return QStringLiteral("%1 voxel %2, %3, %4")
                    .arg(QLatin1StringView(what))
                    .arg(voxel.x)
                    .arg(voxel.y)
                    .arg(voxel.z);
            };
            if (space.shadow(voxel) != fresh.space().shadow(voxel))
                return at("shadow of");
            if (residents(space, voxel) != residents(fresh.space(), voxel))
                return at("nodes in");
        }
    }
    return {};
}

DocumentState::DocumentState(const TreeDocument& document)
    : tree(document.tree()), undoIndex(document.undoStack().index())
{
    for (const auto& delta : document.journal())
        journal.push_back(*delta);
    for (const auto& delta : document.future())
        future.push_back(*delta);
}

QString differenceFrom(const DocumentState& before, const TreeDocument& document)
{
    const DocumentState now(document);
    QString difference;
    const auto compare = [&](const auto& info, const auto& a, const auto& b) {
        if (a != b)
            difference = QStringLiteral("the column “%1”").arg(QLatin1String(info.name));
    };
    const TreeContent& a = before.tree.content();
    const TreeContent& b = now.tree.content();
    InternodeTable::visit(compare, a.internodes, b.internodes);
    LeafTable::visit(compare, a.leaves, b.leaves);
    KeptTable::visit(compare, a.kept, b.kept);
    if (!difference.isEmpty())
        return difference;
    if (!(now.tree == before.tree))
        return QStringLiteral("the tree");
    if (now.journal != before.journal)
        return QStringLiteral("the journal");
    if (now.future != before.future)
        return QStringLiteral("the future");
    if (now.undoIndex != before.undoIndex)
        return QStringLiteral("the undo stack");
    return indexFault(document);
}

void apply(TreeDocument& document, TreeDelta delta)
{
    Edit edit(document);
    edit.apply(std::move(delta));
    edit.commit(QStringLiteral("Test"));
}

void travel(TreeDocument& document, std::size_t position)
{
    Edit edit(document);
    edit.travelTo(position);
    edit.commit(QStringLiteral("Test"));
}

} // namespace espalier::test
