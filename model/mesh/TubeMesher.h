// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"
#include "model/shape/Widths.h"

#include <span>
#include <vector>

namespace espalier {

struct BranchMeshOptions {
    /// 0.1...2; multiplies the number of a tube's sides, for levels of detail.
    double detail = 1.0;

    bool operator==(const BranchMeshOptions&) const = default;
};

/// Meshes one tube at a time (see Tubes.h): tapered, along a centripetal Catmull-Rom curve through its nodes,
/// closed at both ends. Frames: parallel transport by double reflection (Wang et al. 2008). Texture:
/// generalised cylinders with a whole number of repeats (Bloomenthal 1985).
///
/// It starts at the node of its parent, inside it, in the parent's direction, never thicker than 90 % of it.
/// A collar widens it toward the parent, and the trunk toward the ground.
///
/// A ring has m sides, one of kSideCounts by how much thicker than a twig the tube is there, and m + 1
/// vertices, since the seam is doubled; where a tube has become thin, m halves. Rings stand at each node; at
/// every second, fourth and so on where internodes are short for their thickness (a trunk grows straight over
/// the kinks of its youth); and between nodes where the curve bends.
///
/// u runs from 0 to a whole number k around the tube, v so that texels are square: dv = k ds / 2πr.
///
/// The buffers inside are reused: keep one mesher per thread for many tubes.
class TubeMesher {
public:
    TubeMesher(const Tree& tree, const TreeIndex& index, const Widths& widths,
               const BranchMeshOptions& options = {});

    /// Reads the tube that begins with the living internode @p base and returns what its mesh will take.
    MeshSize prepare(InternodeId base);

    /// Writes the mesh of the tube prepared last into spans of exactly that size; @p firstVertex is added to
    /// the indices.
    void write(std::span<MeshVertex> vertices, std::span<VertexIndex> indices, VertexIndex firstVertex = 0);

    /// The prepared tube: its internodes from the base up, the radius of each, and that of the internode it
    /// stands on (0 for the trunk).
    std::span<const InternodeId> internodes() const { return m_internodes; }
    std::span<const float> radii() const { return m_radii; }
    float parentRadius() const { return m_parentRadius; }

    struct Ring {
        Vec3 centre = Vec3::Zero();
        Vec3 tangent = Vec3::UnitY();
        float radius = 0.0F; ///< m
        float path = 0.0F;   ///< m of tube below it
        int sides = 4;
    };
    /// Rings of the tube written last, from the base up, in the order of their vertices.
    std::span<const Ring> rings() const { return m_rings; }

private:
    /// A point that the curve passes through.
    struct Knot {
        Vec3 position = Vec3::Zero();
        Vec3 velocity = Vec3::Zero(); ///< Derivative by the centripetal parameter
        Vec3 tangent = Vec3::UnitY();
        float radius = 0.0F; ///< m, without flare and collar
        float chord = 0.0F;  ///< m, to the next knot
        float root = 0.0F;   ///< Square root of chord: the centripetal parameter's length
        float path = 0.0F;   ///< m of chords below it
        int sides = 4;
        int rings = 1; ///< Rings from here (included) to the next knot (excluded)
    };

    /// Unit, in which the branch below the node of @p id comes to it.
    Vec3 directionBelow(InternodeId id) const;
    int sidesFor(float radius) const;
    void chooseKnots();
    void findTangents(const Vec3& first);
    void chooseRings();
    MeshSize size() const;
    float widened(float radius, float path) const;
    void placeRings();
    void writeVertices(std::span<MeshVertex> vertices) const;
    void writeIndices(std::span<VertexIndex> indices, VertexIndex firstVertex) const;

    const Tree& m_tree;
    const TreeIndex& m_index;
    const Widths& m_widths;
    double m_detail;
    float m_tipRadius;
    float m_barkScale;

    std::vector<InternodeId> m_internodes;
    std::vector<float> m_radii;
    std::vector<Knot> m_knots;
    std::vector<Ring> m_rings;
    Vec3 m_firstNormal = Vec3::UnitX();
    float m_parentRadius = 0.0F;
    float m_collar = 0.0F;    ///< Most that is added to the radius, m, at path 0
    float m_collarEnd = 0.0F; ///< Path at which nothing is added any more, m
    float m_repeats = 1.0F;   ///< k
    bool m_rooted = false;    ///< Has a ring below its first knot
    float m_firstV = 0.0F;
};

} // namespace espalier
