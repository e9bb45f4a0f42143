// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/BranchPicker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace espalier {

namespace {

constexpr float kNoDifference = 3.0F; ///< px
constexpr double kFingerReach = 8.0;  ///< mm
constexpr double kPenReach = 2.0;     ///< mm
constexpr double kMouseReach = 2.5;   ///< mm
/// A branch drawn narrower than this share of another's width is thin beside it.
constexpr float kThinShare = 2.0F / 3.0F;

/// A point in the camera's view.
struct Seen {
    Vec2 place;  ///< px from the middle of the view, up
    float depth; ///< m
};

enum class Wanted { Front, Thick };

class Picker {
public:
    Picker(const PickScene& scene, const QPointF& screen, double reach, Wanted wanted)
        : m_scene(scene),
          m_wanted(wanted),
          m_eye(scene.camera.position()),
          m_right(scene.camera.right()),
          m_up(scene.camera.up()),
          m_forward(scene.camera.forward()),
          m_scale(scene.camera.pixelsPerMetre(1.0F)),
          m_pointer(static_cast<float>(screen.x() - scene.camera.targetPlace().x()),
                    static_cast<float>(scene.camera.targetPlace().y() - screen.y())),
          m_reach(static_cast<float>(reach)),
          m_ray(scene.camera.ray(screen))
    {
    }

    /// Whether a branch within @p radius (m) of @p centre can appear within reach.
    bool mayReach(const Vec3& centre, float radius) const
    {
        const Vec3 offset = centre - m_eye;
        const float along = offset.dot(m_ray.direction);
        // A cone around the ray. Away from the view's middle a pixel is smaller than at the middle, so the
        // cone is large enough.
        const float limit = radius + std::max(0.0F, along + radius) * m_reach / m_scale;
        return along > -radius && offset.squaredNorm() - along * along <= limit * limit;
    }

    /// The least depth of a branch within @p radius (m) of @p centre, m.
    float leastDepth(const Vec3& centre, float radius) const
    {
        return (centre - m_eye).dot(m_forward) - radius;
    }
    /// Whether a branch from @p depth (m) on cannot be better than the one found.
    bool isSettledBefore(float depth) const
    {
        return m_wanted == Wanted::Front && m_best && m_rank == 0.0F && depth >= m_depth;
    }

    void consider(InternodeId id)
    {
        const Vec3 lower = m_scene.index.basePosition(m_scene.tree, id);
        const Vec3& upper = m_scene.index.nodePosition(id);
        const Seen a = see(lower);
        const Seen b = see(upper);
        if (std::min(a.depth, b.depth) < Camera::kMinDistance / 2.0F)
            return;
        const Vec2 way = b.place - a.place;
        const float along =
            std::clamp((m_pointer - a.place).dot(way) / std::max(way.squaredNorm(), 1e-6F), 0.0F, 1.0F);
        const Vec2 nearest = a.place + along * way;
        const float depth = a.depth + along * (b.depth - a.depth);
        const float radius = m_scene.radius(id);
        const float drawn = radius * m_scale / depth;
        const float off = std::max(0.0F, (m_pointer - nearest).norm() - drawn);
        if (off > m_reach)
            return;
        const PickedBranch picked{id, along, lower + along * (upper - lower), radius};
        if (m_wanted == Wanted::Thick && off == 0.0F)
            m_covering.push_back({picked, drawn, depth - radius});
        const float rank = std::floor(off / kNoDifference);
        if (m_best && (rank > m_rank || (rank == m_rank && depth - radius >= m_depth)))
            return;
        m_best = picked;
        m_bestDrawn = drawn;
        m_rank = rank;
        m_depth = depth - radius;
    }

    const std::optional<PickedBranch>& best() const { return m_best; }

    /// The frontmost of the branches that cover the pointer and are not thin beside the widest one of these.
    std::optional<PickedBranch> thick() const
    {
        if (!m_best || m_covering.empty())
            return m_best;
        const Covering& widest = *std::ranges::max_element(m_covering, {}, &Covering::drawn);
        const std::uint32_t strands = m_scene.index.tipCount(m_best->id);
        if (m_bestDrawn >= kThinShare * widest.drawn || strands >= m_scene.index.tipCount(widest.branch.id))
            return m_best;
        const Covering* front = &widest;
        for (const Covering& other : m_covering) {
            if (other.depth < front->depth && other.drawn >= kThinShare * widest.drawn &&
                m_scene.index.tipCount(other.branch.id) > strands)
                front = &other;
        }
        return front->branch;
    }

private:
    /// A branch under the pointer itself.
    struct Covering {
        PickedBranch branch;
        float drawn; ///< Its radius on the screen, px
        float depth; ///< Of the bark, m
    };

    Seen see(const Vec3& point) const
    {
        const Vec3 offset = point - m_eye;
        const float depth = offset.dot(m_forward);
        const float scale = m_scale / depth;
        return {Vec2(offset.dot(m_right) * scale, offset.dot(m_up) * scale), depth};
    }

    const PickScene& m_scene;
    Wanted m_wanted;
    Vec3 m_eye;
    Vec3 m_right;
    Vec3 m_up;
    Vec3 m_forward;
    float m_scale;
    Vec2 m_pointer;
    float m_reach;
    Ray m_ray;
    std::optional<PickedBranch> m_best;
    float m_rank = 0.0F;
    float m_depth = 0.0F;
    float m_bestDrawn = 0.0F; ///< px
    std::vector<Covering> m_covering;
};

/// Shows @p picker the branches near the ray.
void search(const PickScene& scene, Picker& picker)
{
    const QList<float>& lengths = scene.tree.columns().length;
    const float beyond = scene.index.greatestLength() + scene.greatestRadius;
    struct PickCell {
        float depth;
        PickIndex::Nodes nodes;
    };
    std::vector<PickCell> cells;
    scene.nodes.forEachCell([&](const Vec3& centre, float radius, PickIndex::Nodes nodes) {
        if (picker.mayReach(centre, radius + beyond))
            cells.push_back({picker.leastDepth(centre, radius + beyond), nodes});
    });
    // From front to back: what is under the pointer itself hides all that is behind it.
    std::ranges::stable_sort(cells, {}, &PickCell::depth);
    for (const PickCell& cell : cells) {
        if (picker.isSettledBefore(cell.depth))
            break;
        for (const PickIndex::Node& node : cell.nodes) {
            const Vec3 position = node.position();
            const float length = lengths[node.id];
            const float most = length + scene.greatestRadius;
            if (!picker.mayReach(position, most) || picker.isSettledBefore(picker.leastDepth(position, most)))
                continue;
            if (picker.mayReach(position, length + scene.radius(node.id)))
                picker.consider(node.id);
        }
    }
}

} // namespace

std::optional<PickedBranch> pickBranch(const PickScene& scene, const QPointF& screen, double reach)
{
    Picker picker(scene, screen, reach, Wanted::Front);
    search(scene, picker);
    return picker.best();
}

std::optional<PickedBranch> pickThickBranch(const PickScene& scene, const QPointF& screen, double reach)
{
    Picker picker(scene, screen, reach, Wanted::Thick);
    search(scene, picker);
    const std::optional<PickedBranch> picked = picker.thick();
    return picked ? std::optional(nearestOnAxis(scene.tree, scene.index, scene.camera, *picked, screen))
                  : std::nullopt;
}

PickedBranch nearestOnAxis(const Tree& tree, const TreeIndex& index, const Camera& camera,
                           PickedBranch picked, const QPointF& screen)
{
    double least = std::numeric_limits<double>::infinity();
    PickedBranch nearest = picked;
    for (InternodeId id = index.axis(picked.id); id != kNoInternode; id = index.mainChild(id)) {
        const Vec3 base = index.basePosition(tree, id);
        const Vec3& node = index.nodePosition(id);
        // Only internodes that lie within the picked one's bark are meant, not a far part of the same axis.
        const float reach = 3.0F * picked.radius + 2.0F * tree.length(picked.id);
        if ((0.5F * (base + node) - picked.position).norm() > reach + tree.length(id))
            continue;
        const auto lower = camera.project(base);
        const auto upper = camera.project(node);
        if (!lower || !upper)
            continue;
        const QPointF way = *upper - *lower;
        const double squared = QPointF::dotProduct(way, way);
        const double along =
            squared > 0.0 ? std::clamp(QPointF::dotProduct(screen - *lower, way) / squared, 0.0, 1.0) : 1.0;
        const QPointF beside = screen - (*lower + along * way);
        if (const double distance = QPointF::dotProduct(beside, beside); distance < least) {
            least = distance;
            const auto share = static_cast<float>(along);
            nearest = {id, share, base + share * (node - base), picked.radius};
        }
    }
    return nearest;
}

double pickReach(PointerDevice device, double pixelsPerMillimetre)
{
    switch (device) {
    case PointerDevice::Finger:
        return kFingerReach * pixelsPerMillimetre;
    case PointerDevice::Pen:
        return kPenReach * pixelsPerMillimetre;
    case PointerDevice::Mouse:
        break;
    }
    return kMouseReach * pixelsPerMillimetre;
}

} // namespace espalier
