// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/TreeVariation.h"

#include "model/base/Random.h"
#include "model/sketch/SketchText.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace espalier {

namespace {

/// Standard deviations with an amount of 1; see varied().
constexpr double kRotationDeviation = radians(25);
constexpr double kDownDeviation = radians(10);
constexpr double kNodeDeviation = radians(4);
constexpr double kBranchLengthDeviation = 0.2;
constexpr double kInternodeLengthDeviation = 0.1;

Eigen::Quaterniond turnAround(double angle, const Eigen::Vector3d& axis)
{
    return Eigen::Quaterniond(Eigen::AngleAxisd(angle, axis));
}

/// The local rotation of a branch's first internode, turned around the parent and toward or away from it.
Eigen::Quaterniond variedBranch(const Eigen::Quaterniond& local, double amount, Random& random)
{
    const Eigen::Vector3d along = Eigen::Vector3d::UnitY();
    const double around = amount * kRotationDeviation * random.normal();
    const double away = amount * kDownDeviation * random.normal();
    const Eigen::Vector3d hinge = along.cross(local * along);
    const Eigen::Vector3d axis =
        hinge.norm() > 1e-6 ? Eigen::Vector3d(hinge.normalized()) : Eigen::Vector3d(Eigen::Vector3d::UnitX());
    return turnAround(around, along) * turnAround(away, axis) * local;
}

/// The local rotation of an internode that continues its axis, turned in any direction.
Eigen::Quaterniond variedContinuation(const Eigen::Quaterniond& local, double amount, Random& random)
{
    const double azimuth = random.uniform(0.0, 2.0 * std::numbers::pi);
    const Eigen::Vector3d axis(std::cos(azimuth), 0.0, std::sin(azimuth));
    return turnAround(amount * kNodeDeviation * random.normal(), axis) * local;
}

} // namespace

Result<TreeDelta> varied(const Tree& tree, const TreeIndex& index, std::uint64_t seed, double amount)
{
    TreeDelta delta = deltaStartingAt(tree);
    const double share = std::clamp(amount, 0.0, 1.0);
    if (!(share > 0.0))
        return delta;
    const std::uint64_t seedBits = mixedBits(seed);
    const auto bitsOf = [&](InternodeId id) { return mixedBits(tree.key(id) ^ seedBits); };
    const InternodeColumns& c = tree.columns();
    std::vector<Placement> places(tree.size());
    std::vector<float> lengths(tree.size(), 0.0F);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        Random random(bitsOf(id), 0, Purpose::Direction);
        const Eigen::Quaterniond local = c.rotation[id].cast<double>();
        Eigen::Quaterniond turned;
        if (tree.isRoot(id))
            turned = turnAround(share * random.uniform(-std::numbers::pi, std::numbers::pi),
                                Eigen::Vector3d::UnitY()) *
                     local;
        else
            turned = tree.continuesAxis(id) ? variedContinuation(local, share, random)
                                            : variedBranch(local, share, random);
        const Rotation rotation(turned.normalized().cast<float>());

        Random branch(bitsOf(index.axis(id)), 1, Purpose::InternodeLength);
        Random own(bitsOf(id), 2, Purpose::InternodeLength);
        const double exponent =
            share * (kBranchLengthDeviation * branch.normal() + kInternodeLengthDeviation * own.normal());
        lengths[id] = static_cast<float>(std::exp(exponent) * double{c.length[id]});

        Placement below{tree.rootPosition(id), Rotation::Identity()};
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode) {
            below = places[parent];
            below.node -= (1.0F - c.along[id]) * lengths[parent] * (below.rotation * Vec3(Vec3::UnitY()));
        }
        places[id] = placeOn(below.node, below.rotation, rotation, lengths[id]);
        if (!isFrame(rotation, lengths[id]) || !(places[id].node.cwiseAbs().maxCoeff() <= kFarthestNode))
            return Error{Error::Kind::Input,
                         SketchText::tr("an internode would be longer than %1 m or lie more than %2 m away")
                             .arg(static_cast<double>(kGreatestLength))
                             .arg(static_cast<double>(kFarthestNode))};
        delta.addFrame(id, c.rotation[id], rotation, c.length[id], lengths[id]);
    }
    return delta;
}

} // namespace espalier
