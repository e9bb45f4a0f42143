// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/FlatTriangles.h"

#include "model/base/Vector.h"

#include <algorithm>
#include <array>

namespace espalier {

namespace {

/// Triangles with less area than this share of the squared diagonal of the mesh count as flat.
constexpr double kFlatArea = 4e-12;
/// A vertex moves by at least this share of the diagonal.
constexpr float kRaise = 1e-5F;
constexpr int kMostRounds = 4; ///< A moved vertex can flatten a neighbour

/// A unit vector at right angles to @p edge; an axis if that has no length.
Vec3 acrossOf(const Vec3& edge, VertexIndex vertex)
{
    const float length = edge.norm();
    if (length <= 0.0F)
        return Vec3::Unit(static_cast<Eigen::Index>(vertex % 3));
    Eigen::Index axis = 0;
    edge.cwiseAbs().minCoeff(&axis);
    return Vec3(edge.cross(Vec3(Vec3::Unit(axis)))).normalized();
}

} // namespace

void raiseFlatTriangles(std::span<const VertexIndex> indices, std::span<MeshVertex> vertices)
{
    Box3 box;
    for (const MeshVertex& vertex : vertices)
        box.extend(toVec3(vertex.position));
    if (vertices.empty())
        return;
    const float diagonal = box.diagonal().norm();
    const double least = kFlatArea * double{diagonal} * double{diagonal};
    bool isMoved = true;
    for (int round = 0; round < kMostRounds && isMoved; ++round) {
        isMoved = false;
        for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
            std::array<Vec3, 3> corners;
            for (std::size_t k = 0; k < 3; ++k)
                corners[k] = toVec3(vertices[indices[i + k]].position);
            const Eigen::Vector3d a = (corners[1] - corners[0]).cast<double>();
            const Eigen::Vector3d b = (corners[2] - corners[0]).cast<double>();
            if (a.cross(b).norm() / 2.0 > least)
                continue;
            // The corner opposite the longest edge.
            std::array<float, 3> lengths{};
            for (std::size_t k = 0; k < 3; ++k)
                lengths[k] = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).squaredNorm();
            const auto apex = static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
            const VertexIndex vertex = indices[i + apex];
            Vec3 move = acrossOf(Vec3(corners[(apex + 2) % 3] - corners[(apex + 1) % 3]),
                                 vertex + static_cast<VertexIndex>(round));
            move.y() = std::abs(move.y());
            const float step = kRaise * diagonal * (1.0F + static_cast<float>(vertex % 7) / 7.0F);
            vertices[vertex].position = toArray(Vec3(corners[apex] + step * move));
            isMoved = true;
        }
    }
}

} // namespace espalier
