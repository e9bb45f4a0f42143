// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/Documents.h"

#include <algorithm>

namespace espalier::test {

namespace {

QString at(const char* what, InternodeId id)
{
    return QStringLiteral("%1 of internode %2").arg(QLatin1String(what)).arg(id);
}

std::vector<Resident> residents(const VoxelSpace& space, const VoxelSpace::Bounds& bounds)
{
    std::vector<Resident> result;
    space.anyRun(bounds.lower, bounds.upper, [&](VoxelSpace::Residents run) {
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

QString indexFault(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    if (const QString fault = treeIndexFault(tree, index); !fault.isEmpty())
        return fault;

    const GrowthIndex& growth = document.growthIndex();
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
    // The space that was followed may have voxels left over from what is gone: they must be as empty and
    // light as any.
    const VoxelSpace::Bounds bounds = space.bounds();
    for (int x = bounds.lower.x; x <= bounds.upper.x; ++x) {
        for (int y = bounds.lower.y; y <= bounds.upper.y; ++y) {
            for (int z = bounds.lower.z; z <= bounds.upper.z; ++z) {
                if (space.shadow({x, y, z}) != fresh.space().shadow({x, y, z}))
                    return QStringLiteral("shadow of voxel %1, %2, %3").arg(x).arg(y).arg(z);
            }
        }
    }
    if (residents(space, bounds) != residents(fresh.space(), bounds))
        return QStringLiteral("nodes in their voxels");
    return {};
}

QString visibleDifference(const DocumentState& before, const TreeDocument& document)
{
    const Tree& a = before.tree;
    const Tree& b = document.tree();
    if (b.step() != a.step())
        return QStringLiteral("the step");
    if (b.parameters() != a.parameters())
        return QStringLiteral("the parameters in force");
    if (document.journal().size() != before.journal)
        return QStringLiteral("the journal");
    if (document.undoStack().index() != before.undoIndex)
        return QStringLiteral("the undo stack");
    if (!std::ranges::equal(b.widthConstraints(), a.widthConstraints()))
        return QStringLiteral("the widths that were set");
    QString difference;
    for (InternodeId id = a.size(); id < b.size(); ++id) {
        if (b.columns().present[id] != 0)
            return at("life", id);
    }
    const auto compare = [&](const char* name, const auto& columnA, const auto& columnB) {
        for (qsizetype i = 0; i < columnA.size(); ++i) {
            if (difference.isEmpty() && !(columnA[i] == columnB[i]))
                difference = at(name, static_cast<InternodeId>(i));
        }
    };
    const InternodeColumns& columns = b.columns();
    compare("parent", a.columns().parent, columns.parent);
    compare("rotation", a.columns().rotation, columns.rotation);
    compare("length", a.columns().length, columns.length);
    compare("vigour", a.columns().vigour, columns.vigour);
    compare("slot", a.columns().slot, columns.slot);
    compare("buds", a.columns().buds, columns.buds);
    compare("birth", a.columns().birth, columns.birth);
    compare("death", a.columns().death, columns.death);
    compare("presence", a.columns().present, columns.present);
    compare("parameters", a.columns().parameterSet, columns.parameterSet);
    return difference.isEmpty() ? indexFault(document) : difference;
}

} // namespace espalier::test
