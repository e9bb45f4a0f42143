// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/AddBudsTool.h"

#include "commands/AddBuds.h"
#include "views/tools/ToolColours.h"

#include <array>
#include <cmath>

namespace espalier {

namespace {

constexpr float kBudRing = 6.0F;  ///< Least radius of a ring, px
constexpr float kBudShare = 0.2F; ///< Its radius in radii of the branch
constexpr float kBudShoot = 2.5F; ///< Length of the line out of a ring, in its radii

double roundedTo(double value, double step)
{
    return std::round(value / step) * step;
}

} // namespace

/// The spiral whose middle bud is under the pointer.
std::optional<BudSpiral> AddBudsTool::spiralAt(const PointerSample& sample) const
{
    const std::optional<PickedBranch> picked = context().pickThick(sample.position, sample.device);
    if (!picked)
        return std::nullopt;
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    const Vec3 heading = index.heading(picked->id);
    const auto across = [&](const Vec3& vector) { return Vec3(vector - vector.dot(heading) * heading); };
    // How far beside the axis the pointer is says where on the near side of the bark it is.
    const float radius = std::max(picked->radius, 1e-6F);
    Vec3 aside = across(camera.onPlane(sample.position, picked->position) - picked->position) / radius;
    if (aside.norm() > 0.95F)
        aside *= 0.95F / aside.norm();
    Vec3 toEye = across(camera.position() - picked->position);
    toEye = toEye.norm() > 1e-6F ? Vec3(toEye.normalized()) : anyPerpendicular(heading);
    aside -= aside.dot(toEye) * toEye;
    const Vec3 normal = aside + std::sqrt(std::max(0.0F, 1.0F - aside.squaredNorm())) * toEye;
    const Vec3 local = index.rotation(picked->id).conjugate() * normal;
    const ViewValues& view = context().viewSettings().values();
    return BudSpiral{.internode = picked->id,
                     .along = roundedTo(static_cast<double>(picked->along), 0.001),
                     .azimuth =
                         roundedTo(degrees(std::atan2(static_cast<double>(local.z()), local.x())), 0.1) + 0.0,
                     .count = static_cast<int>(view.newBuds),
                     .spacing = view.budSpacing};
}

void AddBudsTool::aim(const PointerSample& sample)
{
    const TreeDocument& document = context().document();
    m_spiral = spiralAt(sample);
    m_buds.clear();
    m_revision = document.revision();
    if (m_spiral)
        m_buds = budsOf(document, *m_spiral, [this](InternodeId id) { return context().branchRadius(id); });
    context().requestRepaint();
}

void AddBudsTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    aim(sample);
}

void AddBudsTool::move(const PointerSample& sample)
{
    if (m_isDown)
        aim(sample);
}

void AddBudsTool::end(const PointerSample& sample)
{
    move(sample);
    const std::optional<BudSpiral> spiral = m_isDown ? m_spiral : std::nullopt;
    cancel();
    if (spiral)
        addBuds(context().document(), *spiral);
}

void AddBudsTool::cancel()
{
    m_isDown = false;
    leave();
}

void AddBudsTool::leave()
{
    m_spiral.reset();
    m_buds.clear();
    context().requestRepaint();
}

void AddBudsTool::paint(Overlay& overlay) const
{
    // The tree may have changed since the pointer moved.
    if (m_revision != context().document().revision())
        return;
    const Camera& camera = context().camera();
    for (const BarkBud& bud : m_buds) {
        const float depth = camera.depth(bud.place);
        if (depth < Camera::kMinDistance)
            continue;
        const float radius = std::max(kBudRing / camera.pixelsPerMetre(depth),
                                      kBudShare * context().branchRadius(bud.internode));
        const Vec3 u = anyPerpendicular(bud.direction);
        overlay.addCircle(bud.place, u, bud.direction.cross(u), radius, kPickedColour, 2.0F);
        const std::array shoot{bud.place, Vec3(bud.place + kBudShoot * radius * bud.direction)};
        overlay.addLine(shoot, kPickedColour, 2.0F);
    }
}

QString AddBudsTool::tip() const
{
    return tr("Tap old wood to let buds break through its bark; they grow into branches");
}

} // namespace espalier
