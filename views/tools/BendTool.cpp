// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/BendTool.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace espalier {

namespace {

/// Movement below which a press is a tap, px.
constexpr double kSlip = 4.0;
constexpr double kFingerSlip = 9.0;
/// Distance within which a pointer takes a pin, px.
constexpr double kPinReach = 12.0;
constexpr double kFingerPinReach = 24.0;
/// Calls of solve() after the last pointer is lifted, for the form to settle.
constexpr int kLastCalls = 30;

const QColor kPathColour(232, 168, 100);
const QColor kBendHintColour(190, 202, 218);
const QColor kPinColour(240, 168, 184);

double bentLength(const QPointF& way)
{
    return std::hypot(way.x(), way.y());
}

/// Whether one of the two internodes carries the other, or they are the same.
bool areOnOnePath(const Tree& tree, InternodeId a, InternodeId b)
{
    return !pathBetween(tree, std::min(a, b), std::max(a, b)).empty();
}

} // namespace

bool BendTool::isThere(const Pin& pin) const
{
    const Tree& tree = context().document().tree();
    return pin.id < tree.size() && tree.isAlive(pin.id);
}

Vec3 BendTool::placeOf(const Pin& pin) const
{
    const TreeDocument& document = context().document();
    const Vec3 lower = document.index().basePosition(document.tree(), pin.id);
    const auto along = static_cast<float>(pin.along);
    return lower + along * (document.index().nodePosition(pin.id) - lower);
}

/// The nearest point of the bark to the camera: a line along the axis would lie within the wood.
Vec3 BendTool::onBark(const Vec3& place, InternodeId id) const
{
    const Vec3 toEye = (context().camera().position() - place).normalized();
    return place + 1.1F * context().branchRadius(id) * toEye;
}

const BendTool::Pin* BendTool::pinAt(const PointerSample& sample) const
{
    const Pin* nearest = nullptr;
    double best = sample.device == PointerDevice::Finger ? kFingerPinReach : kPinReach;
    const auto consider = [&](const Pin& pin) {
        const auto seen = context().camera().project(placeOf(pin));
        if (isThere(pin) && seen && bentLength(*seen - sample.position) <= best) {
            best = bentLength(*seen - sample.position);
            nearest = &pin;
        }
    };
    if (m_base)
        consider(*m_base);
    std::ranges::for_each(m_pins, consider);
    return nearest;
}

std::optional<BendTool::Pin> BendTool::branchAt(const PointerSample& sample) const
{
    const auto picked = context().pickThick(sample.position, sample.device);
    if (!picked)
        return std::nullopt;
    return Pin{picked->id, static_cast<double>(picked->along)};
}

/// The internode from which the branch grows. An axis with at least half of the tips of its parent looks like
/// one branch with it, so the search continues at the parent.
InternodeId BendTool::defaultBase(InternodeId id) const
{
    const Tree& tree = context().document().tree();
    const TreeIndex& index = context().document().index();
    for (;;) {
        id = index.axis(id);
        const InternodeId parent = tree.parent(id);
        if (tree.isRoot(id))
            return id;
        if (2 * index.tipCount(id) < index.tipCount(parent))
            return parent;
        id = parent;
    }
}

InternodeId BendTool::baseFor(const Pin& pin) const
{
    const Tree& tree = context().document().tree();
    if (m_base && isThere(*m_base) && pin.id > m_base->id && areOnOnePath(tree, m_base->id, pin.id))
        return m_base->id;
    return defaultBase(pin.id);
}

void BendTool::dropLostPins()
{
    std::erase_if(m_pins, [this](const Pin& pin) { return !isThere(pin); });
    if (m_base && !isThere(*m_base))
        clearPins();
}

void BendTool::clearPins()
{
    m_base.reset();
    m_pins.clear();
    context().requestRepaint();
}

void BendTool::begin(const PointerSample& sample)
{
    dropLostPins();
    m_hovered.reset();
    m_isDown = true;
    const Pin* pin = m_hands.empty() ? pinAt(sample) : nullptr;
    if (const auto held = pin ? std::optional(*pin) : branchAt(sample)) {
        m_hands.push_back({sample.id, *held, placeOf(*held), sample.position, sample.position});
        if (m_hands.size() > 1)
            grip();
    }
    context().requestRepaint();
}

/// Begins to bend with the current pointers; if a pointer was added, continues with all of them.
void BendTool::grip()
{
    TreeDocument& document = context().document();
    const Tree& tree = document.tree();
    std::ranges::stable_sort(m_hands, {}, [](const Hand& hand) { return hand.pin.id; });
    const Pin& lowest = m_hands.front().pin;
    InternodeId base = baseFor(lowest);
    const bool isPinned = m_base && base == m_base->id;
    if (m_hands.size() > 1 && !isPinned)
        base = lowest.id;

    std::vector<Pin> handles;
    for (const Hand& hand : m_hands)
        handles.push_back(hand.pin);
    for (const Pin& pin : m_pins) {
        const auto isBeside = [&](const Hand& hand) {
            return hand.pin.id != pin.id && areOnOnePath(tree, hand.pin.id, pin.id);
        };
        if (isPinned && std::ranges::all_of(m_hands, isBeside))
            handles.push_back(pin);
    }
    if (m_gesture) {
        m_gesture->regrip(base, handles);
        for (Hand& hand : m_hands)
            hand.pressed = hand.position;
    } else {
        const ViewValues& view = context().viewSettings().values();
        m_gesture = std::make_unique<BendGesture>(
            document, base, handles,
            BendOptions{.stretching = view.stretchingWeight, .bending = view.bendingWeight});
    }
    const std::vector<Vec3>& grips = m_gesture->gripPoints();
    for (std::size_t i = 0; i < m_hands.size(); ++i)
        m_hands[i].grip = grips[i];
    m_pinnedAt.assign(grips.begin() + static_cast<std::ptrdiff_t>(m_hands.size()), grips.end());
    m_isSettled = false;
}

void BendTool::move(const PointerSample& sample)
{
    const auto hand = std::ranges::find(m_hands, sample.id, &Hand::pointer);
    if (hand == m_hands.end())
        return;
    hand->position = sample.position;
    const double slip = sample.device == PointerDevice::Finger ? kFingerSlip : kSlip;
    if (!m_gesture && bentLength(hand->position - hand->pressed) > slip)
        grip();
    m_isSettled = false;
}

void BendTool::tick(double)
{
    // The form is computed once for each picture, not for each sample.
    if (m_gesture && !m_isSettled)
        pull();
}

void BendTool::pull()
{
    const Camera& camera = context().camera();
    std::vector<Vec3> targets;
    for (const Hand& hand : m_hands) {
        targets.emplace_back(camera.onPlane(hand.position, hand.grip) + hand.grip -
                             camera.onPlane(hand.pressed, hand.grip));
    }
    targets.insert(targets.end(), m_pinnedAt.begin(), m_pinnedAt.end());
    m_isSettled = m_gesture->moveTo(targets);
    context().requestRepaint();
}

void BendTool::end(const PointerSample& sample)
{
    if (!m_isDown)
        return;
    move(sample);
    if (!m_gesture)
        tap(m_hands.empty() ? std::nullopt : std::optional(m_hands.front().pin));
    finish();
}

void BendTool::finish()
{
    if (m_gesture) {
        m_isSettled = false;
        for (int call = 0; call < kLastCalls && !m_isSettled; ++call)
            pull();
        m_gesture->finish();
    }
    stop();
}

void BendTool::cancel()
{
    if (m_gesture)
        m_gesture->cancel();
    stop();
}

void BendTool::stop()
{
    m_gesture.reset();
    m_hands.clear();
    m_pinnedAt.clear();
    m_isDown = false;
    context().requestRepaint();
}

void BendTool::tap(const std::optional<Pin>& pin)
{
    if (!pin || (m_base && *m_base == *pin)) {
        clearPins();
        return;
    }
    if (std::erase(m_pins, *pin) > 0)
        return;
    const Tree& tree = context().document().tree();
    if (!m_base || baseFor(*pin) != m_base->id) {
        clearPins();
        m_base = pin;
        return;
    }
    // All pins are on one path.
    std::erase_if(m_pins, [&](const Pin& other) { return !areOnOnePath(tree, other.id, pin->id); });
    m_pins.push_back(*pin);
}

void BendTool::hover(const PointerSample& sample)
{
    dropLostPins();
    const Pin* pin = pinAt(sample);
    m_hovered = pin ? std::optional(*pin) : branchAt(sample);
    context().requestRepaint();
}

void BendTool::leave()
{
    m_hovered.reset();
    context().requestRepaint();
}

bool BendTool::takesFinger(const PointerSample& sample) const
{
    const auto pin = branchAt(sample);
    const Tree& tree = context().document().tree();
    return pin && (!m_isDown || !m_hands.empty()) && std::ranges::all_of(m_hands, [&](const Hand& hand) {
               return areOnOnePath(tree, hand.pin.id, pin->id);
           });
}

bool BendTool::keyPressed(int key)
{
    if (key != Qt::Key_Escape || !m_base)
        return false;
    clearPins();
    return true;
}

void BendTool::forget()
{
    leave();
    clearPins();
}

void BendTool::renumber(const NewNumbers& internodes)
{
    leave();
    if (m_base)
        m_base->id = internodes[m_base->id];
    for (Pin& pin : m_pins)
        pin.id = internodes[pin.id];
    dropLostPins();
}

void BendTool::paintPath(Overlay& overlay, std::span<const InternodeId> path, const QColor& colour) const
{
    const TreeIndex& index = context().document().index();
    std::vector<Vec3> line;
    for (const InternodeId id : path)
        line.push_back(onBark(index.nodePosition(id), id));
    overlay.addLine(line, colour, 2.0F);
}

void BendTool::paint(Overlay& overlay) const
{
    const Camera& camera = context().camera();
    const Tree& tree = context().document().tree();
    const auto place = [this](const Pin& pin) { return onBark(placeOf(pin), pin.id); };
    const auto paintBase = [&](const Vec3& at) {
        const float half = 6.0F / camera.pixelsPerMetre(std::max(camera.depth(at), Camera::kMinDistance));
        const Vec3 right = half * camera.right();
        const Vec3 up = half * camera.up();
        const std::array<Vec3, 5> square{at - right - up, at + right - up, at + right + up, at - right + up,
                                         at - right - up};
        overlay.addLine(square, kPinColour, 2.0F);
    };
    const auto paintPin = [&](const Pin& pin) {
        overlay.addDots(std::array{place(pin)}, kPinColour, 9.0F, 0.3F);
    };
    if (m_gesture) {
        const std::span<const InternodeId> path = m_gesture->path();
        paintPath(overlay, path, kPathColour);
        if (!path.empty() && !(m_base && m_base->id == path.front()))
            paintBase(place({path.front(), 1.0}));
        for (const Hand& hand : m_hands)
            paintPin(hand.pin);
    } else if (m_hovered && isThere(*m_hovered)) {
        std::vector<InternodeId> path = pathBetween(tree, baseFor(*m_hovered), m_hovered->id);
        QColor colour = kBendHintColour;
        colour.setAlphaF(0.8F);
        paintPath(overlay, path, colour);
        overlay.addDots(std::array{place(*m_hovered)}, kBendHintColour, 6.0F);
    }
    if (!m_base || !isThere(*m_base))
        return;
    paintBase(place(*m_base));
    InternodeId top = m_base->id;
    for (const Pin& pin : m_pins) {
        if (!isThere(pin))
            continue;
        paintPin(pin);
        top = std::max(top, pin.id);
    }
    if (!m_gesture)
        paintPath(overlay, pathBetween(tree, m_base->id, top), kPathColour);
}

QString BendTool::tip() const
{
    return tr("Pull a branch to bend it; or tap where the bend begins, then where to hold it");
}

} // namespace espalier
