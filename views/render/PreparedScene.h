// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VoxelSpace.h"
#include "model/mesh/ShownStrands.h"
#include "views/render/LightGrid.h"
#include "views/render/MeshPool.h"

#include <memory>
#include <utility>

namespace espalier {

/// The mesh and the light of a tree that a document is going to show. A worker thread can make it, so that
/// the scene has nothing to mesh when the document is reset; see TreeScene::expect().
struct PreparedScene {
    /// @p shownStrands of the same tree, or null.
    PreparedScene(const Tree& shown, const TreeIndex& index, const VoxelSpace& space,
                  std::shared_ptr<const ShownStrands> shownStrands = nullptr)
        : tree(shown), strands(std::move(shownStrands))
    {
        mesh.setLines(linesOf(strands));
        mesh.rebuild(tree, index);
        light.rebuild(space);
    }

    Tree tree; ///< A copy that shares the columns
    MeshPool mesh;
    LightGrid light;
    std::shared_ptr<const ShownStrands> strands;
};

} // namespace espalier
