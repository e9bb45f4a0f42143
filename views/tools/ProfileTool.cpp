// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/ProfileTool.h"

namespace espalier {

namespace {

const QColor kSectionHintColour(214, 222, 206, 170);
const QColor kSectionColour(240, 180, 96);
/// The ring around a branch is so much larger than its bark.
constexpr float kRingFactor = 1.12F;
/// Of the ring, at least, px.
constexpr double kLeastRing = 9.0;

void addRing(Overlay& overlay, const Camera& camera, const Vec3& centre, const Rotation& frame, float radius,
             const QColor& colour)
{
    const double least = kLeastRing / camera.pixelsPerMetre(camera.depth(centre));
    overlay.addCircle(centre, frame * Vec3::UnitX(), frame * Vec3::UnitZ(),
                      std::max(kRingFactor * radius, static_cast<float>(least)), colour, 2.0F);
}

} // namespace

void ProfileTool::begin(const PointerSample& sample)
{
    m_isActive = true;
    look(sample);
}

void ProfileTool::move(const PointerSample& sample)
{
    if (m_isActive)
        look(sample);
}

void ProfileTool::end(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    look(sample);
    m_isActive = false;
    const std::optional<InternodeId> tapped = m_hovered;
    if (sample.device == PointerDevice::Finger)
        leave();
    if (tapped)
        m_choice.choose(*tapped);
    else
        m_choice.chooseNone();
}

void ProfileTool::cancel()
{
    m_isActive = false;
    leave();
}

void ProfileTool::hover(const PointerSample& sample)
{
    look(sample);
}

void ProfileTool::leave()
{
    m_hovered.reset();
    context().requestRepaint();
}

bool ProfileTool::keyPressed(int key)
{
    if (key != Qt::Key_Escape || !m_choice.section())
        return false;
    m_choice.chooseNone();
    context().requestRepaint();
    return true;
}

void ProfileTool::look(const PointerSample& sample)
{
    m_hovered.reset();
    if (const std::optional<PickedBranch> branch = context().pickThick(sample.position, sample.device)) {
        // An internode has its node at the upper end; the lower end is the parent's.
        const Tree& tree = context().document().tree();
        const bool isLower =
            branch->along < 0.5F && tree.parent(branch->id) != kNoInternode && tree.continuesAxis(branch->id);
        m_hovered = isLower ? tree.parent(branch->id) : branch->id;
    }
    context().requestRepaint();
}

void ProfileTool::paint(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    const TreeIndex& index = context().document().index();
    if (m_hovered && context().document().tree().isAlive(*m_hovered))
        addRing(overlay, camera, index.nodePosition(*m_hovered), index.rotation(*m_hovered),
                context().branchRadius(*m_hovered), kSectionHintColour);
    const std::optional<ShownSection> section = m_choice.section();
    if (!section)
        return;
    const Vec3 right = section->frame * Vec3::UnitX();
    const Vec3 forward = section->frame * Vec3::UnitZ();
    overlay.addGrid({.centre = section->centre,
                     .right = right,
                     .up = forward,
                     .extent = 3.5F * section->radius,
                     .spacing = section->radius,
                     .origin = section->centre,
                     .colour = kSectionColour});
    if (section->outline.empty())
        addRing(overlay, camera, section->centre, section->frame, section->radius, kSectionColour);
    for (const std::vector<Vec3>& line : section->outline)
        overlay.addLine(line, kSectionColour, 2.5F);
}

QString ProfileTool::tip() const
{
    return tr("Tap a branch to see its cross-section, and draw another shape for it");
}

} // namespace espalier
