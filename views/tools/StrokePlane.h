// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/growth/StrokePlacement.h"
#include "views/tools/ToolContext.h"

#include <optional>

namespace espalier {

/// The plane that a stroke of the brush is drawn in (BrushPlane), and how the stroke is turned or repeated
/// about the trunk.
class StrokePlane {
public:
    /// Parallel to the screen, through the foot of the seedling.
    StrokePlane() = default;
    /// The plane of a stroke that begins at @p picked, or beside the tree if that is empty, by the values of
    /// the view.
    static StrokePlane of(ToolContext& context, const std::optional<PickedBranch>& picked);

    /// A point of the plane, m.
    const Vec3& anchor() const { return m_anchor; }
    /// The point of the plane under @p screen, m.
    Vec3 under(const Camera& camera, const QPointF& screen) const;
    /// The directions that span the plane, unit vectors.
    Vec3 right(const Camera& camera) const;
    Vec3 up(const Camera& camera) const;

    const StrokePlacement& placement() const { return m_placement; }

private:
    Vec3 m_anchor = Vec3::Zero();
    /// Level direction in an upright plane; empty for a plane that is parallel to the screen.
    std::optional<Vec3> m_outward;
    StrokePlacement m_placement;
};

} // namespace espalier
