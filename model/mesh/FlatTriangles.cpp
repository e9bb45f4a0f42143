// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/FlatTriangles.h"

#include "model/base/Parallel.h"
#include "model/base/Vector.h"

#include <algorithm>
#include <array>

namespace espalier {

namespace {

/// Triangles with less area than this share of the squared diagonal of the mesh count as flat.
constexpr double kFlatArea = 4e-12;
/// A vertex moves by at least this share of the diagonal.
constexpr float kRaise = 1e-5F;
constexpr std::size_t kPerTask = 1 << 13;
constexpr int kMostRounds = 4; ///< A moved vertex can flatten a neighbour

/// A unit vector at right angles to @p edge that does not lead down; an axis if the edge has no length.
/// Another one in each round.
Vec3 acrossOf(const Vec3& edge, VertexIndex vertex, int round)
{
    if (edge.norm() <= 0.0F)
        return Vec3::Unit(static_cast<Eigen::Index>((vertex + static_cast<VertexIndex>(round)) % 3));
    Eigen::Index axis = 0;
    edge.cwiseAbs().minCoeff(&axis);
    Vec3 across = edge.cross(Vec3(Vec3::Unit(axis))).normalized();
    if (round % 2 == 1)
        across = edge.cross(across).normalized();
    return across.y() < 0.0F ? Vec3(-across) : across;
}

/// Finds and raises them.
class FlatTriangles {
public:
    FlatTriangles(std::span<const VertexIndex> indices, std::span<MeshVertex> vertices)
        : m_indices(indices), m_vertices(vertices)
    {
    }

    std::vector<RaisedVertex> raise()
    {
        m_diagonal = diagonal();
        m_least = kFlatArea * double{m_diagonal} * double{m_diagonal};
        std::vector<RaisedVertex> raised;
        std::vector<std::uint8_t> isMoved; // By vertex: in the last round
        for (int round = 0; round < kMostRounds; ++round) {
            const std::vector<std::size_t> flat = find([&](std::size_t i) {
                return round == 0 || isMoved[m_indices[i]] != 0 || isMoved[m_indices[i + 1]] != 0 ||
                       isMoved[m_indices[i + 2]] != 0;
            });
            if (flat.empty())
                break;
            isMoved.assign(m_vertices.size(), 0);
            for (const std::size_t i : flat) {
                if (!isFlat(i)) // Another one of its vertices has moved
                    continue;
                const VertexIndex vertex = move(i, round, raised);
                isMoved[vertex] = 1;
            }
        }
        std::ranges::stable_sort(raised, {}, &RaisedVertex::vertex);
        const auto again = std::ranges::unique(raised, {}, &RaisedVertex::vertex);
        raised.erase(again.begin(), again.end());
        return raised;
    }

private:
    float diagonal() const
    {
        std::vector<Box3> boxes((m_vertices.size() + kPerTask - 1) / kPerTask);
        parallelFor(boxes.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) {
                const std::size_t last = std::min((c + 1) * kPerTask, m_vertices.size());
                for (std::size_t i = c * kPerTask; i < last; ++i)
                    boxes[c].extend(toVec3(m_vertices[i].position));
            }
        });
        Box3 all;
        for (const Box3& box : boxes)
            all.extend(box);
        return all.isEmpty() ? 0.0F : all.diagonal().norm();
    }

    bool isFlat(std::size_t i) const
    {
        const Vec3 corner = toVec3(m_vertices[m_indices[i]].position);
        const Eigen::Vector3d a = (toVec3(m_vertices[m_indices[i + 1]].position) - corner).cast<double>();
        const Eigen::Vector3d b = (toVec3(m_vertices[m_indices[i + 2]].position) - corner).cast<double>();
        return a.cross(b).norm() / 2.0 <= m_least;
    }

    /// The flat triangles of those that @p isWanted(first index) selects, ascending.
    template <class IsWanted>
    std::vector<std::size_t> find(IsWanted&& isWanted) const
    {
        const std::size_t triangles = m_indices.size() / 3;
        std::vector<std::vector<std::size_t>> found((triangles + kPerTask - 1) / kPerTask);
        parallelFor(found.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) {
                const std::size_t last = std::min((c + 1) * kPerTask, triangles);
                for (std::size_t i = 3 * c * kPerTask; i < 3 * last; i += 3) {
                    if (isWanted(i) && isFlat(i))
                        found[c].push_back(i);
                }
            }
        });
        std::vector<std::size_t> result;
        for (const std::vector<std::size_t>& part : found)
            result.insert(result.end(), part.begin(), part.end());
        return result;
    }

    VertexIndex move(std::size_t i, int round, std::vector<RaisedVertex>& raised)
    {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = toVec3(m_vertices[m_indices[i + k]].position);
        // The corner opposite the longest edge.
        std::array<float, 3> lengths{};
        for (std::size_t k = 0; k < 3; ++k)
            lengths[k] = (corners[(k + 2) % 3] - corners[(k + 1) % 3]).squaredNorm();
        const auto apex = static_cast<std::size_t>(std::ranges::max_element(lengths) - lengths.begin());
        const VertexIndex vertex = m_indices[i + apex];
        raised.push_back({vertex, m_vertices[vertex].position});
        const Vec3 move = acrossOf(Vec3(corners[(apex + 2) % 3] - corners[(apex + 1) % 3]), vertex, round);
        const float step = kRaise * m_diagonal * (1.0F + static_cast<float>(vertex % 7) / 7.0F);
        m_vertices[vertex].position = toArray(Vec3(corners[apex] + step * move));
        return vertex;
    }

    std::span<const VertexIndex> m_indices;
    std::span<MeshVertex> m_vertices;
    float m_diagonal = 0.0F;
    double m_least = 0.0;
};

} // namespace

std::vector<RaisedVertex> raiseFlatTriangles(std::span<const VertexIndex> indices,
                                             std::span<MeshVertex> vertices)
{
    return FlatTriangles(indices, vertices).raise();
}

} // namespace espalier
