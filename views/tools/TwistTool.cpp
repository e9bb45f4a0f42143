// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/TwistTool.h"

#include "model/settings/Lengths.h"
#include "views/tools/ToolColours.h"

#include <cmath>
#include <utility>

namespace espalier {

namespace {

constexpr double kTwistSlip = 4.0;       ///< How far a tap may slip, px
constexpr double kTwistDoubleTap = 0.45; ///< s between the taps of a double tap
constexpr int kShownStrands = 5;         ///< Lines around a branch
constexpr int kStrandPoints = 6;         ///< Points of a line an internode
constexpr int kMostShown = 400;          ///< Internodes that show lines
constexpr float kLeastShown = 1.5F;      ///< Radius of the branches that show lines, px
constexpr float kStrandLift = 1.03F;     ///< Radius of the lines, in radii of the bark

double lengthOf(const QPointF& way)
{
    return std::hypot(way.x(), way.y());
}

} // namespace

TwistScope TwistTool::scopeOf(const PointerSample& sample) const
{
    const bool isShift = sample.modifiers.testFlag(Qt::ShiftModifier);
    return context().viewSettings().values().twistsSubtree != isShift ? TwistScope::Subtree
                                                                      : TwistScope::Branch;
}

/// The twist at a node, degrees.
double TwistTool::twistOf(InternodeId id) const
{
    const float* twist = context().document().tree().content().sparse.twist.find(id);
    return twist ? degrees(static_cast<double>(*twist)) : 0.0;
}

std::optional<InternodeId> TwistTool::internodeAt(const PointerSample& sample) const
{
    const auto picked = context().pickThick(sample.position, sample.device);
    return picked ? std::optional(picked->id) : std::nullopt;
}

void TwistTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    m_isPulled = false;
    m_pressedAt = sample.position;
    m_at = sample.position;
    m_hovered.reset();
    context().requestRepaint();
    const std::optional<InternodeId> picked = internodeAt(sample);
    if (!picked)
        return;
    const TreeDocument& document = context().document();
    const bool isSecondTap = sample.time - std::exchange(m_tapTime, -1e9) < kTwistDoubleTap &&
                             m_id < document.index().size() &&
                             document.index().axis(m_id) == document.index().axis(*picked);
    if (!isSecondTap)
        m_id = *picked;
    m_scope = scopeOf(sample);
    m_from = twistOf(m_id);
    const Camera& camera = context().camera();
    const auto lower = camera.project(document.index().basePosition(document.tree(), m_id));
    const auto upper = camera.project(document.index().nodePosition(m_id));
    const QPointF upward = lower && upper ? *upper - *lower : QPointF();
    const double length = lengthOf(upward);
    m_upward = length > 1.0 ? upward / length : QPointF(0.0, -1.0);
    m_gesture = std::make_unique<TwistGesture>(context().document(), m_id, m_scope);
    if (isSecondTap) {
        m_gesture->set(0.0);
        m_gesture->finish();
    }
}

void TwistTool::move(const PointerSample& sample)
{
    const QPointF way = sample.position - m_pressedAt;
    m_at = sample.position;
    if (!m_gesture || (!m_isPulled && lengthOf(way) <= kTwistSlip))
        return;
    // Above 0, strands lean to the left on their way up.
    const double along = QPointF::dotProduct(way, m_upward);
    const double around = QPointF::dotProduct(way, {m_upward.y(), -m_upward.x()});
    if (!std::exchange(m_isPulled, true))
        m_isAround = std::abs(around) > std::abs(along);
    m_gesture->set(m_from + kDegreesPerPixel * (m_isAround ? around : along));
    context().requestRepaint();
}

void TwistTool::end(const PointerSample& sample)
{
    move(sample);
    if (m_gesture) {
        if (m_isPulled)
            m_gesture->finish();
        else
            m_tapTime = sample.time;
    }
    stop();
}

void TwistTool::finish()
{
    if (m_gesture && m_isPulled)
        m_gesture->finish();
    stop();
}

void TwistTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    stop();
}

void TwistTool::stop()
{
    m_gesture.reset();
    m_isDown = false;
    context().requestRepaint();
}

void TwistTool::hover(const PointerSample& sample)
{
    m_at = sample.position;
    m_hovered = internodeAt(sample);
    m_scope = scopeOf(sample);
    context().requestRepaint();
}

void TwistTool::leave()
{
    m_hovered.reset();
    context().requestRepaint();
}

bool TwistTool::keyPressed(int key)
{
    if ((key != Qt::Key_Delete && key != Qt::Key_Backspace) || !m_hovered)
        return false;
    twistBranch(context().document(), *m_hovered, m_scope, 0.0);
    context().requestRepaint();
    return true;
}

void TwistTool::forget()
{
    leave();
    m_tapTime = -1e9;
}

void TwistTool::renumber(const NewNumbers& internodes)
{
    leave();
    m_id = internodes[m_id];
}

/// Paints lines that wind around the axis of @p id, from that internode on, as its strands do.
void TwistTool::paintStrands(Overlay& overlay, InternodeId id) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    std::vector<std::vector<Vec3>> lines(kShownStrands);
    Vec3 heading = index.heading(id);
    Vec3 aside = anyPerpendicular(heading);
    double turn = 0.0; // of the lines at the internode's lower end
    for (InternodeId on = id; on != kNoInternode; on = index.mainChild(on)) {
        aside = Eigen::Quaternionf::FromTwoVectors(heading, index.heading(on)) * aside;
        heading = index.heading(on);
        aside = (aside - aside.dot(heading) * heading).normalized();
        const Vec3 other = heading.cross(aside);
        const Vec3 base = index.basePosition(tree, on);
        const Vec3& node = index.nodePosition(on);
        const float radius = kStrandLift * context().branchRadius(on);
        // What is turned to the right below is turned to the left above it.
        const double by = -radians(twistOf(on));
        for (int i = on == id ? 0 : 1; i <= kStrandPoints; ++i) {
            const double share = static_cast<double>(i) / kStrandPoints;
            const Vec3 middle = base + static_cast<float>(share) * (node - base);
            for (int k = 0; k < kShownStrands; ++k) {
                const double angle = turn + by * share + 2.0 * std::numbers::pi * k / kShownStrands;
                lines[static_cast<std::size_t>(k)].push_back(
                    middle + radius * static_cast<float>(std::cos(angle)) * aside +
                    radius * static_cast<float>(std::sin(angle)) * other);
            }
        }
        turn += by;
    }
    for (const std::vector<Vec3>& line : lines)
        overlay.addLine(line, m_gesture ? kBrushColour : kPickedColour, m_gesture ? 2.0F : 1.4F);
}

void TwistTool::paint(Overlay& overlay) const
{
    const TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    const std::optional<InternodeId> shown = m_gesture ? std::optional(m_id) : m_hovered;
    if (!shown || *shown >= document.tree().size() || !document.tree().isAlive(*shown))
        return;
    paintStrands(overlay, *shown);
    if (m_scope == TwistScope::Subtree) {
        int count = 0;
        for (const InternodeId id :
             twistedInternodes(document.tree(), document.index(), *shown, TwistScope::Subtree)) {
            const bool begins = document.index().axis(id) == id && id != *shown;
            const float depth = camera.depth(document.index().nodePosition(id));
            if (!begins || depth < Camera::kMinDistance ||
                context().branchRadius(id) * camera.pixelsPerMetre(depth) < kLeastShown)
                continue;
            for (InternodeId on = id; on != kNoInternode; on = document.index().mainChild(on))
                ++count;
            if (count > kMostShown)
                break;
            paintStrands(overlay, id);
        }
    }
    if (const double angle = m_gesture && m_isPulled ? m_gesture->angle() : twistOf(*shown);
        angle != 0.0 || m_gesture)
        overlay.addLabel({camera.onPlane(m_at, document.index().nodePosition(*shown)),
                          {18.0, 0.0},
                          tr("%1° from node to node").arg(numberText(angle, 1)),
                          m_gesture ? kBrushColour : kPickedColour});
}

QString TwistTool::tip() const
{
    return tr("Drag along a branch, or around it, to twist its strands; double-tap to untwist them");
}

} // namespace espalier
