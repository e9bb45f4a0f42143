// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/shape/AdventitiousBuds.h"

#include "model/base/Random.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

constexpr double kBudGoldenAngle = radians(137.507764);
/// How far a bud turns from the bark's normal to the light: the weight of the light's direction.
constexpr float kTowardLight = 0.5F;
/// A bud breaks through the bark by so many tip diameters, and this share of the branch's radius, which grows
/// when the branch carries the bud.
constexpr float kOutInTips = 1.0F;
constexpr float kOutInRadii = 0.06F;
/// Directions in which a bud looks for light: straight up, and in two rings.
constexpr int kLooksAround = 6;

/// An axis as a chain, from its base to its tip.
struct AxisChain {
    std::vector<InternodeId> internodes;
    std::vector<float> ends; ///< Distance of each node from the axis's base along it, m

    AxisChain(const Tree& tree, const TreeIndex& index, InternodeId id)
    {
        float end = 0.0F;
        for (InternodeId on = index.axis(id); on != kNoInternode; on = index.mainChild(on)) {
            end += tree.length(on);
            internodes.push_back(on);
            ends.push_back(end);
        }
    }

    float length() const { return ends.back(); }
    /// The internode at a distance from the base, and the place on it, 0...1.
    std::pair<InternodeId, float> at(const Tree& tree, float distance) const
    {
        const auto found = std::ranges::lower_bound(ends, distance);
        const auto i = std::min(static_cast<std::size_t>(found - ends.begin()), ends.size() - 1);
        const float below = ends[i] - tree.length(internodes[i]);
        const float length = tree.length(internodes[i]);
        return {internodes[i], length > 0.0F ? std::clamp((distance - below) / length, 0.0F, 1.0F) : 1.0F};
    }
};

Vec3 onAxis(const Tree& tree, const TreeIndex& index, InternodeId id, float along)
{
    return index.nodePosition(id) - (1.0F - along) * tree.length(id) * index.heading(id);
}

/// The direction from which most light comes to @p place, among those of the upper half ball.
Vec3 lightDirection(const Vec3& place, const BudSurroundings& surroundings)
{
    Vec3 sum = surroundings.lightAt(place + surroundings.reach * up()) * up();
    for (const double elevation : {radians(15), radians(50)}) {
        for (int i = 0; i < kLooksAround; ++i) {
            const double azimuth = 2.0 * std::numbers::pi * i / kLooksAround;
            const Vec3 look(static_cast<float>(std::cos(elevation) * std::cos(azimuth)),
                            static_cast<float>(std::sin(elevation)),
                            static_cast<float>(std::cos(elevation) * std::sin(azimuth)));
            sum += surroundings.lightAt(place + surroundings.reach * look) * look;
        }
    }
    return sum.norm() > 1e-6F ? Vec3(sum.normalized()) : up();
}

} // namespace

std::vector<BarkBud> placeBuds(const Tree& tree, const TreeIndex& index, const BudSpiral& spiral,
                               const BudSurroundings& surroundings)
{
    std::vector<BarkBud> buds;
    const InternodeId id = spiral.internode;
    if (id >= tree.size() || !tree.isAlive(id))
        return buds;
    const AxisChain axis(tree, index, id);
    const auto nth = std::ranges::find(axis.internodes, id) - axis.internodes.begin();
    const auto along = static_cast<float>(std::clamp(spiral.along, 0.0, 1.0));
    const float pressed = axis.ends[static_cast<std::size_t>(nth)] - (1.0F - along) * tree.length(id);

    const int count = std::clamp(spiral.count, 1, BudSpiral::kMostBuds);
    const int middle = (count - 1) / 2;
    const float spacing = std::min(static_cast<float>(std::max(spiral.spacing, 0.0)),
                                   axis.length() / static_cast<float>(std::max(1, count - 1)));
    const float span = spacing * static_cast<float>(count - 1);
    const float first = std::clamp(pressed - spacing * static_cast<float>(middle), 0.0F,
                                   std::max(0.0F, axis.length() - span));

    const Vec3 heading = index.heading(id);
    const Rotation& frame = index.rotation(id);
    for (int i = 0; i < count; ++i) {
        const float distance = first + spacing * static_cast<float>(i);
        const auto [on, onAlong] = axis.at(tree, distance);
        // The spiral goes on where the axis bends, whatever the rolls of the internodes' frames are.
        const double azimuth = radians(spiral.azimuth) + kBudGoldenAngle * (i - middle);
        const Vec3 aside =
            frame * Vec3(static_cast<float>(std::cos(azimuth)), 0.0F, static_cast<float>(std::sin(azimuth)));
        const Vec3 forward = index.heading(on);
        const Vec3 normal = Eigen::Quaternionf::FromTwoVectors(heading, forward) * aside;
        const float radius = surroundings.radius(on) * (1.0F + kOutInRadii) +
                             kOutInTips * static_cast<float>(tree.parameters().widths.tipDiameter);
        const Vec3 place = onAxis(tree, index, on, onAlong) + radius * normal;
        if (place.y() < 0.0F)
            continue;
        const Vec3 wanted = (normal + kTowardLight * lightDirection(place, surroundings)).normalized();
        // The branch begins where it has to so as to come out of the bark at the bud.
        const float back = radius * wanted.dot(forward) / std::max(wanted.dot(normal), 0.2F);
        const auto [base, baseAlong] = axis.at(tree, std::clamp(distance - back, 0.0F, axis.length()));
        const Vec3 from = onAxis(tree, index, base, baseAlong);
        buds.push_back({base, baseAlong, from, place, (place - from).normalized()});
    }
    return buds;
}

TreeDelta addBuds(const Tree& tree, const TreeIndex& index, const std::vector<BarkBud>& buds)
{
    TreeDelta delta = deltaStartingAt(tree);
    if (buds.empty())
        return delta;
    delta.stepAfter = delta.stepBefore + 1;
    delta.born.count = static_cast<std::uint32_t>(buds.size());
    delta.rows = std::make_shared<TreeRows>();
    // A bud has no lateral buds yet; its branch makes some.
    BudStates states = BudStates::active(kTerminalBud);
    for (int slot = 0; slot < tree.parameters().growth.lateralsPerNode; ++slot)
        states.set(slot, BudState::Dead);
    int slot = kFirstAdventitiousSlot; // different for each, whatever internode it is on
    for (const BarkBud& bud : buds) {
        const Rotation& parent = index.rotation(bud.internode);
        const InternodeKey key = childKey(tree.key(bud.internode), slot, delta.stepAfter);
        const Rotation turn(Eigen::Quaternionf::FromTwoVectors(index.heading(bud.internode), bud.direction));
        const double roll = Random(key, 0, Purpose::Phyllotaxis).uniform(0.0, 2.0 * std::numbers::pi);
        const Rotation spin(Eigen::Quaternionf(Eigen::AngleAxisf(static_cast<float>(roll), Vec3::UnitY())));
        delta.rows->internodes.append({.parent = bud.internode,
                                       .along = bud.along,
                                       .rotation = (parent.conjugate() * (turn * parent) * spin).normalized(),
                                       .length = (bud.place - bud.base).norm(),
                                       .vigour = 1.0F,
                                       .slot = static_cast<std::uint8_t>(slot++),
                                       .buds = states,
                                       .birth = delta.stepAfter,
                                       .parameterSet = static_cast<std::uint16_t>(tree.currentParameterSet()),
                                       .key = key});
    }
    return delta;
}

} // namespace espalier
