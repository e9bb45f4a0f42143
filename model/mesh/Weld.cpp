// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/Weld.h"

#include "model/base/Random.h"

#include <bit>

namespace espalier {

namespace {

std::uint64_t hashOf(const std::array<float, 3>& position)
{
    std::uint64_t hash = 0;
    for (const float value : position)
        hash = mixedBits(hash ^ std::bit_cast<std::uint32_t>(value == 0.0F ? 0.0F : value)); // -0 is 0
    return hash;
}

} // namespace

std::vector<VertexIndex> firstAtSamePlace(std::span<const MeshVertex> vertices)
{
    constexpr VertexIndex kFree = ~VertexIndex{0};
    const std::size_t size = std::bit_ceil(2 * vertices.size() + 1);
    std::vector<VertexIndex> table(size, kFree);
    std::vector<VertexIndex> first(vertices.size());
    for (VertexIndex i = 0; i < vertices.size(); ++i) {
        std::size_t place = hashOf(vertices[i].position) & (size - 1);
        while (table[place] != kFree && vertices[table[place]].position != vertices[i].position)
            place = (place + 1) & (size - 1);
        if (table[place] == kFree)
            table[place] = i;
        first[i] = table[place];
    }
    return first;
}

} // namespace espalier
