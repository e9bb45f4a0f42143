// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/BrushTool.h"

#include "commands/Prune.h"
#include "model/shape/Pruning.h"
#include "views/tools/ToolColours.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// Growth under the brush takes so much of the time between two pictures.
constexpr auto kGrowthTime = std::chrono::milliseconds(12);
/// The times of a stroke's samples are multiples of this, s.
constexpr double kClockStep = 1e-4;
/// Below this sine of the angle between them, the drawing plane and the ground meet too far away to be shown.
constexpr float kGrazing = 0.1F;

/// Radius of the ring around the node at which a stroke would begin, px.
constexpr float kRing = 9.0F;

/// Radius of the ring that closes in on a bud under a long press, px.
constexpr float kHeldRing = 44.0F;

/// A press that moves no further than this, px, and lasts no longer than this, s, is a tap.
constexpr double kTapReach = 8.0;
constexpr double kTap = 0.3;
/// The longest time between two taps of a double tap, s.
constexpr double kDoubleTap = 0.45;
constexpr double kLongPress = 0.6; ///< s
/// A stroke that has grown nothing for so long says why, s.
constexpr double kReasonAfter = 0.4;
/// A long press must be nearer to its bud than a press to a branch, by this factor.
constexpr double kBudReach = 0.6;

double distance(const QPointF& a, const QPointF& b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

const QColor kMarkerColour(255, 214, 120);
const QColor kMarkerOverLight(206, 122, 24);
const QColor kHintColour(150, 168, 190);
const QColor kHintOverLight(70, 86, 106);

} // namespace

void BrushTool::begin(const PointerSample& sample)
{
    if (sample.modifiers.testFlag(Qt::ShiftModifier)) {
        hover(sample);
        m_sizing = Sizing{sample.position, context().viewSettings().values().brushRadius};
        return;
    }
    m_press = sample;
    m_undoIndex = context().document().undoStack().index();
    if (pruneOnSecondTap(sample))
        return;
    if (sample.device != PointerDevice::Mouse) {
        const auto buds = context().pickBuds(sample.position, sample.device, kBudReach);
        if (!buds.empty()) {
            m_held = Hold{sample, buds.front()};
            m_now = sample.time;
            context().requestRepaint();
            return;
        }
    }
    beginStroke(sample);
}

void BrushTool::resizeTo(const QPointF& pointer)
{
    const Camera& camera = context().camera();
    const float depth = std::max(camera.depth(m_plane.anchor()), Camera::kMinDistance);
    const double by = (pointer.x() - m_sizing->from.x()) / static_cast<double>(camera.pixelsPerMetre(depth));
    context().viewSettings().set(&ViewValues::brushRadius,
                                 std::clamp(m_sizing->radius + by, 0.0, kMaxBrushRadius));
    context().requestRepaint();
}

bool BrushTool::pruneOnSecondTap(const PointerSample& sample)
{
    const Tap tap = std::exchange(m_lastTap, {});
    if (sample.time - tap.time > kDoubleTap || distance(sample.position, tap.position) > 2.0 * kTapReach)
        return false;
    TreeDocument& document = context().document();
    // The user did not mean the stroke of the first tap.
    if (tap.leftAStroke)
        document.undo();
    const auto picked = context().pick(sample.position, sample.device);
    if (picked)
        pruneBranches(document, std::array{cutBelow(document.tree(), document.index(), picked->id)});
    return picked.has_value();
}

void BrushTool::beginStroke(const PointerSample& sample)
{
    m_pointer = sample.position;
    m_pressure = sample.pressure;
    m_isPen = sample.device == PointerDevice::Pen;
    m_hovers = false;
    TreeDocument& document = context().document();
    m_picked = context().pickThick(m_pointer, sample.device);
    m_plane = StrokePlane::of(context(), m_picked);
    m_begun = sample.time;
    m_now = sample.time;
    m_sizeBefore = document.tree().size();
    const BrushSample first = sampleAt(0.0);
    m_trail = {first.position};
    m_gesture = std::make_unique<BrushGesture>(document, first, document.competitors(), StrokeEnd::Arrives,
                                               m_plane.placement());
    context().requestRepaint();
}

void BrushTool::move(const PointerSample& sample)
{
    if (m_sizing) {
        resizeTo(sample.position);
        return;
    }
    if (m_held && !m_held->isChosen && distance(sample.position, m_held->sample.position) > kTapReach) {
        PointerSample first = std::exchange(m_held, {})->sample;
        first.time = sample.time;
        beginStroke(first);
    }
    if (!m_gesture)
        return;
    m_pointer = sample.position;
    m_pressure = sample.pressure;
    continueTo(sample.time);
}

void BrushTool::end(const PointerSample& sample)
{
    if (m_sizing) {
        resizeTo(sample.position);
        m_sizing.reset();
        return;
    }
    if (!isActive())
        return;
    if (m_gesture) {
        // A pen's last sample has no pressure: the sample before it counts.
        m_pointer = sample.position;
        continueTo(sample.time);
        m_gesture->finish();
    }
    const bool isTap = !(m_held && m_held->isChosen) && sample.time - m_press.time < kTap &&
                       distance(sample.position, m_press.position) < kTapReach;
    if (isTap)
        m_lastTap = {sample.position, sample.time, context().document().undoStack().index() > m_undoIndex};
    m_hovers = sample.device != PointerDevice::Finger;
    stop();
}

void BrushTool::finish()
{
    if (m_gesture)
        m_gesture->finish();
    if (isActive())
        stop();
}

void BrushTool::cancel()
{
    if (!isActive())
        return;
    if (m_sizing)
        context().viewSettings().set(&ViewValues::brushRadius, m_sizing->radius);
    if (m_gesture)
        m_gesture->cancel();
    stop();
}

void BrushTool::stop()
{
    m_gesture.reset();
    m_held.reset();
    m_sizing.reset();
    m_trail.clear();
    m_picked.reset();
    m_pressure = 1.0;
    context().requestRepaint();
}

void BrushTool::hover(const PointerSample& sample)
{
    m_pointer = sample.position;
    m_pressure = 1.0;
    m_hovers = true;
    m_picked = context().pickThick(m_pointer, sample.device);
    m_plane = StrokePlane::of(context(), m_picked);
    context().requestRepaint();
}

void BrushTool::leave()
{
    m_hovers = false;
    m_picked.reset();
    context().requestRepaint();
}

void BrushTool::tick(double now)
{
    m_now = now;
    if (m_gesture)
        rest(now);
    if (!m_held || m_held->isChosen)
        return;
    context().requestRepaint();
    if (now - m_held->sample.time < kLongPress)
        return;
    m_held->isChosen = true;
    context().document().setCompetitors({m_held->bud.bud.node, m_held->bud.bud.slot});
}

void BrushTool::wheel(double notches)
{
    ViewSettings& settings = context().viewSettings();
    settings.set(&ViewValues::brushRadius, steppedBrushRadius(settings.values().brushRadius, notches));
    context().requestRepaint();
}

double BrushTool::radiusShare(double pressure)
{
    return 0.1 + 0.9 * std::pow(std::clamp(pressure, 0.0, 1.0), 0.8);
}

BrushSample BrushTool::sampleAt(double time) const
{
    const ViewValues& view = context().viewSettings().values();
    const double share = m_isPen && view.pressureScales ? radiusShare(m_pressure) : 1.0;
    return {time, m_plane.under(context().camera(), m_pointer), static_cast<float>(view.brushRadius * share)};
}

/// s since the stroke began, in steps that are finer than any device's clock: it does not depend on when the
/// program was started.
double BrushTool::strokeTime(double time) const
{
    return std::round((time - m_begun) / kClockStep) * kClockStep;
}

void BrushTool::continueTo(double time)
{
    const BrushSample sample = sampleAt(strokeTime(time));
    const float stride = 6.0F / context().camera().pixelsPerMetre(context().camera().distance());
    if ((sample.position - m_trail.back()).norm() > stride)
        m_trail.push_back(sample.position);
    m_gesture->follow(sample);
    context().requestRepaint();
}

/// The pointer gives no samples; the camera may carry the brush on, and the wheel change its radius.
void BrushTool::rest(double now)
{
    const BrushSample sample = sampleAt(strokeTime(now));
    const BrushSample& last = m_gesture->path().back();
    if (sample.position != last.position || sample.radius != last.radius)
        continueTo(now);
    m_gesture->rest(sample.time);
    m_gesture->catchUp(kGrowthTime);
    context().requestRepaint();
}

/// Where the brush is while the pointer is at @p centre: there, and at its copies around the trunk.
std::vector<Vec3> BrushTool::shownBrushes(const Vec3& centre) const
{
    if (m_gesture)
        return m_gesture->placed(centre);
    const TreeDocument& document = context().document();
    StrokePlacement placement = m_plane.placement();
    placement.isSpread = false;
    const StrokeTurns turns(document.tree(), document.index(), placement, 0.0F);
    std::vector<Vec3> places;
    for (int copy = 0; copy < placement.copies; ++copy)
        places.push_back(turns.placed(centre, copy));
    return places;
}

void BrushTool::paint(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    const ViewValues& view = context().viewSettings().values();
    if (m_gesture && view.markersShown)
        overlay.addDots(m_gesture->markers(), isBackdropLight(view) ? kMarkerOverLight : kMarkerColour, 3.0F,
                        0.7F);
    if (m_held && !m_held->isChosen) {
        // The ring closes in on the bud until it is chosen.
        const Vec3& place = m_held->bud.position;
        const auto share =
            static_cast<float>(std::clamp((m_now - m_held->sample.time) / kLongPress, 0.0, 1.0));
        overlay.addCircle(place, camera.right(), camera.up(),
                          (kHeldRing - share * (kHeldRing - kRing)) /
                              camera.pixelsPerMetre(camera.depth(place)),
                          kPickedColour, 2.5F);
    }
    if (!m_gesture && !m_hovers)
        return;

    const BrushSample brush = sampleAt(0.0);
    const Vec3& centre = brush.position;
    if (view.planeShown) {
        const float reach = std::max(3.0F * brush.radius, 0.12F * camera.distance());
        QColor faint = isBackdropLight(view) ? kHintOverLight : kHintColour;
        faint.setAlphaF(0.2F);
        overlay.addGrid({.centre = centre,
                         .right = m_plane.right(camera),
                         .up = m_plane.up(camera),
                         .extent = reach,
                         .spacing = std::exp2(std::round(std::log2(reach / 4.0F))),
                         .origin = m_plane.anchor(),
                         .colour = faint});
        // A plumb line and its foot show the brush's place over the ground; the plane meets the ground in a
        // level line.
        const Vec3 foot(centre.x(), 0.0F, centre.z());
        faint.setAlphaF(0.5F);
        overlay.addLine(std::array{centre, foot}, faint, 1.0F, 4.0F);
        overlay.addCircle(foot, Vec3::UnitX(), Vec3::UnitZ(),
                          std::max(brush.radius, 0.01F * camera.distance()), faint, 1.0F);
        const Vec3 planeUp = m_plane.up(camera);
        if (planeUp.y() > kGrazing) {
            const Vec3 meets = centre - centre.y() / planeUp.y() * planeUp;
            const Vec3 aside = reach * m_plane.right(camera);
            overlay.addLine(std::array{Vec3(meets - aside), Vec3(meets + aside)}, faint, 1.0F);
        }
    }
    if (m_trail.size() > 1) {
        std::vector<Vec3> trail = m_trail;
        trail.push_back(centre);
        overlay.addLine(trail, kBrushColour, 1.8F, 5.0F);
    }
    const std::vector<Vec3> brushes = shownBrushes(centre);
    for (const Vec3& place : brushes) {
        if (brush.radius > 0.0F)
            overlay.addSphere({place, brush.radius, kBrushColour, m_gesture ? 0.16F : 0.09F});
    }
    // A stroke that is turned about the trunk grows there, and not under the pointer.
    if (m_gesture)
        overlay.addDots(brushes, kBrushColour, 5.0F);
    overlay.addDots(std::array{centre}, kPickedColour, 5.0F);
    paintReason(overlay);
    if (m_picked && !m_gesture) {
        const float radius = kRing / camera.pixelsPerMetre(camera.depth(m_picked->position));
        overlay.addCircle(m_picked->position, camera.right(), camera.up(), radius, kPickedColour, 2.0F);
    }
}

/// Says why nothing grows, before the pointer is lifted.
void BrushTool::paintReason(Overlay& overlay) const
{
    const TreeDocument& document = context().document();
    if (!m_gesture || m_now - m_begun < kReasonAfter || document.tree().size() > m_sizeBefore)
        return;
    const QString reason = document.competitors().areAll()
                               ? tr("No bud sees this place: keep drawing, or begin at a branch")
                               : tr("Only the chosen bud grows, and it does not see this place");
    overlay.addLabel({sampleAt(0.0).position, QPointF(16.0, 0.0), reason, kPickedColour});
}

QString BrushTool::tip() const
{
    return tr("Drag to brush a tree into being; begin at a branch to draw at its depth");
}

} // namespace espalier
