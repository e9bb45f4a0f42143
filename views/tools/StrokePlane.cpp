// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/StrokePlane.h"

#include "commands/recipe/RecipeLimits.h"

#include <cmath>

namespace espalier {

namespace {

/// The least sine of the angle between the line of sight and an upright plane that can be drawn in.
constexpr float kLeastStrokeFacing = 0.35F;
/// While the camera turns during a stroke, it may be less.
constexpr float kLeastSlope = 0.12F;
/// A stroke that begins within so many radii of the trunk's axis begins at the trunk.
constexpr float kTrunkReach = 1.5F;
/// A limb that is this near to the trunk on the screen, px, hides it.
constexpr float kTrunkPixels = 7.0F;

Vec3 levelled(const Vec3& way)
{
    return {way.x(), 0.0F, way.z()};
}

/// Whether a limb that was picked hides the trunk of @p root: it points to the viewer there.
bool isBeforeTrunk(ToolContext& context, const PickedBranch& picked, InternodeId root)
{
    const TreeDocument& document = context.document();
    const Camera& camera = context.camera();
    const Vec3 trunk = trunkAt(document.tree(), document.index(), root, picked.position.y());
    const float depth = camera.depth(trunk);
    if (depth < Camera::kMinDistance)
        return false;
    const float sideways = std::abs((picked.position - trunk).dot(camera.right()));
    return sideways < context.branchRadius(root) + kTrunkPixels / camera.pixelsPerMetre(depth);
}

} // namespace

StrokePlane StrokePlane::of(ToolContext& context, const std::optional<PickedBranch>& picked)
{
    StrokePlane plane;
    const ViewValues& view = context.viewSettings().values();
    const TreeDocument& document = context.document();
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    if (picked)
        plane.m_anchor = picked->position;
    const InternodeId root = picked ? index.rootOf(tree, picked->id) : 0;
    // Only limbs are spread: a crown grows where it is brushed.
    const bool spreads = view.brushPlane == BrushPlane::Spread &&
                         view.brushRadius < document.parameters().growth.internodeLength;
    const bool hidesTrunk = spreads && picked && isBeforeTrunk(context, *picked, root);
    if (hidesTrunk)
        plane.m_anchor = trunkAt(tree, index, root, picked->position.y());
    const bool isAtTrunk = !picked || hidesTrunk || index.axis(picked->id) == root;
    constexpr auto kFar = static_cast<float>(recipeLimits::kCoordinate);
    const Vec3 trunk = picked && isAtTrunk ? plane.m_anchor
                                           : trunkAt(tree, index, root, picked ? picked->position.y() : 0.0F);
    plane.m_placement.around = trunk.cwiseMax(-kFar).cwiseMin(kFar);
    plane.m_placement.copies = static_cast<int>(view.brushSymmetry);
    // At its tip, the trunk goes on.
    const bool isAtTip = picked && !hidesTrunk && index.mainChild(picked->id) == kNoInternode;
    plane.m_placement.isSpread = spreads && isAtTrunk && !isAtTip;

    if (view.brushPlane == BrushPlane::Trunk && picked) {
        const Camera& camera = context.camera();
        Vec3 outward = levelled(plane.m_anchor - trunk);
        if (isAtTrunk || outward.norm() < kTrunkReach * context.branchRadius(root))
            outward = camera.right();
        outward.normalize();
        const Vec3 normal = outward.cross(Vec3::UnitY());
        if (std::abs(normal.dot(camera.forward())) >= kLeastStrokeFacing)
            plane.m_outward = outward;
    }
    return plane;
}

Vec3 StrokePlane::under(const Camera& camera, const QPointF& screen) const
{
    if (m_outward) {
        const Ray ray = camera.ray(screen);
        const Vec3 normal = m_outward->cross(Vec3::UnitY());
        const float slope = ray.direction.dot(normal);
        const float distance = (m_anchor - ray.origin).dot(normal) / slope;
        if (std::abs(slope) >= kLeastSlope && distance > 0.0F)
            return ray.origin + distance * ray.direction;
    }
    return camera.onPlane(screen, m_anchor);
}

Vec3 StrokePlane::right(const Camera& camera) const
{
    return m_outward ? *m_outward : camera.right();
}

Vec3 StrokePlane::up(const Camera& camera) const
{
    return m_outward ? Vec3(Vec3::UnitY()) : camera.up();
}

} // namespace espalier
