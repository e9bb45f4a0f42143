// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"
#include "model/shape/Widths.h"

#include <memory>
#include <span>

namespace espalier {

/// How finely wood is meshed.
struct WoodMeshOptions {
    /// The finest tolerance, m; smaller requests are raised to it.
    static constexpr double kFinest = 1e-5;

    /// The largest distance between the mesh and the round and curved surface that it approximates, m: 1 mm
    /// looks round at a few metres.
    double tolerance = 0.001;

    bool operator==(const WoodMeshOptions&) const = default;
};

/// The place on the tree that a vertex of the wood belongs to.
struct WoodOrigin {
    InternodeId internode = kNoInternode;
    /// Along the internode: 0 at its base, 1 at its node. The root of a branch, which lies inside its parent,
    /// counts as 0.
    float along = 0.0F;

    bool operator==(const WoodOrigin&) const = default;
};

/// Meshes the pieces of one tree's wood, one at a time. Keeps its buffers from piece to piece: use one for
/// each thread.
class WoodPieceMesher {
public:
    WoodPieceMesher() = default;
    WoodPieceMesher(const WoodPieceMesher&) = delete;
    WoodPieceMesher& operator=(const WoodPieceMesher&) = delete;
    virtual ~WoodPieceMesher() = default;

    /// Reads the piece that begins with the living internode @p base and returns the size of its mesh.
    virtual MeshSize prepare(InternodeId base) = 0;
    /// Writes the mesh of the piece prepared last, a closed surface, into spans of exactly that size; @p
    /// firstVertex is added to the indices.
    virtual void write(std::span<MeshVertex> vertices, std::span<VertexIndex> indices,
                       VertexIndex firstVertex = 0) = 0;
    /// Writes the place on the tree of each vertex of the piece written last, in their order.
    virtual void writeOrigins(std::span<WoodOrigin> origins) const = 0;

    /// The internodes of the prepared piece, its base first, and the radius of each, m.
    virtual std::span<const InternodeId> internodes() const = 0;
    virtual std::span<const float> radii() const = 0;
    /// Radius of the internode that the prepared piece stands on, m; 0 if it stands on the ground.
    virtual float supportRadius() const = 0;
};

/// A way to make a surface of a tree's wood. The living internodes are divided into pieces. Each piece is
/// connected, begins with one internode, and is meshed as a whole: so a change only costs what it touches.
/// The mesh of a piece depends only on the places and radii of its own internodes, on the direction and
/// radius of the internode that it stands on, on the tip counts of the branches around it, and on the
/// options.
class WoodMesher {
public:
    virtual ~WoodMesher() = default;

    /// Makes @p children the living children of the living internode @p id that belong to its piece,
    /// ascending; the other children begin pieces, and so do roots. It costs no more than to visit all
    /// children once.
    virtual void joinedChildren(const TreeIndex& index, InternodeId id,
                                std::vector<InternodeId>& children) const = 0;
    /// @p tree, @p index and @p widths must outlive the returned mesher.
    virtual std::unique_ptr<WoodPieceMesher> pieceMesher(const Tree& tree, const TreeIndex& index,
                                                         const Widths& widths,
                                                         const WoodMeshOptions& options) const = 0;

    /// The first internodes of all pieces of a tree, ascending.
    std::vector<InternodeId> pieces(const Tree& tree, const TreeIndex& index) const
    {
        std::vector<bool> joins(tree.size(), false);
        std::vector<InternodeId> bases;
        std::vector<InternodeId> children;
        for (InternodeId id = 0; id < tree.size(); ++id) {
            if (!tree.isAlive(id))
                continue;
            joinedChildren(index, id, children);
            for (const InternodeId child : children)
                joins[child] = true;
            if (!joins[id])
                bases.push_back(id);
        }
        return bases;
    }
};

/// The mesher that makes tubes, see Tubes.h and TubeMesher.
const WoodMesher& tubeWood();

} // namespace espalier
