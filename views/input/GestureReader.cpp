// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/GestureReader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace espalier {

namespace {

/// A pen counts as near for this long after its last sample, s.
constexpr double kPenLinger = 0.6;
/// Fingers closer than this to their centre do not pinch, px.
constexpr double kSmallestSpread = 8.0;
/// Logarithm of the zoom factor of a drag for a px to the right or upwards.
constexpr double kZoomPerPixel = 0.006;

/// The last of @p samples with the finger, or null.
const PointerSample* sampleOf(std::span<const PointerSample> samples, int finger)
{
    const auto found = std::find_if(samples.rbegin(), samples.rend(),
                                    [finger](const PointerSample& sample) { return sample.id == finger; });
    return found == samples.rend() ? nullptr : &*found;
}

/// Movement of the pointer below which a press is a click, px.
constexpr double kClickReach = 4.0;

double pixelsOf(const QPointF& vector)
{
    return std::hypot(vector.x(), vector.y());
}

bool isNear(const QPointF& a, const QPointF& b)
{
    return pixelsOf(a - b) <= kClickReach;
}

} // namespace

void GestureReader::read(std::span<const PointerSample> samples)
{
    if (samples.empty())
        return;
    if (samples.front().device == PointerDevice::Finger) {
        readFingers(samples);
        return;
    }
    for (const PointerSample& sample : samples) {
        if (sample.device == PointerDevice::Pen) {
            m_penDown = sample.phase == PointerPhase::Press || sample.phase == PointerPhase::Move;
            penIsNear(sample.time);
        }
        readPointer(sample);
    }
}

void GestureReader::setPenInReach(bool inReach, double time)
{
    m_penInReach = inReach;
    if (inReach) {
        penIsNear(time);
    } else {
        m_penSeen = -1e9;
        m_penDown = false;
        // The pen's release will not be reported.
        if (m_device == PointerDevice::Pen && m_mode != Mode::Idle) {
            finish();
            m_mode = Mode::Idle;
        }
    }
}

void GestureReader::cancel()
{
    if (m_mode == Mode::Idle)
        return;
    leaveTool();
    m_mode = Mode::Spent;
}

void GestureReader::finish()
{
    if (m_mode != Mode::Tool)
        return;
    m_mode = Mode::Spent;
    m_toolFingers.clear();
    m_target.toolIsFinished();
}

GestureReader::Mode GestureReader::modeOfButton(const PointerSample& sample) const
{
    const bool alt = sample.modifiers.testFlag(Qt::AltModifier);
    if (sample.button == Qt::LeftButton) {
        if (m_panKey)
            return Mode::Pan;
        return alt ? Mode::Orbit : Mode::Tool;
    }
    const bool isMiddle = sample.button == Qt::MiddleButton;
    if (!isMiddle && sample.button != Qt::RightButton)
        return Mode::Idle;
    switch (m_scheme) {
    case MouseScheme::Blender:
        if (!isMiddle)
            return Mode::Menu;
        if (sample.modifiers.testFlag(Qt::ControlModifier))
            return Mode::Zoom;
        break;
    case MouseScheme::Maya:
        if (!alt)
            return isMiddle ? Mode::Idle : Mode::Menu;
        return isMiddle ? Mode::Pan : Mode::Zoom;
    case MouseScheme::Espalier:
        break;
    }
    return isMiddle && sample.modifiers.testFlag(Qt::ShiftModifier) ? Mode::Pan : Mode::Orbit;
}

void GestureReader::readPointer(const PointerSample& sample)
{
    // A gesture that was ended waits for a release, which another window may have got.
    const bool isAnew = sample.device != m_device || sample.button == m_button;
    if (m_mode == Mode::Spent && sample.phase == PointerPhase::Press && isAnew && m_fingers.empty())
        m_mode = Mode::Idle;
    if (m_mode == Mode::Idle) {
        if (sample.phase == PointerPhase::Hover)
            m_target.toolHovers(sample);
        if (sample.phase != PointerPhase::Press)
            return;
        m_mode = modeOfButton(sample);
        m_device = sample.device;
        m_button = sample.button;
        m_position = m_pressedAt = sample.position;
        m_mayBeClick =
            m_mode == Mode::Menu || (m_mode == Mode::Orbit && m_button != Qt::MiddleButton &&
                                     (m_button == Qt::LeftButton || sample.modifiers == Qt::NoModifier));
        if (m_mode == Mode::Tool && m_strip.contains(sample.position))
            m_mode = Mode::Strip;
        if (m_mode == Mode::Tool) {
            m_begun = sample.time;
            m_target.toolBegins(sample);
        }
        return;
    }
    if (sample.device != m_device)
        return;
    const bool ends = sample.phase == PointerPhase::Cancel || sample.phase == PointerPhase::Hover ||
                      (sample.phase == PointerPhase::Release && sample.button == m_button);
    const QPointF distance = sample.position - m_position;
    m_position = sample.position;
    if (m_mode == Mode::Tool) {
        if (sample.phase == PointerPhase::Cancel)
            m_target.toolIsFinished();
        else if (ends)
            m_target.toolEnds(sample);
        else
            m_target.toolMoves(sample);
    } else if (m_mayBeClick && isNear(m_pressedAt, sample.position)) {
        if (ends && sample.phase == PointerPhase::Release && m_button == Qt::LeftButton)
            m_target.budIsAsked(sample);
        else if (ends && sample.phase == PointerPhase::Release)
            m_target.menuIsAsked(sample);
    } else if (!distance.isNull() && sample.phase != PointerPhase::Hover) {
        // A click that becomes a drag turns the view by the whole distance.
        const QPointF whole = std::exchange(m_mayBeClick, false) ? sample.position - m_pressedAt : distance;
        if (m_mode == Mode::Orbit)
            m_target.orbitBy(whole);
        else if (m_mode == Mode::Strip)
            m_target.orbitBy({distance.x(), 0.0});
        else if (m_mode == Mode::Pan)
            m_target.panBy(distance);
        else if (m_mode == Mode::Zoom)
            m_target.magnify(std::exp(kZoomPerPixel * (distance.x() - distance.y())), m_pressedAt);
    }
    if (ends)
        m_mode = Mode::Idle;
}

void GestureReader::readFingers(std::span<const PointerSample> samples)
{
    const bool taken = std::any_of(samples.begin(), samples.end(),
                                   [](const PointerSample& s) { return s.phase == PointerPhase::Cancel; });
    const bool wasFree = m_fingers.empty();
    const bool changed = updateFingers(samples);
    if (wasFree)
        m_tap = {.begun = samples.front().time, .isPossible = true};
    if (taken)
        m_fingers.clear();
    const bool isOthers = m_mode != Mode::Idle && m_device != PointerDevice::Finger;
    // A mouse's or pen's gesture that was ended may wait for a release that never comes.
    if (isOthers && !(m_mode == Mode::Spent && changed && fingerCount() == m_fingers.size())) {
        m_tap.isPossible = false;
        return;
    }
    if (isOthers)
        m_mode = Mode::Idle;
    m_device = PointerDevice::Finger;
    if (taken) {
        // The system takes the fingers: for a gesture of its own, or because it has recognised a palm.
        finish();
        m_mode = Mode::Idle;
    } else if (changed) {
        changeFingers(samples);
    } else {
        moveFingers(samples);
    }
    watchForTap(samples);
}

/// Tells of a tap once its last finger is lifted, when nothing is under way any more.
void GestureReader::watchForTap(std::span<const PointerSample> samples)
{
    const bool isOut = std::ranges::any_of(samples, [this](const PointerSample& sample) {
        return sample.phase == PointerPhase::Cancel || sample.time - m_tap.begun > kTapTime;
    });
    const bool hasMoved = std::ranges::any_of(m_fingers, [](const Finger& finger) {
        return !finger.counts() || pixelsOf(finger.position - finger.pressedAt) > kTapReach;
    });
    // Fingers that a tool uses work.
    if (isOut || hasMoved || m_toolFingers.size() > 1)
        m_tap.isPossible = false;
    m_tap.fingers = std::max(m_tap.fingers, fingerCount());
    if (m_fingers.empty() && std::exchange(m_tap.isPossible, false) && m_tap.fingers >= 2 &&
        m_tap.fingers <= 4)
        m_target.fingersTap(static_cast<int>(m_tap.fingers));
}

/// Updates the fingers; true if one was added or lifted.
bool GestureReader::updateFingers(std::span<const PointerSample> samples)
{
    bool changed = false;
    for (const PointerSample& sample : samples) {
        const auto finger = std::find_if(m_fingers.begin(), m_fingers.end(),
                                         [&](const Finger& f) { return f.id == sample.id; });
        if (sample.phase == PointerPhase::Release || sample.phase == PointerPhase::Cancel) {
            if (finger != m_fingers.end())
                m_fingers.erase(finger);
            changed = true;
        } else if (finger != m_fingers.end()) {
            if (finger->isOnStrip && !finger->isPalm)
                m_target.orbitBy({sample.position.x() - finger->position.x(), 0.0});
            finger->position = sample.position;
        } else {
            const bool otherDevice =
                m_mode != Mode::Idle && m_mode != Mode::Spent && m_device != PointerDevice::Finger;
            m_fingers.push_back({sample.id, sample.position, sample.position,
                                 otherDevice || isPenNear(sample.time), m_strip.contains(sample.position)});
            changed = true;
        }
    }
    return changed;
}

/// Passes the fingers that the tool does not have yet to it; false if it refuses one of them.
bool GestureReader::giveToTool(std::span<const PointerSample> samples)
{
    for (const Finger& finger : m_fingers) {
        if (!finger.counts() || std::ranges::count(m_toolFingers, finger.id) > 0)
            continue;
        const PointerSample* sample = sampleOf(samples, finger.id);
        const bool isAlone = m_toolFingers.empty() && fingerCount() == 1;
        if (sample == nullptr || !(isAlone || m_target.toolTakesFinger(*sample)))
            return false;
        m_mode = Mode::Tool;
        if (m_toolFingers.empty())
            m_begun = sample->time;
        m_toolFingers.push_back(finger.id);
        m_target.toolBegins(*sample);
    }
    return m_mode == Mode::Tool;
}

/// Handles changes while the tool has fingers; false if the tool does not keep them.
bool GestureReader::changeToolFingers(std::span<const PointerSample> samples)
{
    for (const PointerSample& sample : samples) {
        if (sample.phase == PointerPhase::Release && std::ranges::count(m_toolFingers, sample.id) > 0) {
            m_target.toolEnds(sample);
            m_toolFingers.clear();
            m_mode = fingerCount() == 0 ? Mode::Idle : Mode::Spent;
            return true;
        }
    }
    return giveToTool(samples);
}

/// Gestures grow with the number of fingers. Once one finger is lifted, the others may be lifted later, and
/// must not draw or drag anything until then.
void GestureReader::changeFingers(std::span<const PointerSample> samples)
{
    if (m_mode == Mode::Tool ? changeToolFingers(samples) : m_mode == Mode::Idle && giveToTool(samples))
        return;
    leaveTool();
    m_toolFingers.clear();
    const std::size_t count = fingerCount();
    if (count == 0) {
        m_mode = Mode::Idle;
    } else if (count == 1 && m_mode == Mode::Idle) {
        return; // The press of this finger was not reported.
    } else if (count == 2 && (m_mode == Mode::Idle || m_mode == Mode::Tool)) {
        m_mode = Mode::TwoFingers;
    } else if (count == 3 && m_mode != Mode::Spent) {
        m_mode = Mode::ThreeFingers;
    } else {
        m_mode = Mode::Spent;
    }
    measureFingers();
}

void GestureReader::moveFingers(std::span<const PointerSample> samples)
{
    const QPointF centre = m_centre;
    const double spread = m_spread;
    switch (m_mode) {
    case Mode::Tool:
        for (const int finger : m_toolFingers) {
            if (const PointerSample* sample = sampleOf(samples, finger))
                m_target.toolMoves(*sample);
        }
        break;
    case Mode::TwoFingers:
        measureFingers();
        m_target.panBy(m_centre - centre);
        if (spread > kSmallestSpread && m_spread > kSmallestSpread)
            m_target.magnify(m_spread / spread, m_centre);
        break;
    case Mode::ThreeFingers:
        measureFingers();
        m_target.orbitBy(m_centre - centre);
        break;
    default:
        break;
    }
}

void GestureReader::measureFingers()
{
    const auto count = static_cast<double>(fingerCount());
    if (count == 0.0)
        return;
    m_centre = {};
    for (const Finger& finger : m_fingers) {
        if (finger.counts())
            m_centre += finger.position / count;
    }
    m_spread = 0.0;
    for (const Finger& finger : m_fingers) {
        const QPointF offset = finger.position - m_centre;
        if (finger.counts())
            m_spread += std::hypot(offset.x(), offset.y()) / count;
    }
}

std::size_t GestureReader::fingerCount() const
{
    return static_cast<std::size_t>(
        std::count_if(m_fingers.begin(), m_fingers.end(), [](const Finger& f) { return f.counts(); }));
}

/// The hand that holds the pen may have touched the screen before the pen was detected: its gesture is
/// cancelled, unless it has lasted longer than kPalmTime.
void GestureReader::penIsNear(double time)
{
    m_penSeen = time;
    for (Finger& finger : m_fingers)
        finger.isPalm = true;
    if (m_device == PointerDevice::Finger && m_mode != Mode::Idle) {
        leaveToolToPen(time);
        m_toolFingers.clear();
        m_mode = Mode::Idle;
    }
}

bool GestureReader::isPenNear(double time) const
{
    return m_penDown || m_penInReach || time - m_penSeen < kPenLinger;
}

void GestureReader::leaveTool()
{
    if (m_mode == Mode::Tool)
        m_target.toolIsCancelled();
}

/// Cancels a finger's gesture if it may be a palm's; otherwise finishes it.
void GestureReader::leaveToolToPen(double time)
{
    if (m_mode == Mode::Tool && time - m_begun > kPalmTime)
        m_target.toolIsFinished();
    else
        leaveTool();
}

} // namespace espalier
