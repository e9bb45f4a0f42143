// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/MoveTool.h"

#include "model/sketch/DrawnBranch.h"
#include "model/sketch/FlatTree.h"
#include "views/tools/ToolColours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace espalier {

namespace {

/// Movement below which a press moves nothing, px.
constexpr double kMoveSlip = 4.0;
constexpr double kMoveFingerSlip = 9.0;
/// The shares of a branch at its ends by which it is held there.
constexpr double kBaseShare = 0.18;
constexpr double kTipShare = 0.82;
/// Seen at a sharper angle than this has as its sine, the wood is no line to slide along.
constexpr float kLeastSlant = 0.25F;
/// Scales are round, so that recipes are short.
constexpr double kScaleSteps = 1000.0;
constexpr double kLeastDragScale = 0.1;
constexpr double kMostDragScale = 10.0;
/// Diameters of the dots on the ends of a branch, px.
constexpr float kEndDot = 7.0F;
constexpr float kHeldDot = 11.0F;
constexpr float kMovedLine = 2.5F; ///< px

/// The angle of a point that goes around a ring with the pointer: the ring is seen from its side, its radius
/// is 1, and @p x is the pointer's distance from the middle. 0 at the right end; in front of the ring, the
/// point is under the pointer; beyond its ends, it goes on behind it.
double angleAt(double x)
{
    if (x > 1.0)
        return 1.0 - x;
    if (x < -1.0)
        return std::numbers::pi - 1.0 - x;
    return std::acos(x);
}

} // namespace

std::optional<MoveTool::Held> MoveTool::heldAt(const PointerSample& sample) const
{
    const TreeDocument& document = context().document();
    const std::optional<PickedBranch> picked = context().pick(sample.position, sample.device);
    if (!picked)
        return std::nullopt;
    const BranchAxis axis(document.tree(), document.index(), picked->id);
    const auto number = static_cast<std::size_t>(std::ranges::find(axis.internodes(), picked->id) -
                                                 axis.internodes().begin());
    const double share = axis.distanceOf({number, picked->along}) / axis.length();
    return Held{.axis = document.index().axis(picked->id),
                .part = share < kBaseShare  ? Part::Base
                        : share > kTipShare ? Part::Tip
                                            : Part::Middle,
                .grip = picked->position,
                .revision = document.revision()};
}

void MoveTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    m_held = heldAt(sample);
    m_pressed = m_pointer = sample.position;
    m_slip = sample.device == PointerDevice::Finger ? kMoveFingerSlip : kMoveSlip;
    context().requestRepaint();
}

void MoveTool::move(const PointerSample& sample)
{
    if (!m_isDown)
        return;
    m_pointer = sample.position;
    const QPointF way = m_pointer - m_pressed;
    if (m_held && !m_gesture && std::hypot(way.x(), way.y()) > m_slip)
        grip();
    m_isSettled = false;
}

void MoveTool::grip()
{
    TreeDocument& document = context().document();
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    const InternodeId first = m_held->axis;
    if (m_held->revision != document.revision()) {
        m_held.reset();
        return;
    }
    if (tree.isRoot(first)) {
        m_held.reset();
        m_refused(tr("a trunk stays where it stands; drag a branch"));
        return;
    }
    const InternodeId parent = tree.parent(first);
    const float along = tree.columns().along[first];
    BranchAxis axis(tree, index, parent);
    const auto number =
        static_cast<std::size_t>(std::ranges::find(axis.internodes(), parent) - axis.internodes().begin());
    const double distance = axis.distanceOf({number, along});
    m_start = Start{.parent = std::move(axis),
                    .place = {parent, along},
                    .distance = distance,
                    .base = index.basePosition(tree, first),
                    .heading = index.heading(parent),
                    .rotation = index.rotation(first),
                    .local = tree.columns().rotation[first],
                    .end = tree.size(),
                    .isFlat = isFlat(tree, index)};
    m_gesture = std::make_unique<MoveGesture>(document);
}

void MoveTool::tick(double)
{
    // The branch is moved once for each picture, not for each sample.
    if (m_gesture && !m_isSettled)
        pull();
}

void MoveTool::pull()
{
    m_isSettled = true;
    BranchMove move;
    switch (m_held->part) {
    case Part::Base:
        move = reattached();
        break;
    case Part::Middle:
        move = slid();
        break;
    case Part::Tip:
        move = scaled();
        break;
    }
    if (const Result<void> done = m_gesture->set(move); !done)
        m_refused(done.error().message);
    context().requestRepaint();
}

/// The move of the held branch that gives its first internode @p rotation in the world. What it stands on
/// does not move.
BranchMove MoveTool::placedAt(const BranchPlace& place, const Rotation& rotation) const
{
    const Rotation& below = context().document().index().rotation(place.internode);
    return {.branch = m_held->axis, .place = place, .rotation = (below.conjugate() * rotation).normalized()};
}

BranchMove MoveTool::slid() const
{
    const Camera& camera = context().camera();
    const Vec3 forward = camera.forward();
    const Vec3 way = camera.onPlane(m_pointer, m_held->grip) - camera.onPlane(m_pressed, m_held->grip);
    const Vec3 seen = m_start->heading - m_start->heading.dot(forward) * forward;
    const float slant = seen.squaredNorm();
    const double shift = slant > kLeastSlant * kLeastSlant ? double{way.dot(seen)} / double{slant} : 0.0;
    const BranchAxis::Place at =
        m_start->parent.at(std::clamp(m_start->distance + shift, 0.0, m_start->parent.length()));
    const BranchPlace place{m_start->parent.internodes()[at.number], at.along};
    const Vec3 heading = context().document().index().heading(place.internode);
    const Rotation carried = Rotation::FromTwoVectors(m_start->heading, heading);
    const Rotation turn(Eigen::AngleAxisf(static_cast<float>(turnAround()), heading));
    return placedAt(place, turn * carried * m_start->rotation);
}

/// By how much the pointer has taken the grip around the wood that the branch stands on, rad.
double MoveTool::turnAround() const
{
    const Camera& camera = context().camera();
    const Vec3 forward = camera.forward();
    const Vec3 seen = m_start->heading - m_start->heading.dot(forward) * forward;
    if (seen.norm() < kLeastSlant)
        return 0.0;
    const Vec3 across = forward.cross(seen).normalized();
    const Vec3 way = camera.onPlane(m_pointer, m_held->grip) - camera.onPlane(m_pressed, m_held->grip);
    Vec3 arm = m_held->grip - m_start->base;
    arm -= arm.dot(m_start->heading) * m_start->heading;
    const double radius = std::hypot(arm.dot(across), arm.dot(forward));
    if (!(radius > 0.0))
        return 0.0;
    const double from = double{arm.dot(across)} / radius;
    const double to = from + double{way.dot(across)} / radius;
    if (m_start->isFlat)
        return from * to < 0.0 ? std::numbers::pi : 0.0;
    const double side = arm.dot(forward) <= 0.0F ? 1.0 : -1.0;
    return side * (angleAt(from) - angleAt(to));
}

BranchMove MoveTool::reattached() const
{
    const TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    const auto seen = [&camera](const Vec3& point) -> std::optional<Eigen::Vector2d> {
        const std::optional<QPointF> place = camera.project(point);
        return place ? std::optional(Eigen::Vector2d(place->x(), place->y())) : std::nullopt;
    };
    const std::optional<Eigen::Vector2d> base = seen(m_start->base);
    if (!base)
        return placedAt(m_start->place, m_start->rotation);
    const QPointF way = m_pointer - m_pressed;
    const Eigen::Vector2d wanted = *base + Eigen::Vector2d(way.x(), way.y());
    // The branch itself is not there: where it was it is dead, and where it is now it is new.
    const auto isWood = [&](InternodeId id) {
        return id < m_start->end && (m_gesture->branch() || !carries(m_held->axis, id));
    };
    const std::optional<Attachment> nearest =
        nearestAttachment(document.tree(), document.index(), seen, wanted, wanted, isWood);
    return placedAt(nearest ? nearest->place : m_start->place, m_start->rotation);
}

/// Whether @p id is on the branch that begins with @p first.
bool MoveTool::carries(InternodeId first, InternodeId id) const
{
    const Tree& tree = context().document().tree();
    while (id != kNoInternode && id > first)
        id = tree.parent(id);
    return id == first;
}

BranchMove MoveTool::scaled() const
{
    const Camera& camera = context().camera();
    const Vec3 forward = camera.forward();
    const Vec3 way = camera.onPlane(m_pointer, m_held->grip) - camera.onPlane(m_pressed, m_held->grip);
    Vec3 arm = m_held->grip - m_start->base;
    arm -= arm.dot(forward) * forward;
    const double square = arm.squaredNorm();
    const double scale = square > 0.0 ? 1.0 + double{way.dot(arm)} / square : 1.0;
    BranchMove move = placedAt(m_start->place, m_start->rotation);
    move.rotation = m_start->local;
    move.scale = std::round(std::clamp(scale, kLeastDragScale, kMostDragScale) * kScaleSteps) / kScaleSteps;
    return move;
}

void MoveTool::end(const PointerSample& sample)
{
    move(sample);
    finish();
}

void MoveTool::finish()
{
    if (m_gesture) {
        if (!m_isSettled)
            pull();
        m_gesture->finish();
    }
    m_gesture.reset();
    m_start.reset();
    m_isDown = false;
    leave();
}

void MoveTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    m_gesture.reset();
    m_start.reset();
    m_isDown = false;
    leave();
}

void MoveTool::hover(const PointerSample& sample)
{
    m_held = heldAt(sample);
    context().requestRepaint();
}

void MoveTool::leave()
{
    m_held.reset();
    context().requestRepaint();
}

void MoveTool::paint(Overlay& overlay) const
{
    const TreeDocument& document = context().document();
    const TreeIndex& index = document.index();
    if (!m_held)
        return;
    InternodeId first = m_held->axis;
    if (m_gesture)
        first = m_gesture->branch().value_or(first);
    else if (m_held->revision != document.revision())
        return;
    if (document.tree().isRoot(first))
        return;
    std::vector<Vec3> line{index.basePosition(document.tree(), first)};
    for (InternodeId id = first; id != kNoInternode; id = index.mainChild(id))
        line.push_back(index.nodePosition(id));
    overlay.addLine(line, kPickedColour, kMovedLine);
    overlay.addDots(std::array{line.front()}, kPickedColour, m_held->part == Part::Base ? kHeldDot : kEndDot);
    overlay.addDots(std::array{line.back()}, kPickedColour, m_held->part == Part::Tip ? kHeldDot : kEndDot);
}

QString MoveTool::tip() const
{
    return tr("Drag a branch along the wood or around it; drag its base to other wood, its tip to scale it");
}

} // namespace espalier
