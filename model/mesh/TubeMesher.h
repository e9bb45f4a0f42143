// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/RingMesh.h"

#include <vector>

namespace espalier {

/// Meshes one tube at a time (see Tubes.h): tapered, along a centripetal Catmull-Rom curve through its nodes,
/// closed at both ends. Frames: parallel transport by double reflection (Wang et al. 2008). Texture:
/// generalised cylinders with a whole number of repeats (Bloomenthal 1985).
///
/// A tube starts at the node of its parent, inside the parent, in the parent's direction, with at most 90 %
/// of the parent's radius. A collar widens it toward the parent, and the trunk toward the ground.
///
/// A ring has m sides, the fewest of kSideCounts whose chords lie no deeper in the circle than the tolerance,
/// and m + 1 vertices, since the seam is doubled; where a tube has become thin, m halves. Rings stand at each
/// node; at every second, fourth and so on where internodes are short for their thickness (a trunk grows
/// straight over the kinks of its youth); and between nodes where the curve bends.
///
/// Nothing lies below the ground, y = 0: the base of a trunk lies on it, and parts of a tube below it are cut
/// off there.
///
/// u runs from 0 to a whole number k around the tube, v so that texels are square: dv = k ds / 2πr.
///
/// A piece of wood is a tube, its internodes from the base up.
class TubeMesher final : public WoodPieceMesher {
public:
    TubeMesher(const Tree& tree, const TreeIndex& index, const Widths& widths,
               const WoodMeshOptions& options = {});

    MeshSize prepare(InternodeId base) override;
    void write(std::span<MeshVertex> vertices, std::span<VertexIndex> indices,
               VertexIndex firstVertex = 0) override;
    void writeOrigins(std::span<WoodOrigin> origins) const override;

    std::span<const InternodeId> internodes() const override { return m_internodes; }
    std::span<const float> radii() const override { return m_radii; }
    float supportRadius() const override { return m_parentRadius; }

    using Ring = TubeRing;
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
        /// Square root of chord: the parameter's length in the centripetal parametrisation.
        float root = 0.0F;
        float path = 0.0F; ///< Sum of the chords below it, m
        int sides = 4;
        /// Index in m_internodes of the internode that ends here; that of the first for the tube's foot.
        std::uint32_t internode = 0;
        int rings = 1; ///< Rings from here (included) to the next knot (excluded)
    };

    /// Direction, a unit vector, in which the branch below the node of @p id reaches it.
    Vec3 directionBelow(InternodeId id) const;
    int sidesFor(float radius) const;
    std::size_t strideAt(std::size_t place) const;
    void chooseKnots();
    void findTangents(const Vec3& first);
    void chooseRings();
    MeshSize size() const;
    float widened(float radius, float path) const;
    void placeRings();

    const Tree& m_tree;
    const TreeIndex& m_index;
    const Widths& m_widths;
    double m_tolerance; ///< m
    float m_barkScale;

    std::vector<InternodeId> m_internodes;
    std::vector<float> m_radii;
    std::vector<float> m_thickest; ///< The largest radius from here to the end, m
    std::vector<Knot> m_knots;
    std::vector<Ring> m_rings;
    Vec3 m_firstNormal = Vec3::UnitX();
    float m_parentRadius = 0.0F;
    float m_collar = 0.0F;    ///< Most that is added to the radius, m, at path 0
    float m_collarEnd = 0.0F; ///< Path beyond which the collar adds nothing, m
    float m_repeats = 1.0F;   ///< k
    bool m_rooted = false;    ///< Has a ring below its first knot
    float m_firstV = 0.0F;
};

} // namespace espalier
