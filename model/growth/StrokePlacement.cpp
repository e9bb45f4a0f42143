// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/StrokePlacement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace espalier {

namespace {

constexpr std::size_t kNeighbourLimbs = 8;
constexpr float kLimbShare = 1.0F / 3.0F;

double levelAzimuth(const Vec3& way)
{
    return std::atan2(static_cast<double>(way.z()), static_cast<double>(way.x()));
}

float levelLength(const Vec3& way)
{
    return std::hypot(way.x(), way.z());
}

/// A branch of a tree.
struct Limb {
    float height;   ///< Of its base, m
    float length;   ///< Along its axis, m
    double azimuth; ///< Of its tip, seen from the line that strokes are turned about, rad
};

/// The branches of the tree of @p root, those of limbs included: they fill gaps as well.
std::vector<Limb> limbsOf(const Tree& tree, const TreeIndex& index, InternodeId root, const Vec3& around)
{
    std::vector<Limb> limbs;
    std::vector<InternodeId> roots(tree.size());
    for (InternodeId axis = 0; axis < tree.size(); ++axis) {
        roots[axis] = tree.isRoot(axis) ? axis : roots[tree.parent(axis)];
        if (!tree.isAlive(axis) || roots[axis] != root || index.axis(axis) != axis || axis == root)
            continue;
        float length = 0.0F;
        InternodeId tip = axis;
        for (InternodeId id = axis; id != kNoInternode; id = index.mainChild(id)) {
            length += tree.length(id);
            tip = id;
        }
        const Vec3 way = index.nodePosition(tip) - around;
        if (levelLength(way) > 1e-3F)
            limbs.push_back({index.basePosition(tree, axis).y(), length, levelAzimuth(way)});
    }
    return limbs;
}

/// The living root whose trunk passes nearest to @p point.
std::optional<InternodeId> nearestTrunk(const Tree& tree, const TreeIndex& index, const Vec3& point)
{
    std::optional<InternodeId> nearest;
    float least = std::numeric_limits<float>::infinity();
    for (const InternodeId root : index.roots()) {
        if (!tree.isAlive(root))
            continue;
        for (InternodeId on = root; on != kNoInternode; on = index.mainChild(on)) {
            const float squared = (index.nodePosition(on) - point).squaredNorm();
            if (squared < least) {
                least = squared;
                nearest = root;
            }
        }
    }
    return nearest;
}

} // namespace

Vec3 trunkAt(const Tree& tree, const TreeIndex& index, InternodeId root, float height)
{
    for (InternodeId on = root;; on = index.mainChild(on)) {
        const Vec3& node = index.nodePosition(on);
        if (node.y() >= height) {
            const Vec3 base = index.basePosition(tree, on);
            const float rise = node.y() - base.y();
            const float along = rise > 0.0F ? std::clamp((height - base.y()) / rise, 0.0F, 1.0F) : 1.0F;
            return base + along * (node - base);
        }
        if (index.mainChild(on) == kNoInternode)
            return node;
    }
}

std::optional<double> widestGap(const Tree& tree, const TreeIndex& index, const Vec3& around)
{
    const std::optional<InternodeId> root = nearestTrunk(tree, index, around);
    std::vector<Limb> limbs = root ? limbsOf(tree, index, *root, around) : std::vector<Limb>{};
    if (limbs.empty())
        return std::nullopt;
    const float longest = std::ranges::max_element(limbs, {}, &Limb::length)->length;
    std::erase_if(limbs, [&](const Limb& limb) { return limb.length < kLimbShare * longest; });
    std::ranges::stable_sort(limbs, {}, [&](const Limb& limb) { return std::abs(limb.height - around.y()); });
    limbs.resize(std::min(limbs.size(), kNeighbourLimbs));
    std::ranges::stable_sort(limbs, {}, &Limb::azimuth);
    constexpr double kTurn = 2.0 * std::numbers::pi;
    double widest = 0.0;
    double middle = 0.0;
    for (std::size_t i = 0; i < limbs.size(); ++i) {
        const double next = i + 1 < limbs.size() ? limbs[i + 1].azimuth : limbs.front().azimuth + kTurn;
        // Equal gaps differ by rounding: the first of them counts.
        if (next - limbs[i].azimuth > widest + 1e-4) {
            widest = next - limbs[i].azimuth;
            middle = 0.5 * (limbs[i].azimuth + next);
        }
    }
    return middle;
}

StrokeTurns::StrokeTurns(const Tree& tree, const TreeIndex& index, const StrokePlacement& placement,
                         float reach)
    : m_placement(placement), m_reach(reach)
{
    if (placement.isSpread)
        m_gap = widestGap(tree, index, placement.around);
}

void StrokeTurns::meet(const Vec3& point)
{
    const Vec3 way = point - m_placement.around;
    if (!m_gap || levelLength(way) < m_reach)
        return;
    m_turn = *m_gap - levelAzimuth(way);
    m_gap.reset();
}

Vec3 StrokeTurns::placed(const Vec3& point, int copy) const
{
    const double angle = m_turn + 2.0 * std::numbers::pi * copy / m_placement.copies;
    if (angle == 0.0)
        return point;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    const Vec3 way = point - m_placement.around;
    return m_placement.around + Vec3(c * way.x() - s * way.z(), way.y(), s * way.x() + c * way.z());
}

} // namespace espalier
