// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/VoxelSpace.h"
#include "views/render/LightGrid.h"
#include "views/render/MeshPool.h"

namespace espalier {

/// The mesh and the light of a tree that a document is going to show. A worker thread can make it, so that
/// the scene has nothing to mesh when the document is reset; see TreeScene::expect().
struct PreparedScene {
    PreparedScene(const Tree& shown, const TreeIndex& index, const VoxelSpace& space) : tree(shown)
    {
        mesh.rebuild(tree, index);
        light.rebuild(space);
    }

    Tree tree; ///< A copy that shares the columns
    MeshPool mesh;
    LightGrid light;
};

} // namespace espalier
