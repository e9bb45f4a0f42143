// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/FbxGeometry.h"

#include <QIODevice>
#include <QtEndian>

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <memory>
#include <vector>

namespace espalier {

namespace {

constexpr std::uint32_t kNoNumber = std::numeric_limits<std::uint32_t>::max();

using Uv = std::array<float, 2>;

std::uint64_t hashOf(const Uv& uv)
{
    std::uint64_t hash = 0x9e3779b97f4a7c15U;
    for (const float part : uv) {
        // Zero has two signs, but is one number.
        hash = (hash ^ std::bit_cast<std::uint32_t>(part + 0.0F)) * 0xff51afd7ed558ccdU;
        hash ^= hash >> 32U;
    }
    return hash;
}

/// The texture coordinates of a mesh, each once, numbered as the corners of the triangles come.
struct DistinctUvs {
    explicit DistinctUvs(const TriangleMesh& mesh);

    std::vector<std::uint32_t> firstVertex; ///< By number: the first vertex that has the coordinates
    std::vector<std::uint32_t> numberOf;    ///< By vertex; kNoNumber if no triangle has it
};

DistinctUvs::DistinctUvs(const TriangleMesh& mesh) : numberOf(mesh.vertices.size(), kNoNumber)
{
    // Open addresses: 8 to 16 bytes for each vertex.
    std::vector<std::uint32_t> table(std::bit_ceil(2 * mesh.vertices.size() + 1), kNoNumber);
    for (const VertexIndex vertex : mesh.indices) {
        std::uint32_t& number = numberOf[vertex];
        if (number != kNoNumber)
            continue;
        const Uv& uv = mesh.vertices[vertex].uv;
        std::size_t place = hashOf(uv) & (table.size() - 1);
        while (table[place] != kNoNumber && mesh.vertices[firstVertex[table[place]]].uv != uv)
            place = (place + 1) & (table.size() - 1);
        if (table[place] == kNoNumber) {
            table[place] = static_cast<std::uint32_t>(firstVertex.size());
            firstVertex.push_back(vertex);
        }
        number = table[place];
    }
}

template <class T>
constexpr char typeOf();
template <>
constexpr char typeOf<double>()
{
    return 'd';
}
template <>
constexpr char typeOf<std::int32_t>()
{
    return 'i';
}

/// An array of @p count items of N numbers; @p itemAt(i) gives one as std::array<T, N>.
template <class T, std::size_t N, class ItemAt>
FbxArray arrayOf(std::size_t count, ItemAt itemAt)
{
    const auto write = [count, itemAt = std::move(itemAt)](QIODevice& device) {
        constexpr std::size_t kBlock = 4096;
        std::vector<T> block(kBlock * N);
        for (std::size_t begin = 0; begin < count; begin += kBlock) {
            const std::size_t items = std::min(kBlock, count - begin);
            for (std::size_t i = 0; i < items; ++i) {
                const std::array<T, N> item = itemAt(begin + i);
                std::ranges::copy(item, block.begin() + static_cast<std::ptrdiff_t>(N * i));
            }
            qToLittleEndian<T>(block.data(), static_cast<qsizetype>(N * items), block.data());
            const auto bytes = static_cast<qint64>(N * items * sizeof(T));
            if (device.write(reinterpret_cast<const char*>(block.data()), bytes) != bytes)
                return false;
        }
        return true;
    };
    return {.type = typeOf<T>(), .count = N * count, .elementBytes = sizeof(T), .write = write};
}

std::array<double, 3> doubles(const std::array<float, 3>& values)
{
    return {values[0], values[1], values[2]};
}

bool setArray(FbxNode* node, FbxArray array)
{
    if (node == nullptr || array.count > kNoNumber / array.elementBytes)
        return false;
    node->properties.clear();
    node->array = std::move(array);
    return true;
}

} // namespace

bool setFbxTriangles(FbxNode& geometry, const TriangleMesh& mesh)
{
    FbxNode* const normals = geometry.child("LayerElementNormal");
    FbxNode* const coordinates = geometry.child("LayerElementUV");
    if (normals == nullptr || coordinates == nullptr || mesh.vertices.size() >= kNoNumber / 2)
        return false;
    const auto* const vertices = &mesh.vertices;
    const auto* const indices = &mesh.indices;
    const auto uvs = std::make_shared<const DistinctUvs>(mesh);
    using One = std::array<std::int32_t, 1>;
    return setArray(
               geometry.child("Vertices"),
               arrayOf<double, 3>(vertices->size(),
                                  [vertices](std::size_t i) { return doubles((*vertices)[i].position); })) &&
           setArray(geometry.child("PolygonVertexIndex"),
                    arrayOf<std::int32_t, 1>(indices->size(),
                                             [indices](std::size_t i) {
                                                 const auto index = static_cast<std::int32_t>((*indices)[i]);
                                                 // The last corner of a polygon is negative.
                                                 return One{i % 3 == 2 ? ~index : index};
                                             })) &&
           setArray(normals->child("Normals"),
                    arrayOf<double, 3>(indices->size(),
                                       [vertices, indices](std::size_t i) {
                                           return doubles((*vertices)[(*indices)[i]].normal);
                                       })) &&
           setArray(coordinates->child("UV"),
                    arrayOf<double, 2>(uvs->firstVertex.size(),
                                       [vertices, uvs](std::size_t i) {
                                           const auto& uv = (*vertices)[uvs->firstVertex[i]].uv;
                                           return std::array<double, 2>{uv[0], uv[1]};
                                       })) &&
           setArray(coordinates->child("UVIndex"),
                    arrayOf<std::int32_t, 1>(indices->size(), [indices, uvs](std::size_t i) {
                        return One{static_cast<std::int32_t>(uvs->numberOf[(*indices)[i]])};
                    }));
}

} // namespace espalier
