// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LeafCard.h"

#include "model/base/Parallel.h"
#include "model/tree/LeafShapes.h"

namespace espalier {

namespace {

constexpr std::size_t kLeavesPerTask = 4096;

/// The bend of a leaf; heights in widths out of the plane.
struct Relief {
    float aspect; ///< usualAspect() of the shape
    float arch;   ///< Height of the midrib's middle above its chord
    float tip;    ///< Depth of the tip below the petiole
    float fold;   ///< Height of the edges above the midrib
};

float midrib(const Relief& relief, float y)
{
    return 4.0F * relief.arch * y * (1.0F - y) - relief.tip * y * y;
}

/// A place of the folded and arched blade.
MeshVertex bladeVertex(const Relief& relief, float x, float y)
{
    const float z = midrib(relief, y) + 2.0F * std::abs(x) * relief.fold;
    const float across = x == 0.0F ? 0.0F : (x > 0.0F ? -2.0F : 2.0F) * relief.fold;
    const float along = relief.aspect * (-4.0F * relief.arch * (1.0F - 2.0F * y) + 2.0F * relief.tip * y);
    const Vec3 normal = Vec3(across, along, 1.0F).normalized();
    const Vec3 tangent = (Vec3::UnitX() - normal.x() * normal).normalized();
    return {.position = {x, y, z},
            .normal = toArray(normal),
            .tangent = {tangent.x(), tangent.y(), tangent.z(), 1.0F},
            .uv = {x + 0.5F, y}};
}

/// The outline B-L1-L2-T-R2-R1 around the midrib's middle M; @p shoulder and @p top are the heights of the
/// lower and upper pair.
LeafCard foldedCard(const Relief& relief, float shoulder, float top)
{
    const auto vertex = [&](float x, float y) { return bladeVertex(relief, x, y); };
    return {.vertices = {vertex(0.0F, 0.0F), vertex(0.0F, 0.5F), vertex(0.0F, 1.0F), vertex(-0.5F, shoulder),
                         vertex(-0.5F, top), vertex(0.5F, shoulder), vertex(0.5F, top)},
            .indices = {0, 1, 3, 3, 1, 4, 4, 1, 2, 0, 5, 1, 5, 6, 1, 6, 2, 1}};
}

/// The whole square in @p rows pairs of cells along the midrib.
LeafCard wholeCard(const Relief& relief, VertexIndex rows)
{
    LeafCard card;
    for (VertexIndex row = 0; row <= rows; ++row) {
        const float y = static_cast<float>(row) / static_cast<float>(rows);
        for (const float x : {-0.5F, 0.0F, 0.5F})
            card.vertices.push_back(bladeVertex(relief, x, y));
        if (row == rows)
            break;
        for (const VertexIndex corner : {0U, 1U, 4U, 0U, 4U, 3U, 1U, 2U, 4U, 2U, 5U, 4U})
            card.indices.push_back(3 * row + corner);
    }
    return card;
}

LeafCard crossedCards()
{
    LeafCard card;
    // Normals lean outward at the edges, as if the spray were round.
    constexpr float lean = 0.6F;
    constexpr float upright = 0.8F;
    for (const bool turned : {false, true}) {
        const auto turn = [turned](float x, float y, float z) {
            return turned ? std::array{z, y, -x} : std::array{x, y, z};
        };
        const auto first = static_cast<VertexIndex>(card.vertices.size());
        for (const float y : {0.0F, 1.0F}) {
            for (const float x : {-0.5F, 0.5F}) {
                const float side = x < 0.0F ? -1.0F : 1.0F;
                const std::array<float, 3> tangent = turn(upright, 0.0F, -side * lean);
                card.vertices.push_back({.position = turn(x, y, 0.0F),
                                         .normal = turn(side * lean, 0.0F, upright),
                                         .tangent = {tangent[0], tangent[1], tangent[2], 1.0F},
                                         .uv = {x + 0.5F, y}});
            }
        }
        for (const VertexIndex corner : {0U, 1U, 3U, 0U, 3U, 2U})
            card.indices.push_back(first + corner);
    }
    return card;
}

Vec3 rotated(const Rotation& rotation, const std::array<float, 3>& vector)
{
    return rotation * toVec3(vector);
}

void expand(const LeafInstance& leaf, const LeafMeshOptions& options, MeshVertex* vertices,
            VertexIndex* indices, VertexIndex firstVertex)
{
    const LeafCard& card = leafCard(static_cast<LeafShape>(leaf.shape));
    const Rotation rotation(leaf.rotation[3], leaf.rotation[0], leaf.rotation[1], leaf.rotation[2]);
    const Vec3 position = toVec3(leaf.position);
    const auto roundness = static_cast<float>(options.roundness);
    for (const MeshVertex& vertex : card.vertices) {
        const std::array<float, 3>& p = vertex.position;
        const Vec3 place =
            position + rotation * Vec3(p[0] * leaf.width, p[1] * leaf.length, p[2] * leaf.width);
        Vec3 normal = rotated(rotation, vertex.normal);
        Vec3 tangent = rotated(rotation, {vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]});
        if (roundness > 0.0F) {
            const Vec3 outward = (place - options.crownCentre).normalized();
            const Vec3 blended = (1.0F - roundness) * normal + roundness * outward;
            if (const float norm = blended.norm(); norm > 1e-3F)
                normal = blended / norm;
            tangent -= tangent.dot(normal) * normal;
            tangent = tangent.squaredNorm() > 1e-6F ? Vec3(tangent.normalized()) : anyPerpendicular(normal);
        }
        *vertices++ = {.position = toArray(place),
                       .normal = toArray(normal),
                       .tangent = {tangent.x(), tangent.y(), tangent.z(), vertex.tangent[3]},
                       .uv = vertex.uv};
    }
    for (const VertexIndex corner : card.indices)
        *indices++ = firstVertex + corner;
}

} // namespace

const LeafCard& leafCard(LeafShape shape)
{
    const auto relief = [](LeafShape of, float arch, float tip, float fold) {
        return Relief{static_cast<float>(usualAspect(of)), arch, tip, fold};
    };
    using enum LeafShape;
    static const std::array<LeafCard, kLeafShapeCount + 1> cards{
        foldedCard(relief(Ovate, 0.06F, 0.2F, 0.1F), 0.1F, 0.66F),
        foldedCard(relief(Lanceolate, 0.25F, 0.9F, 0.12F), 0.12F, 0.7F),
        foldedCard(relief(Lobed, 0.05F, 0.16F, 0.08F), 0.14F, 0.9F),
        crossedCards(),
        foldedCard(relief(Cordate, 0.05F, 0.2F, 0.1F), 0.0F, 0.74F),
        wholeCard(relief(Palmate, 0.05F, 0.22F, 0.06F), 2),
        wholeCard(relief(Pinnate, 0.08F, 0.3F, 0.12F), 2),
        foldedCard(relief(Willow, 0.4F, 1.4F, 0.1F), 0.1F, 0.72F),
        crossedCards(),
        wholeCard(relief(Frond, 0.3F, 1.1F, 0.25F), 5),
        wholeCard(relief(Own, 0.06F, 0.2F, 0.08F), 3),
    };
    return cards[static_cast<std::size_t>(shape)];
}

TriangleMesh expandLeaves(std::span<const LeafInstance> leaves, const LeafMeshOptions& options)
{
    std::vector<MeshSize> first;
    first.reserve(leaves.size() + 1);
    MeshSize total;
    for (const LeafInstance& leaf : leaves) {
        first.push_back(total);
        if (leaf.length > 0.0F) {
            const LeafCard& card = leafCard(static_cast<LeafShape>(leaf.shape));
            total.vertices += static_cast<std::uint32_t>(card.vertices.size());
            total.indices += static_cast<std::uint32_t>(card.indices.size());
        }
    }

    TriangleMesh mesh;
    mesh.vertices.resize(total.vertices);
    mesh.indices.resize(total.indices);
    parallelFor(leaves.size(), kLeavesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (leaves[i].length > 0.0F)
                expand(leaves[i], options, mesh.vertices.data() + first[i].vertices,
                       mesh.indices.data() + first[i].indices, first[i].vertices);
        }
    });
    return mesh;
}

} // namespace espalier
