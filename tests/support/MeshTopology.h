// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/mesh/Mesh.h"

#include <array>
#include <cstring>
#include <map>
#include <set>
#include <span>
#include <utility>

namespace espalier::test {

/// The topology of a triangle mesh after vertices at the same place (to the bit) are merged.
struct MeshTopology {
    int eulerCharacteristic = 0; ///< V − E + F; 2 for a sphere, 0 for a torus
    int openEdges = 0;           ///< With only one triangle
    /// With three triangles or more, or with two that disagree on which side is out.
    int nonManifoldEdges = 0;
    int degenerateTriangles = 0; ///< With two corners at one place, or without area

    bool isClosedManifold() const
    {
        return openEdges == 0 && nonManifoldEdges == 0 && degenerateTriangles == 0;
    }
};

inline MeshTopology topologyOf(std::span<const MeshVertex> vertices, std::span<const VertexIndex> indices)
{
    MeshTopology result;
    std::map<std::array<float, 3>, int> places;
    std::map<std::pair<int, int>, int> edges; // directed: how many triangles run along
    int faces = 0;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
        std::array<int, 3> corners{};
        std::array<Vec3, 3> points;
        for (std::size_t j = 0; j < 3; ++j) {
            const auto& position = vertices[indices[i + j]].position;
            corners[j] = places.try_emplace(position, static_cast<int>(places.size())).first->second;
            points[j] = toVec3(position);
        }
        const Vec3 a = points[1] - points[0];
        const Vec3 b = points[2] - points[0];
        const float longest = std::max({a.squaredNorm(), b.squaredNorm(), (b - a).squaredNorm()});
        if (a.cross(b).norm() <= 1e-5F * longest)
            ++result.degenerateTriangles;
        ++faces;
        for (std::size_t j = 0; j < 3; ++j)
            ++edges[{corners[j], corners[(j + 1) % 3]}];
    }

    std::set<std::pair<int, int>> undirected;
    for (const auto& [edge, count] : edges) {
        undirected.insert(std::minmax(edge.first, edge.second));
        const auto opposite = edges.find({edge.second, edge.first});
        const int other = opposite == edges.end() ? 0 : opposite->second;
        if (count == 1 && other == 0)
            ++result.openEdges;
        else if (count != 1 || other != 1)
            ++result.nonManifoldEdges;
    }
    result.eulerCharacteristic =
        static_cast<int>(places.size()) - static_cast<int>(undirected.size()) + faces;
    return result;
}

} // namespace espalier::test
