// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/project/ProjectFile.h"
#include "model/shape/ClearWood.h"
#include "tests/support/TreeBuilder.h"

#include <array>

namespace espalier::test {

/// A project of about @p count internodes with all that a history can hold: births, deaths, parameter
/// changes, bends, widths, envelopes, placed leaves, and steps that were taken back.
inline Project sampleProject(std::uint32_t count, std::uint64_t seed = 1)
{
    TreeParameters parameters;
    parameters.growth.lateralsPerNode = 2;
    TreeBuilder builder(seed, parameters);
    builder.growTo(count / 2, seed);
    parameters.growth.branchingAngle = radians(33.3);
    parameters.leaves.shape = LeafShape::Needles;
    builder.apply(parameterChange(builder.tree, parameters));
    // The first lateral branch that is not the whole tree is removed.
    for (InternodeId id = 1; id < builder.tree.size(); ++id) {
        if (builder.tree.isAlive(id) && !builder.tree.continuesAxis(id)) {
            builder.apply(death(builder.tree, builder.index, id));
            break;
        }
    }
    builder.growTo(count, seed + 1);
    const Rotation turn(Eigen::AngleAxisf(0.5F, Vec3::UnitX()));
    builder.apply(bend(builder.tree, 1, turn, 1.3F));
    builder.apply(widthChange(builder.tree, 1, 0.05F));
    builder.apply(widthChange(builder.tree, 2, 0.03F));
    builder.apply(widthChange(builder.tree, 1, 0.0F));
    builder.apply(keepClear(builder.tree, builder.index, 0, 0.01F));
    LassoStroke stroke;
    stroke.origin = Vec3(0.5F, 1.0F, -0.25F);
    stroke.points = {{-1.0F, 0.0F}, {1.0F, 0.125F}, {0.3F, 2.0F}};
    builder.apply(newLasso(builder.tree, stroke));
    stroke.points.push_back({-0.3F, 1.5F});
    builder.apply(newLasso(builder.tree, stroke));
    builder.apply(lassoChange(builder.tree, 0, false));
    builder.apply(leafPlacement(builder.tree, std::array<InternodeId, 3>{1, 2, 4}));
    builder.apply(leafRemoval(builder.tree, 1));
    builder.apply(leafChange(builder.tree, 2, 3, LeafKind::Fruit));
    // An undone step leaves no trace.
    builder.apply(randomGrowth(builder.tree, 5, seed));
    builder.revert();

    Project project;
    for (TreeDelta& delta : builder.journal) {
        project.journal.push_back(std::make_shared<TreeDelta>(std::move(delta)));
        project.journal.back()->rows.reset();
    }
    project.tree = builder.tree;
    project.name = QStringLiteral("Old oak “Älteste”");
    return project;
}

inline bool sameJournal(const Journal& a, const Journal& b)
{
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return *x == *y; });
}

/// Reverts the whole journal and applies it again; returns whether that leads back to the same tree.
inline bool survivesItsHistory(const Project& project)
{
    Tree tree = project.tree;
    TreeIndex index(tree);
    for (std::size_t i = project.journal.size(); i-- > 0;) {
        tree.revert(*project.journal[i]);
        index.update(tree, *project.journal[i]);
    }
    for (const auto& delta : project.journal) {
        tree.apply(*delta);
        index.update(tree, *delta);
    }
    return tree == project.tree && index.livingCount() == TreeIndex(project.tree).livingCount();
}

} // namespace espalier::test
