// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LeafPlacer.h"

#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "model/mesh/Textures.h"
#include "model/mesh/Tubes.h"

#include <cassert>
#include <cmath>

namespace espalier {

namespace {

constexpr std::size_t kTubesPerTask = 256;
/// Spread of a leaf's direction at full irregularity, as a share of its length: about 20°.
constexpr float kMostJitter = 0.36F;
constexpr float kSmallestSize = 0.1F;
/// How much darker the leaves of the weakest shoots are, at full effect of vigour on colour.
constexpr double kWeakDarkening = 0.1;
/// Hues from here on shift through magenta, the others through green and yellow.
constexpr double kBlue = radians(240);

/// Four numbers in -1...1 out of 64 random bits.
std::array<float, 4> fourSigned(Random& random)
{
    const std::uint64_t bits = random.bits();
    std::array<float, 4> numbers;
    for (unsigned i = 0; i < 4; ++i)
        numbers[i] = static_cast<float>((bits >> (16 * i)) & 0xffffU) * (2.0F / 65535.0F) - 1.0F;
    return numbers;
}

/// The component of @p vector perpendicular to the unit vector @p direction.
Vec3 across(const Vec3& vector, const Vec3& direction)
{
    return vector - vector.dot(direction) * direction;
}

} // namespace

double shootWeakness(double vigour, double reference)
{
    return reference > 0.0 ? std::clamp(1.0 - vigour / reference, 0.0, 1.0) : 0.0;
}

double shiftedLeafHue(double hue, double amount)
{
    const double red = hue < kBlue ? kLeafWeakHue : kLeafWeakHue + 2.0 * std::numbers::pi;
    return hue + amount * (red - hue);
}

LeafPlacer::LeafPlacer(const Tree& tree, const TreeIndex& index)
    : m_tree(tree), m_index(index), m_parameters(tree.parameters().leaves)
{
    const int perNode =
        m_parameters.visible ? std::clamp(m_parameters.perNode, 0, static_cast<int>(m_azimuths.size())) : 0;
    m_perNode = static_cast<std::uint32_t>(perNode);
    m_maxTips = static_cast<std::uint32_t>(std::max(0, m_parameters.maxTips));
    m_reach = static_cast<std::uint32_t>(std::max(0, m_parameters.reach));
    m_jitter = kMostJitter * static_cast<float>(tree.parameters().growth.irregularity);
    m_cosine = static_cast<float>(std::cos(m_parameters.angle));
    m_sine = static_cast<float>(std::sin(m_parameters.angle));
    // Needles clothe the whole shoot; leaves sit at its nodes.
    m_alongInternode = m_parameters.shape == LeafShape::Needles && m_parameters.image.isNull();
    for (int i = 0; i < perNode; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / perNode;
        m_azimuths[static_cast<std::size_t>(i)] =
            Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth)).cast<float>();
    }
}

void LeafPlacer::place(InternodeId id, std::span<LeafInstance> leaves) const
{
    assert(leaves.size() == m_perNode);
    Random random(m_tree.seed(), 0, id, Purpose::Leaf);
    const Vec3 node = m_index.nodePosition(id);
    const Eigen::Matrix3f frame = m_index.rotation(id).toRotationMatrix();
    const Vec3 axis = frame.col(1);
    const float length = m_tree.length(id);
    const auto droop = static_cast<float>(m_parameters.droop);
    const auto upward = static_cast<float>(m_parameters.upward);
    const double shift = m_parameters.vigourHue * shootWeakness(m_tree.vigour(id));
    const double hue = shiftedLeafHue(m_parameters.hue, shift);
    const auto value = static_cast<float>(m_parameters.brightness * (1.0 - kWeakDarkening * shift));

    for (std::uint32_t i = 0; i < m_perNode; ++i) {
        const std::array<float, 4> spread = fourSigned(random);
        const std::array<float, 4> variation = fourSigned(random);
        const Vec3 outward = frame.col(0) * m_azimuths[i].x() + frame.col(2) * m_azimuths[i].y();
        Vec3 direction = m_cosine * axis + m_sine * outward;
        direction = (1.0F - droop) * direction - droop * up();
        direction += m_jitter * Vec3(spread[0], spread[1], spread[2]);
        const float norm = direction.norm();
        direction = norm > 1e-3F ? Vec3(direction / norm) : outward;

        // The upper face looks along the shoot by nature, and to the sky as far as the leaf can turn.
        Vec3 normal = across(axis, direction);
        if (normal.squaredNorm() < 1e-6F)
            normal = across(-outward, direction);
        normal.normalize();
        Vec3 sky = across(up(), direction);
        const float skyNorm = sky.norm();
        if (upward > 0.0F && skyNorm > 1e-4F) {
            sky /= skyNorm;
            if (normal.dot(sky) < 0.0F)
                normal = -normal;
            normal = ((1.0F - upward) * normal + upward * sky).normalized();
        }
        Eigen::Matrix3f turned;
        turned.col(0) = direction.cross(normal);
        turned.col(1) = direction;
        turned.col(2) = normal;
        const Rotation rotation(turned);

        const auto along = m_alongInternode ? static_cast<float>(i) / static_cast<float>(m_perNode) : 0.0F;
        const float size =
            std::max(kSmallestSize, 1.0F + static_cast<float>(m_parameters.sizeVariation) * variation[0]);
        const auto leafLength = static_cast<float>(m_parameters.length) * size;
        leaves[i] = {
            .position = toArray(node - along * length * axis),
            .length = leafLength,
            .rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()},
            .width = leafLength * static_cast<float>(m_parameters.aspect),
            .hueShift = static_cast<float>(hue - kLeafTextureHue + m_parameters.hueVariation * variation[1]),
            .value = value,
            .shape =
                static_cast<std::int32_t>(m_parameters.image.isNull() ? m_parameters.shape : LeafShape::Own),
        };
    }
}

std::uint32_t LeafPlacer::count(InternodeId base) const
{
    std::uint32_t bearing = 0;
    for (InternodeId id = base; id != kNoInternode; id = tubeContinuation(m_index, id))
        bearing += bears(id) ? 1 : 0;
    return bearing * m_perNode;
}

void LeafPlacer::placeTube(InternodeId base, std::span<LeafInstance> leaves) const
{
    std::size_t done = 0;
    for (InternodeId id = base; id != kNoInternode; id = tubeContinuation(m_index, id)) {
        if (!bears(id))
            continue;
        place(id, leaves.subspan(done, m_perNode));
        done += m_perNode;
    }
    assert(done == leaves.size());
}

MeshBuffer<LeafInstance> placeLeaves(const Tree& tree, const TreeIndex& index)
{
    const LeafPlacer placer(tree, index);
    const std::vector<InternodeId> tubes = tubesOf(tree, index);
    std::vector<std::size_t> first(tubes.size() + 1, 0);
    for (std::size_t i = 0; i < tubes.size(); ++i)
        first[i + 1] = first[i] + placer.count(tubes[i]);

    MeshBuffer<LeafInstance> leaves(first.back());
    parallelFor(tubes.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            placer.placeTube(tubes[i], std::span(leaves).subspan(first[i], first[i + 1] - first[i]));
    });
    return leaves;
}

} // namespace espalier
