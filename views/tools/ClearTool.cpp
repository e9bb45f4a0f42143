// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/ClearTool.h"

#include "commands/KeepClear.h"
#include "model/settings/Lengths.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {

namespace {

constexpr double kRingReach = 12.0; ///< px
constexpr double kRingFingerReach = 24.0;
/// An end that is dragged this near to the base of its axis lets buds shoot again, px.
constexpr double kNoClear = 6.0;
/// How far an axis that is still short may be kept clear beyond its tip, m.
constexpr float kBeyondTip = 30.0F;
constexpr float kRingGap = 5.0F;        ///< Between the bark and the ring, px
constexpr float kLeastClearRing = 8.0F; ///< Radius of the ring, px
constexpr float kLengthGrain = 1e3F;    ///< Steps of the length in a metre

const QColor kClearColour(112, 190, 220);
const QColor kClearLit(168, 226, 246);

} // namespace

Vec3 ClearTool::placeOn(const Tree& tree, const TreeIndex& index, InternodeId axis, float length)
{
    for (InternodeId on = axis;; on = index.mainChild(on)) {
        const float whole = tree.length(on);
        if (length <= whole || index.mainChild(on) == kNoInternode)
            return index.basePosition(tree, on) + length * index.heading(on);
        length -= whole;
    }
}

/// The length from the base of @p axis to the place on it, or beyond its tip, that appears nearest to @p
/// screen, m.
float ClearTool::lengthAt(InternodeId axis, const QPointF& screen) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    float best = 0.0F;
    double nearest = std::numeric_limits<double>::infinity();
    float below = 0.0F;
    for (InternodeId on = axis; on != kNoInternode; on = index.mainChild(on)) {
        const bool isTip = index.mainChild(on) == kNoInternode;
        float length = tree.length(on) + (isTip ? kBeyondTip : 0.0F);
        const Vec3 base = index.basePosition(tree, on);
        Vec3 end = base + length * index.heading(on);
        const auto a = camera.project(base);
        auto b = camera.project(end);
        if (!b) { // Behind the camera
            length = tree.length(on);
            end = index.nodePosition(on);
            b = camera.project(end);
        }
        if (a && b) {
            const QPointF way = *b - *a;
            const double squared = QPointF::dotProduct(way, way);
            const double share =
                squared > 0.0 ? std::clamp(QPointF::dotProduct(screen - *a, way) / squared, 0.0, 1.0) : 1.0;
            const QPointF off = screen - (*a + share * way);
            if (const double distance = QPointF::dotProduct(off, off); distance < nearest) {
                nearest = distance;
                // The share on the screen becomes one in space: farther parts are shorter there.
                const auto s = static_cast<float>(share);
                const float near = camera.depth(base);
                const float far = camera.depth(end);
                best = below + length * s * near / std::max(far + s * (near - far), 1e-6F);
            }
        }
        below += tree.length(on);
    }
    const auto foot = camera.project(index.basePosition(tree, axis));
    const QPointF off = foot ? screen - *foot : QPointF(kNoClear, kNoClear);
    if (best <= 0.0F || (std::hypot(off.x(), off.y()) < kNoClear))
        return 0.0F;
    return std::min(std::round(best * kLengthGrain) / kLengthGrain, kGreatestClearLength);
}

/// The axis whose ring is under the pointer.
std::optional<InternodeId> ClearTool::ringAt(const PointerSample& sample) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    double best = sample.device == PointerDevice::Finger ? kRingFingerReach : kRingReach;
    std::optional<InternodeId> found;
    for (const auto& [axis, length] : tree.content().sparse.clearLength.cells()) {
        if (!tree.isAlive(axis) || index.axis(axis) != axis)
            continue;
        const auto place = context().camera().project(placeOn(tree, index, axis, length));
        if (!place)
            continue;
        const QPointF off = sample.position - *place;
        if (const double distance = std::hypot(off.x(), off.y()); distance < best) {
            best = distance;
            found = axis;
        }
    }
    return found;
}

std::optional<ClearTool::Aim> ClearTool::aimAt(const PointerSample& sample) const
{
    const TreeDocument& document = context().document();
    if (const auto axis = ringAt(sample))
        return Aim{*axis, document.tree().clearLength(*axis)};
    const auto picked = context().pickThick(sample.position, sample.device);
    if (!picked)
        return std::nullopt;
    const InternodeId axis = document.index().axis(picked->id);
    return Aim{axis, lengthAt(axis, sample.position)};
}

void ClearTool::aim(const std::optional<Aim>& wanted)
{
    m_aim = wanted;
    const TreeDocument& document = context().document();
    m_preview.show(context(),
                   wanted ? shootsBelow(document.tree(), document.index(), wanted->axis, wanted->length)
                          : std::vector<InternodeId>{});
}

void ClearTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    aim(aimAt(sample));
    m_offset = {};
    if (!m_aim)
        return;
    const TreeDocument& document = context().document();
    if (const auto place = context().camera().project(
            placeOn(document.tree(), document.index(), m_aim->axis, m_aim->length)))
        m_offset = *place - sample.position;
}

void ClearTool::move(const PointerSample& sample)
{
    if (m_isDown && m_aim && m_aim->axis < context().document().tree().size())
        aim(Aim{m_aim->axis, lengthAt(m_aim->axis, sample.position + m_offset)});
}

void ClearTool::end(const PointerSample& sample)
{
    move(sample);
    finish();
}

void ClearTool::finish()
{
    const std::optional<Aim> wanted = m_isDown ? m_aim : std::nullopt;
    cancel();
    if (wanted)
        keepClear(context().document(), wanted->axis, wanted->length);
}

void ClearTool::cancel()
{
    m_isDown = false;
    leave();
}

void ClearTool::hover(const PointerSample& sample)
{
    aim(aimAt(sample));
}

void ClearTool::leave()
{
    aim(std::nullopt);
}

bool ClearTool::keyPressed(int key)
{
    if ((key != Qt::Key_Delete && key != Qt::Key_Backspace) || !m_aim)
        return false;
    const InternodeId axis = m_aim->axis;
    leave();
    keepClear(context().document(), axis, 0.0F);
    return true;
}

/// Paints a line along the clear part, and the ring at its end.
void ClearTool::paintClear(Overlay& overlay, const Aim& clear, bool isLit) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const Camera& camera = context().camera();
    const QColor& colour = isLit ? kClearLit : kClearColour;
    const Vec3 end = placeOn(tree, index, clear.axis, clear.length);
    std::vector<Vec3> line{index.basePosition(tree, clear.axis)};
    float below = 0.0F;
    InternodeId last = clear.axis;
    for (InternodeId on = clear.axis; on != kNoInternode && below < clear.length; on = index.mainChild(on)) {
        last = on;
        below += tree.length(on);
        if (below < clear.length)
            line.push_back(index.nodePosition(on));
    }
    line.push_back(end);
    overlay.addInk(line, colour, isLit ? 3.0F : 2.0F);
    const float depth = camera.depth(end);
    if (depth < Camera::kMinDistance)
        return;
    const float pixel = 1.0F / camera.pixelsPerMetre(depth);
    const Vec3 heading = index.heading(last);
    const Vec3 across = anyPerpendicular(heading);
    const float radius = std::max(context().branchRadius(last) + kRingGap * pixel, kLeastClearRing * pixel);
    overlay.addCircle(end, across, heading.cross(across), radius, colour, isLit ? 3.0F : 2.2F);
    overlay.addDots(std::array{end}, colour, isLit ? 8.0F : 6.0F, isLit ? 0.4F : 0.0F);
    if (isLit)
        overlay.addLabel(
            {end,
             {14.0 + static_cast<double>(radius / pixel), 0.0},
             clear.length > 0.0F ? lengthText(static_cast<double>(clear.length)) : tr("buds may shoot"),
             colour});
}

void ClearTool::paint(Overlay& overlay) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    const auto isAxis = [&](InternodeId id) { return tree.isAlive(id) && index.axis(id) == id; };
    for (const auto& [axis, length] : tree.content().sparse.clearLength.cells()) {
        if (isAxis(axis) && !(m_aim && m_aim->axis == axis))
            paintClear(overlay, {axis, length}, false);
    }
    m_preview.paint(context(), overlay, false);
    // The tree may have changed since the pointer moved.
    if (m_aim && isAxis(m_aim->axis))
        paintClear(overlay, *m_aim, true);
}

QString ClearTool::tip() const
{
    return tr("Drag up along a trunk or a branch: below your hand, nothing shoots any more");
}

} // namespace espalier
