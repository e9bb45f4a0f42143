// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/BruteForce.h"

#include "model/growth/Buds.h"

#include <array>
#include <cmath>
#include <set>

namespace espalier::test {

namespace {

using Vec3d = Eigen::Vector3d;

/// More than the error of a float, in m or as a cosine.
constexpr double kLeast = 2e-5;

bool hasBuds(const GrowingTree& tree, InternodeId id)
{
    return (tree.isNew(id) || tree.tree().isAlive(id)) && tree.buds(id) != 0;
}

Vec3d directionOf(const GrowingTree& tree, const BudRef& bud)
{
    return budDirection(tree.key(bud.node), bud.slot, tree.rotation(bud.node), tree.grownWith(bud.node))
        .cast<double>();
}

bool mayCompete(const GrowingTree& tree, const Competitors& competitors, const BudRef& bud)
{
    if (competitors.node == kNoInternode || (bud.node == competitors.node && bud.slot == competitors.slot))
        return true;
    for (InternodeId id = bud.node; id != kNoInternode; id = tree.parent(id)) {
        if (tree.parent(id) == competitors.node && tree.slot(id) == competitors.slot)
            return true;
    }
    return false;
}

/// A bud that perceives a marker.
struct Claim {
    BudRef bud;
    double distance;
    double alignment; ///< cosine
};

std::vector<Claim> claims(const GrowingTree& tree, const Perception& perception,
                          const Competitors& competitors, const Vec3& marker)
{
    std::vector<Claim> found;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!hasBuds(tree, id))
            continue;
        const Vec3d toMarker = (marker - tree.nodePosition(id)).cast<double>();
        for (int slot = 0; slot < 8; ++slot) {
            const BudRef bud{id, slot};
            if ((tree.buds(id) & budBit(slot)) == 0 || !mayCompete(tree, competitors, bud))
                continue;
            const double alignment = directionOf(tree, bud).dot(toMarker) / toMarker.norm();
            if (toMarker.norm() <= perception.reach && alignment >= perception.cosHalfAngle)
                found.push_back({bud, toMarker.norm(), alignment});
        }
    }
    std::ranges::sort(found, [](const Claim& a, const Claim& b) {
        return std::tuple(a.distance, -a.alignment, a.bud) < std::tuple(b.distance, -b.alignment, b.bud);
    });
    return found;
}

bool isOccupied(const GrowingTree& tree, const Perception& perception, const Vec3& marker)
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (hasBuds(tree, id) &&
            (marker - tree.nodePosition(id)).cast<double>().norm() < perception.occupancy)
            return true;
    }
    return false;
}

std::array<int, 3> voxelOf(const Vec3& position, const GrowthParameters& p)
{
    const auto edge = static_cast<float>(p.occupancyRadius * p.internodeLength);
    return {static_cast<int>(std::floor(position.x() / edge)),
            static_cast<int>(std::floor(position.y() / edge)),
            static_cast<int>(std::floor(position.z() / edge))};
}

/// Layers of the pyramid of shadow below @p caster in which @p shaded lies, or a negative number if it lies
/// outside.
int layersBelow(const std::array<int, 3>& caster, const std::array<int, 3>& shaded, int depth)
{
    const int q = caster[1] - shaded[1];
    return q <= depth && std::abs(caster[0] - shaded[0]) <= q && std::abs(caster[2] - shaded[2]) <= q ? q
                                                                                                      : -1;
}

/// Length of the ray from the axis in the direction χ inside the ellipse, with the ellipse squeezed to a unit
/// circle.
double distanceToEllipse(const GrowthParameters& p, double chi)
{
    const Eigen::Vector2d centre(p.ellipseOffset / p.ellipseVertical, 0.0);
    const Eigen::Vector2d ray(std::cos(chi) / p.ellipseVertical, std::sin(chi) / p.ellipseParallel);
    const double stretch = ray.norm();
    const Eigen::Vector2d direction = ray / stretch;
    const double along = direction.dot(centre);
    const double offLine = (centre - along * direction).norm();
    if (offLine >= 1.0)
        return 0.0;
    const double half = std::sqrt(1.0 - offLine * offLine);
    return (std::max(0.0, along + half) - std::max(0.0, along - half)) / stretch;
}

double bias(const Tree& tree, const TreeIndex& index, const BudRef& bud)
{
    const GrowthParameters& p = tree.parameters().growth;
    if (bud.slot == kTerminalSlot)
        return 1.0;
    const Vec3d y = Vec3d::UnitY();
    const Vec3d h = index.heading(bud.node).cast<double>();
    const Vec3d direction =
        budDirection(tree.key(bud.node), bud.slot, index.rotation(bud.node), tree.parametersOf(bud.node))
            .cast<double>();
    const double tau = std::acos(std::clamp(h.dot(y), -1.0, 1.0));
    const Vec3d across = direction - direction.dot(h) * h;
    if (std::sin(tau) < 1e-6 || across.norm() < 1e-6)
        return 1.0;
    const Vec3d top = (y - y.dot(h) * h).normalized();
    const double chi =
        std::acos(std::clamp(across.normalized().dot(top), -1.0, 1.0)); // the ellipse is symmetric
    return std::pow(std::cos(tau), 2) + distanceToEllipse(p, chi) * std::pow(std::sin(tau), 2);
}

} // namespace

BruteCompetition bruteCompetition(const GrowingTree& tree, const Perception& perception,
                                  const Competitors& competitors, const MarkerSet& markers)
{
    BruteCompetition result;
    std::map<BudRef, Vec3d> sums;
    for (const Vec3& marker : markers.positions) {
        if (isOccupied(tree, perception, marker))
            continue;
        result.freeMarkers.push_back(marker);
        const std::vector<Claim> all = claims(tree, perception, competitors, marker);
        if (all.empty())
            continue;
        const Vec3d toMarker = (marker - tree.nodePosition(all.front().bud.node)).cast<double>();
        sums.try_emplace(all.front().bud, Vec3d::Zero()).first->second += toMarker.normalized();
    }
    for (const auto& [bud, sum] : sums)
        result.enabled.push_back({bud, sum.normalized().cast<float>()});
    return result;
}

MarkerSet clearCut(const GrowingTree& tree, const Perception& perception, const MarkerSet& markers)
{
    MarkerSet kept = markers;
    kept.filter([&](std::size_t i) {
        std::vector<double> distances;
        for (InternodeId id = 0; id < tree.size(); ++id) {
            if (!hasBuds(tree, id))
                continue;
            const Vec3d toMarker = (markers.positions[i] - tree.nodePosition(id)).cast<double>();
            const double distance = toMarker.norm();
            if (std::abs(distance - perception.occupancy) < kLeast ||
                std::abs(distance - perception.reach) < kLeast)
                return false;
            if (distance > perception.reach)
                continue;
            distances.push_back(distance);
            std::vector<double> alignments;
            for (int slot = 0; slot < 8; ++slot) {
                if ((tree.buds(id) & budBit(slot)) == 0)
                    continue;
                const double alignment = directionOf(tree, {id, slot}).dot(toMarker) / distance;
                // With a full sphere of perception there is no border.
                if (perception.cosHalfAngle > -1.0F && std::abs(alignment - perception.cosHalfAngle) < kLeast)
                    return false;
                alignments.push_back(alignment);
            }
            std::ranges::sort(alignments);
            if (std::ranges::adjacent_find(alignments, [](double a, double b) { return b - a < kLeast; }) !=
                alignments.end())
                return false;
        }
        std::ranges::sort(distances);
        return std::ranges::adjacent_find(distances, [](double a, double b) { return b - a < kLeast; }) ==
               distances.end();
    });
    return kept;
}

std::int64_t bruteShadow(const Tree& tree, const TreeIndex& index, const Vec3& position)
{
    const GrowthParameters& p = tree.parameters().growth;
    std::int64_t sum = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        const int q = layersBelow(voxelOf(index.nodePosition(id), p), voxelOf(position, p), p.shadowDepth);
        if (q >= 0)
            sum += std::llround(p.shadowIntensity * std::pow(p.shadowFalloff, -q) * VoxelSpace::kShadowUnit);
    }
    return sum;
}

BruteVigour::BruteVigour(const Tree& tree, const TreeIndex& index)
{
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            m_children[tree.parent(id)].push_back(id);
    }
    into[0] = gather(tree, index, 0);
    distribute(tree, 0);
}

double BruteVigour::gather(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const GrowthParameters& p = tree.parameters().growth;
    const double shadow =
        static_cast<double>(bruteShadow(tree, index, index.nodePosition(id))) / VoxelSpace::kShadowUnit;
    const double light = std::clamp(1.0 - shadow + p.shadowIntensity, 0.0, 1.0);
    double sum = 0.0;
    for (int slot = 0; slot < 8; ++slot) {
        if ((tree.buds(id) & budBit(slot)) == 0)
            continue;
        const double q = bias(tree, index, {id, slot}) *
                         std::pow(static_cast<double>(static_cast<float>(light)), p.lightSensitivity);
        budQ[{id, slot}] = q;
        sum += q;
    }
    for (const InternodeId child : m_children[id])
        sum += gather(tree, index, child);
    return basipetal[id] = sum;
}

void BruteVigour::distribute(const Tree& tree, InternodeId id)
{
    const double lambda = tree.parameters().growth.apicalDominance;
    // All branches above the node, each with its Q: main first, then the laterals.
    double main = 0.0;
    double lateral = 0.0;
    const auto isMain = [&](InternodeId child) { return tree.columns().slot[child] == kTerminalSlot; };
    for (const InternodeId child : m_children[id])
        (isMain(child) ? main : lateral) += basipetal[child];
    for (int slot = 0; slot < 8; ++slot) {
        if ((tree.buds(id) & budBit(slot)) != 0)
            (slot == kTerminalSlot ? main : lateral) += budQ[{id, slot}];
    }
    const double demand = lambda * main + (1.0 - lambda) * lateral;
    const auto share = [&](bool toMain, double q) {
        return demand > 0.0 ? into[id] * (toMain ? lambda : 1.0 - lambda) * q / demand : 0.0;
    };
    for (int slot = 0; slot < 8; ++slot) {
        if ((tree.buds(id) & budBit(slot)) != 0)
            ofBud[{id, slot}] = share(slot == kTerminalSlot, budQ[{id, slot}]);
    }
    for (const InternodeId child : m_children[id]) {
        into[child] = share(isMain(child), basipetal[child]);
        distribute(tree, child);
    }
}

std::vector<InternodeId> bruteSubtree(const Tree& tree, InternodeId root)
{
    std::set<InternodeId> members{root};
    for (InternodeId id = root + 1; id < tree.size(); ++id) {
        if (tree.isAlive(id) && members.contains(tree.parent(id)))
            members.insert(id);
    }
    return {members.begin(), members.end()};
}

std::vector<InternodeId> bruteShedding(const Tree& tree, const TreeIndex& index, std::span<const Vec3> born,
                                       std::span<const InternodeId> growingAt)
{
    constexpr Step kSpared = 4;
    const GrowthParameters& p = tree.parameters().growth;
    const BruteVigour vigour(tree, index);
    const auto mean = [&](InternodeId id) {
        return vigour.into.at(id) / static_cast<double>(bruteSubtree(tree, id).size());
    };
    const auto carries = [&](InternodeId branch, InternodeId node) {
        return std::ranges::binary_search(bruteSubtree(tree, branch), node);
    };
    const auto isShaded = [&](InternodeId node) {
        return std::ranges::any_of(born, [&](const Vec3& caster) {
            return layersBelow(voxelOf(caster, p), voxelOf(index.nodePosition(node), p), p.shadowDepth) >= 0;
        });
    };
    std::set<InternodeId> shed;
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (!tree.isAlive(id) || tree.columns().slot[id] == kTerminalSlot ||
            tree.step() + 1 < tree.birth(id) + kSpared ||
            std::ranges::any_of(growingAt, [&](InternodeId node) { return carries(id, node); }))
            continue;
        const std::vector<InternodeId> branch = bruteSubtree(tree, id);
        if (std::ranges::any_of(branch, isShaded) && mean(0) > 0.0 && mean(id) / mean(0) < p.shedding)
            shed.insert(branch.begin(), branch.end());
    }
    return {shed.begin(), shed.end()};
}

} // namespace espalier::test
