// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/SelectBudTool.h"

#include <array>

namespace espalier {

namespace {

/// Buds are shown within this factor of the distance for picking.
constexpr double kShownReach = 9.0;

const QColor kBudColour(240, 168, 184);
const QColor kSelectedColour(235, 84, 72);

} // namespace

void SelectBudTool::begin(const PointerSample& sample)
{
    m_isActive = true;
    look(sample);
}

void SelectBudTool::move(const PointerSample& sample)
{
    if (m_isActive)
        look(sample);
}

void SelectBudTool::end(const PointerSample& sample)
{
    if (!m_isActive)
        return;
    look(sample);
    m_isActive = false;
    if (!m_isNear && context().document().competitors().areAll())
        m_say(m_buds.empty() ? tr("There is no bud here. Buds near the pointer are shown as dots.")
                             : tr("No bud is close enough. Tap one of the dots, or zoom in with the wheel."));
    context().document().setCompetitors(
        m_isNear ? Competitors{m_buds.front().bud.node, m_buds.front().bud.slot} : Competitors{});
    if (sample.device == PointerDevice::Finger)
        leave();
}

void SelectBudTool::finish()
{
    cancel();
}

void SelectBudTool::cancel()
{
    m_isActive = false;
    leave();
}

void SelectBudTool::hover(const PointerSample& sample)
{
    look(sample);
}

void SelectBudTool::leave()
{
    m_buds.clear();
    m_isNear = false;
    context().requestRepaint();
}

void SelectBudTool::look(const PointerSample& sample)
{
    m_buds = context().pickBuds(sample.position, sample.device, kShownReach);
    m_isNear = !context().pickBuds(sample.position, sample.device, 1.0).empty();
    context().requestRepaint();
}

void SelectBudTool::paint(Overlay& overlay) const
{
    std::vector<Vec3> dots;
    for (const PickedBud& bud : m_buds)
        dots.push_back(bud.position);
    overlay.addDots(dots, kBudColour, 4.0F, 0.4F);
    if (m_isNear) {
        const Camera& camera = context().camera();
        const Vec3& place = m_buds.front().position;
        overlay.addDots(std::array{place}, kSelectedColour, 7.0F, 0.8F);
        overlay.addCircle(place, camera.right(), camera.up(),
                          11.0F / camera.pixelsPerMetre(camera.depth(place)), kSelectedColour, 2.0F);
    }
}

QString SelectBudTool::tip() const
{
    return tr("Tap a bud, and it alone grows from now on; tap beside the tree to let all grow again");
}

} // namespace espalier
