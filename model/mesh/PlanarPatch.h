// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace espalier {

/// Triangulates what lies between the outlines of a section and the outlines of the parts into which it
/// divides, in one plane. The result is closed by construction: each edge of an outline gets one triangle,
/// and each other edge two of opposite direction, whatever the outlines are; its shape is good if the
/// outlines are simple and do not cross. Keeps its buffers: use one for each thread.
class PlanarPatch {
public:
    static constexpr std::uint32_t kNoStrand = std::numeric_limits<std::uint32_t>::max();

    /// A closed polygon: counter-clockwise around wood, clockwise around a cavity.
    struct Outline {
        std::vector<Vec2> points;
        /// For each point the strand that it stands for, or kNoStrand. Where two outlines have an edge
        /// between the same two strands, these edges are joined by two triangles.
        std::vector<std::uint32_t> strands;
    };
    /// Triangles of points, counter-clockwise. Points are numbered through: those of the outlines of the
    /// whole, one outline after another, then those of the parts.
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;

    /// @p parts lie inside @p whole.
    void triangulate(std::span<const Outline> whole, std::span<const Outline> parts, Triangles& triangles);

private:
    struct Corner {
        std::uint32_t point;
        std::uint32_t before;
        std::uint32_t after;
        bool isGone;
    };
    /// A closed polygon that is left to be triangulated, as points.
    using Face = std::vector<std::uint32_t>;

    /// A set of pairs of points in a table that is kept from patch to patch.
    class EdgeSet {
    public:
        /// @p points: about how many points the edges have.
        void clear(std::size_t points);
        void insert(std::uint32_t a, std::uint32_t b);
        void erase(std::uint32_t a, std::uint32_t b);
        bool contains(std::uint32_t a, std::uint32_t b) const;

    private:
        static constexpr std::uint64_t kFree = std::numeric_limits<std::uint64_t>::max();
        static constexpr std::uint64_t kErased = kFree - 1;

        /// The place of a key, or the free one where it would be.
        std::size_t placeOf(std::uint64_t key) const;
        void grow();

        std::vector<std::uint64_t> m_keys = std::vector<std::uint64_t>(64, kFree); ///< A power of two of them
        std::size_t m_count = 0;                                                   ///< That are not free
    };

    void collect(std::span<const Outline> whole, std::span<const Outline> parts);
    void joinEqualEdges(Triangles& triangles);
    void traceFaces();
    void openFaceNear(const Vec2& place, Triangles& triangles);
    void assignHoles(Triangles& triangles);
    void connectHole(Face& face, const Face& hole);
    void clip(const Face& face, Triangles& triangles);

    double areaOf(const Face& face) const;
    bool contains(const Face& face, const Vec2& point) const;
    void noteEdge(std::uint32_t a, std::uint32_t b);
    bool hasEdge(std::uint32_t a, std::uint32_t b) const;
    bool isEar(std::uint32_t corner, bool strict) const;

    std::vector<Vec2> m_points;
    std::vector<std::uint32_t> m_strands;
    std::vector<std::uint32_t> m_next;   ///< By point: the next one of its outline
    std::vector<std::uint32_t> m_before; ///< By point: the one before
    std::vector<std::uint32_t>
        m_partner;                 ///< By point: the point that the edge which begins there is joined to
    std::uint32_t m_firstPart = 0; ///< The first point of the parts
    std::vector<Face> m_faces;
    std::vector<Face> m_holes;
    EdgeSet m_edges;
    std::vector<std::pair<std::uint64_t, std::uint32_t>> m_ofParts; ///< Pairs of strands, and points
    std::vector<double> m_cost;
    std::vector<Corner> m_corners;
};

} // namespace espalier
