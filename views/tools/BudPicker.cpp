// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/BudPicker.h"

#include "model/growth/Buds.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace espalier {

namespace {

/// How far outside the bark a bud's dot stands, in internodes.
constexpr float kOffset = 0.15F;
constexpr double kNoDifference = 2.0; ///< px

} // namespace

Vec3 budPosition(const Tree& tree, const TreeIndex& index, const BudRef& bud, float radius)
{
    const Vec3 direction = budDirection(tree.seed(), bud.node, bud.slot, index.rotation(bud.node),
                                        tree.parametersOf(bud.node).growth);
    const float offset = kOffset * tree.length(bud.node) + (bud.slot == kTerminalSlot ? 0.0F : radius);
    return index.nodePosition(bud.node) + offset * direction;
}

std::vector<PickedBud> pickBuds(const PickScene& scene, const QPointF& screen, double reach)
{
    struct Candidate {
        PickedBud picked;
        double rank;
        float depth;
    };
    std::vector<Candidate> found;
    const Camera& camera = scene.camera;
    const Ray ray = camera.ray(screen);
    const auto perDepth = static_cast<float>(reach) / camera.pixelsPerMetre(1.0F);
    const auto mayReach = [&](const Vec3& centre, float radius) {
        const Vec3 offset = centre - ray.origin;
        const float along = offset.dot(ray.direction);
        const float limit = radius + std::max(0.0F, along + radius) * perDepth;
        return along > -radius && offset.squaredNorm() - along * along <= limit * limit;
    };
    const float beyond = kOffset * scene.index.greatestLength() + scene.greatestRadius;
    scene.space.forEachBrick([&](const Vec3& centre, float radius, VoxelSpace::Residents residents) {
        if (!mayReach(centre, radius + beyond))
            return;
        for (const Resident& resident : residents) {
            const Vec3 node(resident.x, resident.y, resident.z);
            if (!mayReach(node, beyond))
                continue;
            const float bark = scene.radius(resident.id);
            if (!mayReach(node, kOffset * scene.tree.length(resident.id) + bark))
                continue;
            for (unsigned rest = scene.tree.buds(resident.id); rest != 0; rest &= rest - 1) {
                const BudRef bud{resident.id, std::countr_zero(rest)};
                const Vec3 position = budPosition(scene.tree, scene.index, bud, bark);
                const auto place = camera.project(position);
                if (!place)
                    continue;
                const QPointF way = *place - screen;
                const double distance = std::hypot(way.x(), way.y());
                if (distance <= reach)
                    found.push_back(
                        {{bud, position}, std::floor(distance / kNoDifference), camera.depth(position)});
            }
        }
    });
    std::ranges::sort(found, [](const Candidate& a, const Candidate& b) {
        return std::tuple(a.rank, a.depth, a.picked.bud) < std::tuple(b.rank, b.depth, b.picked.bud);
    });
    std::vector<PickedBud> buds;
    for (const Candidate& candidate : found)
        buds.push_back(candidate.picked);
    return buds;
}

} // namespace espalier
