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

/// A vertex of the result: its vertex in the source, and the number that was subtracted from its v.
struct Copy {
    std::int32_t shift = 0;
    VertexIndex index = kNone;
};

/// Numbers the vertices of the result.
class Copies {
public:
    explicit Copies(const TriangleMesh& source) : m_source(source), m_first(source.vertices.size())
    {
        m_vertices.reserve(source.vertices.size() + source.vertices.size() / 8);
    }

    VertexIndex indexOf(VertexIndex vertex, std::int32_t shift)
    {
        Copy& first = m_first[vertex];
        if (first.index == kNone)
            first = {shift, append(vertex, shift)};
        if (first.shift == shift)
            return first.index;
        const std::uint64_t key = std::uint64_t{vertex} << 32U | static_cast<std::uint32_t>(shift);
        const auto [place, isNew] = m_others.try_emplace(key, kNone);
        if (isNew)
            place->second = append(vertex, shift);
        return place->second;
    }
    MeshBuffer<MeshVertex> takeVertices() { return std::move(m_vertices); }

private:
    VertexIndex append(VertexIndex vertex, std::int32_t shift)
    {
        m_vertices.push_back(m_source.vertices[vertex]);
        m_vertices.back().uv[1] -= static_cast<float>(shift);
        return static_cast<VertexIndex>(m_vertices.size() - 1);
    }

    const TriangleMesh& m_source;
    std::vector<Copy> m_first;
    std::unordered_map<std::uint64_t, VertexIndex> m_others;
    MeshBuffer<MeshVertex> m_vertices;
};

/// The number to subtract from a triangle's v, if possible the number of the triangle before.
std::int32_t shiftFor(float least, float greatest, std::int32_t before)
{
    const auto moved = static_cast<float>(before);
    if (least - moved >= -kGreatestV && greatest - moved <= kGreatestV)
        return before;
    // As low as possible, because the next triangles lie higher.
    const float lowest = std::floor(least + kGreatestV);
    const float middle = std::round((least + greatest) / 2.0F);
    return static_cast<std::int32_t>(greatest - lowest <= kGreatestV ? lowest : middle);
}

} // namespace

TriangleMesh withSmallV(const TriangleMesh& mesh)
{
    TriangleMesh result;
    result.indices.resize(mesh.indices.size());
    Copies copies(mesh);
    const auto v = [&](std::size_t corner) { return mesh.vertices[mesh.indices[corner]].uv[1]; };
    std::int32_t shift = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto [least, greatest] = std::minmax({v(i), v(i + 1), v(i + 2)});
        shift = shiftFor(least, greatest, shift);
        for (std::size_t corner = i; corner < i + 3; ++corner)
            result.indices[corner] = copies.indexOf(mesh.indices[corner], shift);
    }
    result.vertices = copies.takeVertices();
    return result;
}

} // namespace espalier
