// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/BudPicker.h"

#include "model/growth/Buds.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <tuple>

namespace espalier {

namespace {

/// Distance of a bud's dot from the bark, in internodes.
constexpr float kOffset = 0.15F;
constexpr double kNoBudDifference = 2.0; ///< px

} // namespace

Vec3 budPosition(const Tree& tree, const TreeIndex& index, const BudRef& bud, float radius)
{
    const Vec3 direction =
        budDirection(tree.key(bud.node), bud.slot, index.rotation(bud.node), tree.parametersOf(bud.node));
    const float offset = kOffset * tree.length(bud.node) + (bud.slot == kTerminalSlot ? 0.0F : radius);
    return index.nodePosition(bud.node) + offset * direction;
}

std::vector<PickedBud> pickBuds(const PickScene& scene, const QPointF& screen, double reach, std::size_t most)
{
    struct Candidate {
        PickedBud picked;
        double rank;
        float depth;
        bool operator<(const Candidate& other) const
        {
            return std::tie(rank, depth, picked.bud) < std::tie(other.rank, other.depth, other.picked.bud);
        }
    };
    std::vector<Candidate> found; // a heap, the farthest first
    const Camera& camera = scene.camera;
    const Ray ray = camera.ray(screen);
    const float pixels = camera.pixelsPerMetre(1.0F);
    auto perDepth = static_cast<float>(reach) / pixels;
    const auto mayReach = [&](const Vec3& centre, float radius) {
        const Vec3 offset = centre - ray.origin;
        const float along = offset.dot(ray.direction);
        const float limit = radius + std::max(0.0F, along + radius) * perDepth;
        return along > -radius && offset.squaredNorm() - along * along <= limit * limit;
    };
    const auto take = [&](const BudRef& bud, float bark) {
        const Vec3 position = budPosition(scene.tree, scene.index, bud, bark);
        const auto place = camera.project(position);
        if (!place)
            return;
        const double distance = std::hypot(place->x() - screen.x(), place->y() - screen.y());
        if (distance > reach)
            return;
        const Candidate candidate{
            {bud, position}, std::floor(distance / kNoBudDifference), camera.depth(position)};
        if (found.size() == most) {
            if (!(candidate < found.front()))
                return;
            std::ranges::pop_heap(found, std::less());
            found.pop_back();
        }
        found.push_back(candidate);
        std::ranges::push_heap(found, std::less());
        // Once the heap is full, only buds that are nearer than the farthest one are added.
        if (found.size() == most)
            perDepth =
                static_cast<float>(std::min(reach, (found.front().rank + 1.0) * kNoBudDifference)) / pixels;
    };
    const float beyond = kOffset * scene.index.greatestLength() + scene.greatestRadius;
    scene.nodes.forEachCell([&](const Vec3& centre, float radius, PickIndex::Nodes nodes) {
        if (!mayReach(centre, radius + beyond))
            return;
        for (const PickIndex::Node& node : nodes) {
            if (!mayReach(node.position(), beyond))
                continue;
            const float bark = scene.radius(node.id);
            if (!mayReach(node.position(), kOffset * scene.tree.length(node.id) + bark))
                continue;
            for (unsigned rest = scene.tree.buds(node.id); rest != 0; rest &= rest - 1)
                take({node.id, std::countr_zero(rest)}, bark);
        }
    });
    std::ranges::sort_heap(found, std::less());
    std::vector<PickedBud> buds;
    for (const Candidate& candidate : found)
        buds.push_back(candidate.picked);
    return buds;
}

} // namespace espalier
