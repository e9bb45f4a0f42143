// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/UvWrap.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace espalier {

namespace {

constexpr VertexIndex kNone = std::numeric_limits<VertexIndex>::max();

/// A vertex of the result: which vertex it was, and how many periods were subtracted from its v.
struct Copy {
    std::int32_t periods = 0;
    VertexIndex index = kNone;
};

/// Numbers the vertices of the result.
class Copies {
public:
    explicit Copies(const TriangleMesh& source) : m_source(source), m_first(source.vertices.size())
    {
        m_vertices.reserve(source.vertices.size() + source.vertices.size() / 8);
    }

    VertexIndex indexOf(VertexIndex vertex, std::int32_t periods)
    {
        Copy& first = m_first[vertex];
        if (first.index == kNone)
            first = {periods, append(vertex, periods)};
        if (first.periods == periods)
            return first.index;
        const std::uint64_t key = std::uint64_t{vertex} << 32U | static_cast<std::uint32_t>(periods);
        const auto [place, isNew] = m_others.try_emplace(key, kNone);
        if (isNew)
            place->second = append(vertex, periods);
        return place->second;
    }
    MeshBuffer<MeshVertex> takeVertices() { return std::move(m_vertices); }

private:
    VertexIndex append(VertexIndex vertex, std::int32_t periods)
    {
        m_vertices.push_back(m_source.vertices[vertex]);
        m_vertices.back().uv[1] -= kWrapPeriod * static_cast<float>(periods);
        return static_cast<VertexIndex>(m_vertices.size() - 1);
    }

    const TriangleMesh& m_source;
    std::vector<Copy> m_first;
    std::unordered_map<std::uint64_t, VertexIndex> m_others;
    MeshBuffer<MeshVertex> m_vertices;
};

} // namespace

TriangleMesh withSmallV(const TriangleMesh& mesh)
{
    TriangleMesh result;
    result.indices.resize(mesh.indices.size());
    Copies copies(mesh);
    const auto v = [&](std::size_t corner) { return mesh.vertices[mesh.indices[corner]].uv[1]; };
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const float least = std::min({v(i), v(i + 1), v(i + 2)});
        const auto periods = static_cast<std::int32_t>(std::floor(least / kWrapPeriod + 0.5F));
        for (std::size_t corner = i; corner < i + 3; ++corner)
            result.indices[corner] = copies.indexOf(mesh.indices[corner], periods);
    }
    result.vertices = copies.takeVertices();
    return result;
}

} // namespace espalier
