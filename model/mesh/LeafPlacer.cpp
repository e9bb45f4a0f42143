// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LeafPlacer.h"

#include "model/base/Parallel.h"
#include "model/base/Random.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/Tubes.h"
#include "model/texture/Textures.h"

#include <cassert>
#include <cmath>

namespace espalier {

namespace {

constexpr std::size_t kTubesPerTask = 256;
/// The diameter of the thickest wood with leaves, where the user has set it, in lengths of a leaf.
constexpr double kThickestShoot = 0.4;
/// The farthest that a leaf card reaches from its petiole, in lengths and widths.
constexpr float kLongestReach = 1.5F;
/// Number of steps in half a turn upward.
constexpr int kGroundTurns = 18;
/// Spread of a leaf's direction at full irregularity, as a share of its length: about 20°.
constexpr float kMostJitter = 0.36F;
constexpr float kSmallestSize = 0.1F;
/// How much darker the leaves of the weakest shoots are, at full effect of vigour on colour.
constexpr double kWeakDarkening = 0.1;
/// Radians between one leaf and the next of a spiral.
constexpr double kGoldenAngle = std::numbers::pi * (3.0 - 2.2360679774997896964);
/// Weight of an upright shoot's own plane relative to the level one, whose weight grows with the shoot's
/// lean.
constexpr float kOwnPlane = 0.25F;
/// How far a flat spray turns from one node to the next toward the plane that it shall have: by some 17° at
/// most.
constexpr float kLevelling = 0.3F;
/// Sine of the angle between wood and midrib below which a placed leaf's base moves into the wood.
constexpr float kAlongWood = 0.2F;
/// Hues from here on shift through magenta, smaller ones through green and yellow.
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

/// @p vector, which is perpendicular to the unit vector @p from, carried by the least turn from @p from to
/// the unit vector @p to; its length stays. Where the direction is reversed, the vector stays.
Vec3 carriedAcross(const Vec3& vector, const Vec3& from, const Vec3& to)
{
    const float cosine = from.dot(to);
    const Vec3 turned =
        cosine > -0.9999F ? Vec3(vector - vector.dot(to) / (1.0F + cosine) * (from + to)) : vector;
    // Rounding would add up over a long axis.
    return across(turned, to);
}

/// The level vector across an axis, on the side of @p side; its length is the sine of the axis's lean.
Vec3 levelSide(const Vec3& axis, const Vec3& side)
{
    const Vec3 level = axis.cross(up());
    return level.dot(side) < 0.0F ? Vec3(-level) : level;
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

LeafRule::LeafRule(const Tree& tree, const TreeIndex& index) : m_tree(tree), m_index(index)
{
    const LeafParameters& leaves = tree.parameters().leaves;
    const int perNode = leaves.visible ? std::clamp(leaves.perNode, 0, static_cast<int>(kMost)) : 0;
    m_perNode = static_cast<std::uint32_t>(perNode);
    m_maxTips = static_cast<std::uint32_t>(std::max(0, leaves.maxTips));
    m_reach = static_cast<std::uint32_t>(std::max(0, leaves.reach));
    m_thickest = static_cast<float>(kThickestShoot * leaves.length);
}

std::uint32_t LeafRule::count(std::span<const InternodeId> internodes) const
{
    const auto bearing = std::ranges::count_if(internodes, [this](InternodeId id) { return bears(id); });
    return static_cast<std::uint32_t>(bearing) * m_perNode;
}

LeafPlacer::LeafPlacer(const Tree& tree, const TreeIndex& index, const Widths& widths,
                       std::span<const WoodLine> strands, const PlacedLeafIndex* placed)
    : m_tree(tree),
      m_index(index),
      m_wood(tree, index, widths, strands),
      m_rule(tree, index),
      m_ownPlaced(placed == nullptr ? std::make_unique<const PlacedLeafIndex>(tree) : nullptr),
      m_placed(placed == nullptr ? m_ownPlaced.get() : placed),
      m_parameters(tree.parameters().leaves),
      m_perNode(m_rule.leavesPerInternode())
{
    m_jitter = kMostJitter * static_cast<float>(tree.parameters().growth.irregularity);
    m_cosine = static_cast<float>(std::cos(m_parameters.angle));
    m_sine = static_cast<float>(std::sin(m_parameters.angle));
    // Needles, and leaves that stand one by one, are spread along the shoot; other leaves are at its nodes.
    m_alongInternode = (m_parameters.shape == LeafShape::Needles && m_parameters.image.isNull()) ||
                       m_parameters.arrangement == LeafArrangement::Spiral ||
                       m_parameters.arrangement == LeafArrangement::Flat;
    for (std::uint32_t i = 0; i < m_perNode; ++i) {
        const double azimuth = 2.0 * std::numbers::pi * i / m_perNode;
        m_azimuths[i] = Eigen::Vector2d(std::cos(azimuth), std::sin(azimuth)).cast<float>();
    }
}

/// What an axis begins with. The side never vanishes.
LeafPlacer::Carried LeafPlacer::firstOf(InternodeId first) const
{
    const double azimuth =
        Random(m_tree.key(first), 0, Purpose::LeafPlane).uniform(0.0, 2.0 * std::numbers::pi);
    const Vec3 level(static_cast<float>(std::cos(azimuth)), 0.0F, static_cast<float>(std::sin(azimuth)));
    const Vec3 axis = m_wood.axis(first);
    const Vec3 own = kOwnPlane * across(level, axis);
    return {0, axis, own, (levelSide(axis, own) + own).normalized()};
}

/// Goes from a node to the one that follows on the axis.
void LeafPlacer::carryTo(InternodeId next, Carried& carried) const
{
    const Vec3 axis = m_wood.axis(next);
    if (m_parameters.arrangement != LeafArrangement::Shoot)
        carried.side = carriedAcross(carried.side, carried.axis, axis).normalized();
    if (m_parameters.arrangement == LeafArrangement::Flat) {
        carried.own = carriedAcross(carried.own, carried.axis, axis);
        const Vec3 plane = levelSide(axis, carried.side) + carried.own;
        carried.side = (carried.side + kLevelling * plane).normalized();
    }
    carried.axis = axis;
    ++carried.below;
}

LeafPlacer::Carried LeafPlacer::carriedTo(InternodeId id) const
{
    if (m_parameters.arrangement == LeafArrangement::Shoot)
        return {0, m_wood.axis(id), Vec3::UnitX(), Vec3::UnitX()};
    const InternodeId first = m_index.axis(id);
    std::vector<InternodeId> path;
    for (InternodeId place = id; place != first; place = m_tree.parent(place))
        path.push_back(place);
    Carried carried = firstOf(first);
    for (auto place = path.rbegin(); place != path.rend(); ++place)
        carryTo(*place, carried);
    return carried;
}

LeafPlacer::Stand LeafPlacer::stand(std::uint32_t i, const Carried& carried,
                                    const Eigen::Matrix3f& frame) const
{
    const auto& [below, axis, own, side] = carried;
    const float along = m_alongInternode ? static_cast<float>(i) / static_cast<float>(m_perNode) : 0.0F;
    // Counted from the axis's foot; the first leaf of an internode is the uppermost.
    const std::uint32_t number = below * m_perNode + (m_perNode - 1 - i);
    double azimuth = 0.0;
    switch (m_parameters.arrangement) {
    case LeafArrangement::Shoot:
        return {frame.col(0) * m_azimuths[i].x() + frame.col(2) * m_azimuths[i].y(), axis, along};
    case LeafArrangement::Flat: {
        // The leaves of a level spray face the sky, those of an upright shoot face along it.
        const Vec3 normal = side.cross(axis);
        const Vec3 face = normal.y() * normal + (1.0F - std::abs(normal.y())) * axis;
        return {number % 2 == 0 ? side : Vec3(-side), face, along};
    }
    case LeafArrangement::Spiral:
        azimuth = std::fmod(kGoldenAngle * number, 2.0 * std::numbers::pi);
        break;
    case LeafArrangement::Opposite:
        azimuth = std::numbers::pi * (2 * i + below % 2) / m_perNode;
        break;
    }
    const Vec3 third = side.cross(axis);
    return {static_cast<float>(std::cos(azimuth)) * side + static_cast<float>(std::sin(azimuth)) * third,
            axis, along};
}

void LeafPlacer::place(InternodeId id, std::span<LeafInstance> leaves) const
{
    place(id, carriedTo(id), leaves);
}

void LeafPlacer::place(InternodeId id, const Carried& carried, std::span<LeafInstance> leaves) const
{
    assert(leaves.size() == m_perNode);
    Random random(m_tree.key(id), 0, Purpose::Leaf);
    const WoodLine wood = m_wood.of(id);
    const Vec3& axis = wood.axis;
    // The shoot's own frame, in the direction of the wood.
    const Rotation grown = m_index.rotation(id);
    const Eigen::Matrix3f frame =
        (Rotation::FromTwoVectors(grown * up(), axis) * grown).normalized().toRotationMatrix();
    const auto droop = static_cast<float>(m_parameters.droop);
    const auto upward = static_cast<float>(m_parameters.upward);
    const Look look = lookOf(id);

    for (std::uint32_t i = 0; i < m_perNode; ++i) {
        const std::array<float, 4> spread = fourSigned(random);
        const std::array<float, 4> variation = fourSigned(random);
        const auto [outward, face, along] = stand(i, carried, frame);
        Vec3 direction = m_cosine * axis + m_sine * outward;
        direction = (1.0F - droop) * direction - droop * up();
        direction += m_jitter * Vec3(spread[0], spread[1], spread[2]);
        const float norm = direction.norm();
        direction = norm > 1e-3F ? Vec3(direction / norm) : outward;

        // The upper face turns from its natural direction toward the sky as far as the leaf can turn.
        Vec3 normal = across(face, direction);
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

        const float size =
            std::max(kSmallestSize, 1.0F + static_cast<float>(m_parameters.sizeVariation) * variation[0]);
        const auto leafLength = static_cast<float>(m_parameters.length) * size;
        leaves[i] = {
            .position = toArray(wood.upper + along * (wood.lower - wood.upper) + wood.radius * outward),
            .length = leafLength,
            .rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()},
            .width = leafLength * static_cast<float>(m_parameters.aspect),
            .hueShift = static_cast<float>(look.hueShift + m_parameters.hueVariation * variation[1]),
            .value = look.value,
            .shape = shape(),
        };
        keepAboveGround(leaves[i], turned);
    }
}

LeafPlacer::Look LeafPlacer::lookOf(InternodeId id) const
{
    const double shift = m_parameters.vigourHue * shootWeakness(m_tree.vigour(id));
    return {shiftedLeafHue(m_parameters.hue, shift) - kLeafTextureHue,
            static_cast<float>(m_parameters.brightness * (1.0 - kWeakDarkening * shift))};
}

std::int32_t LeafPlacer::shape() const
{
    return static_cast<std::int32_t>(m_parameters.image.isNull() ? m_parameters.shape : LeafShape::Own);
}

std::uint32_t LeafPlacer::placedCount(InternodeId id) const
{
    std::uint32_t count = 0;
    for (LeafId leaf = m_placed->first(id); leaf != kNoLeaf; leaf = m_placed->next(leaf))
        count += isPlacedLeafShown(m_tree, leaf) ? 1 : 0;
    return count;
}

/// Writes the placed leaves of one living internode to the begin of @p leaves; returns their number.
std::uint32_t LeafPlacer::showPlaced(InternodeId id, std::span<LeafInstance> leaves) const
{
    if (m_placed->first(id) == kNoLeaf)
        return 0;
    const LeafColumns& rows = m_tree.placedLeaves();
    const WoodLine wood = m_wood.of(id);
    const Rotation grown = m_index.rotation(id);
    const Rotation frame = Rotation::FromTwoVectors(grown * up(), wood.axis) * grown;
    const float reach = (wood.upper - wood.lower).norm();
    const Look look = lookOf(id);
    std::uint32_t shown = 0;
    std::uint32_t number = 0; // 0 is that of the leaves by rule
    for (LeafId leaf = m_placed->first(id); leaf != kNoLeaf; leaf = m_placed->next(leaf)) {
        ++number;
        if (!isPlacedLeafShown(m_tree, leaf))
            continue;
        Random random(m_tree.key(id), number, Purpose::Leaf);
        const float hue = fourSigned(random)[0];
        const Rotation rotation = (frame * rows.rotation[leaf]).normalized();
        const Vec3 outward = across(rotation * Vec3(Vec3::UnitY()), wood.axis);
        // The wood of a branch begins where it leaves thicker wood.
        const float down = std::min((1.0F - rows.along[leaf]) * m_tree.length(id), reach);
        const Vec3 bark = wood.radius / std::max(outward.norm(), kAlongWood) * outward;
        leaves[shown++] = {
            .position = toArray(wood.upper - down * wood.axis + bark),
            .length = rows.length[leaf],
            .rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()},
            .width = rows.length[leaf] * static_cast<float>(m_parameters.aspect),
            .hueShift = static_cast<float>(look.hueShift + m_parameters.hueVariation * hue),
            .value = look.value,
            .shape = shape(),
        };
    }
    return shown;
}

std::uint32_t LeafPlacer::count(std::span<const InternodeId> internodes) const
{
    std::uint32_t count = m_rule.count(internodes);
    if (!m_placed->isEmpty()) {
        for (const InternodeId id : internodes)
            count += placedCount(id);
    }
    return count;
}

/// @p frame is the leaf's rotation as a matrix.
void LeafPlacer::keepAboveGround(LeafInstance& leaf, const Eigen::Matrix3f& frame) const
{
    if (leaf.position[1] > kLongestReach * (leaf.length + leaf.width))
        return;
    const std::vector<MeshVertex>& card = leafCard(static_cast<LeafShape>(leaf.shape)).vertices;
    const Vec3 size(leaf.width, leaf.length, leaf.width);
    const auto isAbove = [&](const Eigen::Matrix3f& turned) {
        const Vec3 heights = turned.row(1).transpose().cwiseProduct(size);
        return std::ranges::all_of(card, [&](const MeshVertex& vertex) {
            return leaf.position[1] + heights.dot(toVec3(vertex.position)) >= 0.0F;
        });
    };
    if (isAbove(frame))
        return;
    // Turns about the level line across the midrib; a leaf that hangs straight down turns in the direction of
    // its face.
    Vec3 axis = frame.col(1).cross(up());
    axis = axis.norm() > 1e-3F ? Vec3(axis.normalized()) : Vec3(frame.col(0));
    for (int i = 1; i <= kGroundTurns && leaf.position[1] >= 0.0F; ++i) {
        const float angle = static_cast<float>(i) * std::numbers::pi_v<float> / kGroundTurns;
        const Eigen::Matrix3f turned = Eigen::AngleAxisf(angle, axis).toRotationMatrix() * frame;
        if (!isAbove(turned))
            continue;
        const Rotation rotation(turned);
        leaf.rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
        return;
    }
    leaf.length = 0.0F;
}

void LeafPlacer::place(std::span<const InternodeId> internodes, std::span<LeafInstance> leaves) const
{
    if (leaves.empty())
        return;
    std::size_t done = 0;
    Carried carried;
    InternodeId previous = kNoInternode;
    for (const InternodeId id : internodes) {
        if (m_perNode > 0) {
            // A lateral begins another axis.
            if (previous != kNoInternode && m_tree.parent(id) == previous && m_index.axis(id) != id)
                carryTo(id, carried);
            else
                carried = carriedTo(id);
            previous = id;
        }
        if (m_rule.bears(id)) {
            place(id, carried, leaves.subspan(done, m_perNode));
            done += m_perNode;
        }
        done += showPlaced(id, leaves.subspan(done));
    }
    assert(done == leaves.size());
}

MeshBuffer<LeafInstance> placeLeaves(const Tree& tree, const TreeIndex& index, const Widths& widths,
                                     std::span<const WoodLine> strands)
{
    const LeafPlacer placer(tree, index, widths, strands);
    const std::vector<InternodeId> tubes = tubesOf(tree, index);
    // The internodes of all tubes, one after the other.
    std::vector<InternodeId> internodes;
    std::vector<std::size_t> begins;
    std::vector<std::size_t> first{0};
    for (const InternodeId base : tubes) {
        begins.push_back(internodes.size());
        for (InternodeId id = base; id != kNoInternode; id = tubeContinuation(index, id))
            internodes.push_back(id);
        first.push_back(first.back() + placer.count(std::span(internodes).subspan(begins.back())));
    }
    begins.push_back(internodes.size());

    MeshBuffer<LeafInstance> leaves(first.back());
    parallelFor(tubes.size(), kTubesPerTask, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            placer.place(std::span(internodes).subspan(begins[i], begins[i + 1] - begins[i]),
                         std::span(leaves).subspan(first[i], first[i + 1] - first[i]));
    });
    return leaves;
}

} // namespace espalier
