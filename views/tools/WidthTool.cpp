// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/WidthTool.h"

#include "model/settings/Lengths.h"
#include "model/shape/Widths.h"

#include <array>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

constexpr double kReach = 10.0; ///< px
constexpr double kWidthFingerReach = 22.0;
constexpr double kWidthSlip = 4.0;       ///< How far a tap may slip, px
constexpr double kWidthDoubleTap = 0.45; ///< s between the taps of a double tap
/// Up to so many handles have their number beside them all the time.
constexpr std::size_t kMostLabels = 8;

const QColor kHandleColour(232, 168, 100);
const QColor kLitColour(255, 205, 140);
const QColor kWidthHintColour(190, 202, 218);

double dot(const QPointF& a, const QPointF& b)
{
    return QPointF::dotProduct(a, b);
}

double pulledLength(const QPointF& way)
{
    return std::hypot(way.x(), way.y());
}

} // namespace

std::optional<WidthTool::Place> WidthTool::placeOf(InternodeId id) const
{
    const TreeDocument& document = context().document();
    const Camera& camera = context().camera();
    if (id >= document.tree().size() || !document.tree().isAlive(id))
        return std::nullopt;
    const Vec3 middle =
        0.5F * (document.index().basePosition(document.tree(), id) + document.index().nodePosition(id));
    const Vec3 toEye = (camera.position() - middle).normalized();
    Vec3 across = document.index().heading(id).cross(camera.forward());
    across = across.norm() > 1e-3F ? Vec3(across.normalized()) : camera.right();
    if (across.dot(camera.right()) < 0.0F)
        across = -across; // To the right, where the text is.
    const Vec3 centre = middle + 1.1F * context().branchRadius(id) * toEye;
    const auto seen = camera.project(middle);
    const float depth = camera.depth(middle);
    if (!seen || depth < Camera::kMinDistance / 2.0F)
        return std::nullopt;
    // Parallel to the screen, so the direction on the screen is the direction of its picture.
    const QPointF seenAcross(static_cast<double>(across.dot(camera.right())),
                             -static_cast<double>(across.dot(camera.up())));
    return Place{centre, across, *seen, seenAcross, static_cast<double>(camera.pixelsPerMetre(depth))};
}

std::optional<WidthTool::Grip> WidthTool::gripAt(const PointerSample& sample) const
{
    double best = sample.device == PointerDevice::Finger ? kWidthFingerReach : kReach;
    std::optional<Grip> nearest;
    const auto consider = [&](const QPointF& position, const Grip& grip) {
        const double distance = pulledLength(sample.position - position);
        if (distance > best)
            return;
        best = distance;
        nearest = grip;
    };
    for (const auto& [id, diameter] : context().document().tree().widthConstraints()) {
        const auto place = placeOf(id);
        if (!place)
            continue;
        const double reach = static_cast<double>(diameter) / 2.0 * place->pixelsPerMetre + kBeyond;
        consider(place->seen + reach * place->seenAcross, {id, Part::End});
        consider(place->seen - reach * place->seenAcross, {id, Part::End});
        consider(place->seen, {id, Part::Middle});
    }
    return nearest;
}

std::optional<InternodeId> WidthTool::branchAt(const PointerSample& sample) const
{
    const auto picked = context().pickThick(sample.position, sample.device);
    return picked ? std::optional(picked->id) : std::nullopt;
}

double WidthTool::diameterOf(InternodeId id) const
{
    const TreeDocument& document = context().document();
    if (const float set = document.tree().widthConstraint(id); set > 0.0F)
        return static_cast<double>(set);
    return 2.0 * static_cast<double>(Widths(document.tree(), document.index()).radius(document.index(), id));
}

/// The internode of the gripped handle's axis whose middle appears nearest to @p position.
InternodeId WidthTool::nearestOnAxis(const QPointF& position) const
{
    const TreeIndex& index = context().document().index();
    InternodeId nearest = m_grip->id;
    double best = std::numeric_limits<double>::infinity();
    for (InternodeId id = index.axis(m_grip->id); id != kNoInternode; id = index.mainChild(id)) {
        const auto place = placeOf(id);
        if (!place)
            continue;
        if (const double distance = pulledLength(place->seen - position); distance < best) {
            best = distance;
            nearest = id;
        }
    }
    return nearest;
}

void WidthTool::begin(const PointerSample& sample)
{
    m_isDown = true;
    m_isPulled = false;
    m_hoveredBranch.reset();
    m_pressedAt = sample.position;
    m_labelled = context().labelAt(sample.position);
    if (m_labelled)
        return;
    m_grip = gripAt(sample);
    if (!m_grip) {
        if (const auto branch = branchAt(sample))
            m_grip = Grip{*branch, context().document().tree().widthConstraint(*branch) > 0.0F ? Part::Middle
                                                                                               : Part::Bark};
    }
    m_hovered = m_grip;
    const bool isSecondTap = m_grip && m_grip->part != Part::Bark && m_chosen == m_grip->id &&
                             sample.time - std::exchange(m_tapTime, -1e9) < kWidthDoubleTap;
    m_chosen = m_grip ? std::optional(m_grip->id) : std::nullopt;
    context().requestRepaint();
    if (!m_grip)
        return;
    m_place = m_grip->id;
    m_diameter = diameterOf(m_grip->id);
    if (const auto place = placeOf(m_grip->id))
        m_distance = std::abs(dot(sample.position - place->seen, place->seenAcross));
    m_gesture = std::make_unique<WidthGesture>(context().document(), m_grip->id);
    if (isSecondTap) {
        m_gesture->set(0.0);
        m_gesture->finish();
    } else if (m_grip->part == Part::Bark) {
        m_gesture->set(m_diameter);
    }
}

void WidthTool::move(const PointerSample& sample)
{
    if (!m_gesture)
        return;
    m_isPulled = m_isPulled || pulledLength(sample.position - m_pressedAt) > kWidthSlip;
    const auto place = placeOf(m_grip->id);
    if (!m_isPulled || !place)
        return;
    if (m_grip->part == Part::Middle) {
        m_place = nearestOnAxis(sample.position);
        m_chosen = m_place;
        m_gesture->set(m_place, m_diameter);
    } else {
        const double distance = std::abs(dot(sample.position - place->seen, place->seenAcross));
        const double diameter = m_diameter + 2.0 * (distance - m_distance) / place->pixelsPerMetre;
        const bool vanishes = m_grip->part == Part::End && distance < kVanishing;
        m_gesture->set(vanishes ? 0.0 : std::max(diameter, kLeastDiameter));
    }
    context().requestRepaint();
}

void WidthTool::end(const PointerSample& sample)
{
    if (m_labelled && context().labelAt(sample.position) == m_labelled) {
        const InternodeId id = *m_labelled;
        stop();
        type(id);
        return;
    }
    move(sample);
    if (m_gesture) {
        m_gesture->finish();
        if (!m_isPulled && m_grip->part != Part::Bark)
            m_tapTime = sample.time;
    }
    stop();
}

void WidthTool::finish()
{
    if (m_gesture)
        m_gesture->finish();
    stop();
}

void WidthTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    stop();
}

void WidthTool::stop()
{
    m_gesture.reset();
    m_labelled.reset();
    m_grip.reset();
    m_hovered.reset();
    m_isDown = false;
    context().requestRepaint();
}

void WidthTool::hover(const PointerSample& sample)
{
    m_hovered = gripAt(sample);
    if (const auto labelled = context().labelAt(sample.position))
        m_hovered = Grip{*labelled, Part::End};
    m_hoveredBranch = m_hovered ? std::nullopt : branchAt(sample);
    context().requestRepaint();
}

void WidthTool::leave()
{
    m_hovered.reset();
    m_hoveredBranch.reset();
    context().requestRepaint();
}

/// Lets the user type the width at @p id.
void WidthTool::type(InternodeId id)
{
    TreeDocument& document = context().document();
    if (!document.tree().isAlive(id) || document.tree().widthConstraint(id) <= 0.0F)
        return;
    m_chosen = id;
    context().editLabel(id, lengthText(diameterOf(id)), [&document, id](const QString& text) {
        const std::optional<double> metres = parseLength(text, units() == Units::Metric ? 0.01 : kInch);
        if (!metres || *metres < 0.0 || *metres > static_cast<double>(kGreatestDiameter))
            return false;
        if (document.tree().isAlive(id))
            setWidth(document, id, *metres);
        return true;
    });
}

bool WidthTool::keyPressed(int key)
{
    if (key == Qt::Key_Escape && m_chosen) {
        m_chosen.reset();
        context().requestRepaint();
        return true;
    }
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && m_chosen) {
        type(*m_chosen);
        return true;
    }
    if (key != Qt::Key_Delete && key != Qt::Key_Backspace)
        return false;
    const auto id = m_hovered ? std::optional(m_hovered->id) : m_chosen;
    if (!id)
        return false;
    setWidth(context().document(), *id, 0.0);
    leave();
    return true;
}

void WidthTool::forget()
{
    leave();
    m_chosen.reset();
}

void WidthTool::renumber(const NewNumbers& internodes)
{
    leave();
    if (m_chosen)
        m_chosen = internodes[*m_chosen];
    if (m_chosen && !context().document().tree().isAlive(*m_chosen))
        m_chosen.reset();
}

void WidthTool::paintHandle(Overlay& overlay, InternodeId id, bool isLit, bool isLabelled) const
{
    const auto place = placeOf(id);
    if (!place)
        return;
    const double diameter = diameterOf(id);
    const auto bark = static_cast<float>(diameter / 2.0);
    const auto beyond = static_cast<float>(kBeyond / place->pixelsPerMetre);
    const Vec3 reach = (bark + beyond) * place->across;
    const std::array ends{Vec3(place->centre - reach), Vec3(place->centre + reach)};
    const QColor& colour = isLit ? kLitColour : kHandleColour;
    overlay.addLine(ends, colour, isLit ? 2.6F : 2.0F);
    overlay.addDots(ends, colour, isLit ? 11.0F : 9.0F, isLit ? 0.4F : 0.0F);
    overlay.addDots(std::array{place->centre}, colour, 5.0F);
    if (isLabelled)
        overlay.addLabel({ends[1], {14.0, 0.0}, lengthText(diameter), colour, id});
}

void WidthTool::paint(Overlay& overlay) const
{
    const std::span<const WidthConstraint> constraints = context().document().tree().widthConstraints();
    for (const auto& [id, diameter] : constraints) {
        const bool isHeld = m_gesture && m_place == id;
        const bool isLit = isHeld || (m_hovered && m_hovered->id == id) || m_chosen == id;
        paintHandle(overlay, id, isLit, isLit || constraints.size() <= kMostLabels);
    }
    if (!m_hoveredBranch)
        return;
    if (const auto place = placeOf(*m_hoveredBranch)) {
        const float bark = context().branchRadius(*m_hoveredBranch);
        const auto beyond = static_cast<float>(kBeyond / place->pixelsPerMetre);
        // The handle is drawn like the jaws of callipers.
        for (const float side : {-1.0F, 1.0F}) {
            const std::array jaw{Vec3(place->centre + side * bark * place->across),
                                 Vec3(place->centre + side * (bark + beyond) * place->across)};
            overlay.addLine(jaw, kWidthHintColour, 2.0F);
        }
        overlay.addLabel({place->centre + (bark + beyond) * place->across,
                          {8.0, 0.0},
                          lengthText(2.0 * static_cast<double>(bark)),
                          kWidthHintColour});
    }
}

QString WidthTool::tip() const
{
    return tr("Tap a branch to fix its width; drag the ends of the handle to change it");
}

} // namespace espalier
