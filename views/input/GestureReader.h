// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/MouseScheme.h"
#include "views/input/PointerSample.h"

#include <QRectF>

#include <span>
#include <vector>

namespace espalier {

/// What a gesture asks for: the work of a tool, or another view of the tree.
class GestureTarget {
public:
    virtual ~GestureTarget() = default;

    virtual void toolBegins(const PointerSample& sample) = 0;
    virtual void toolMoves(const PointerSample& sample) = 0;
    virtual void toolEnds(const PointerSample& sample) = 0;
    /// The pointer was taken away before it was lifted: what the tool has done so far stays.
    virtual void toolIsFinished() = 0;
    virtual void toolIsCancelled() = 0;
    virtual void toolHovers(const PointerSample& sample) = 0;
    /// Whether the tool works with one more finger: see Tool::takesFinger.
    virtual bool toolTakesFinger(const PointerSample& sample) = 0;
    /// A click with Alt held, which did not turn the view: it selects a bud.
    virtual void budIsAsked(const PointerSample& sample) = 0;

    /// Distances in px.
    virtual void orbitBy(const QPointF& distance) = 0;
    virtual void panBy(const QPointF& distance) = 0;
    /// @p factor > 1 makes larger what is under @p about.
    virtual void magnify(double factor, const QPointF& about) = 0;
};

/// Reads gestures before tools are asked (TreeSketch §3.1): one finger, a pen's tip or the left mouse
/// button is the tool; two fingers pan and pinch, three rotate. Other buttons of the mouse move the camera as
/// MouseScheme says, and the left one pans while the space bar is held. A finger
/// that is joined by a second one has not been meant for the tool: its gesture is cancelled, unless the tool
/// takes the second, too. A second finger is what Escape is on a keyboard. While a pen is near or down, touch
/// is a palm and counts for nothing.
class GestureReader {
public:
    /// A palm comes down at most this long before the pen that it holds is seen, s.
    static constexpr double kPalmTime = 1.0;

    explicit GestureReader(GestureTarget& target) : m_target(target) {}

    /// Reads samples that belong together: all that one event says.
    void read(std::span<const PointerSample> samples);

    /// Whether dragging pans (the space bar is held).
    void setPanKey(bool held) { m_panKey = held; }
    void setScheme(MouseScheme scheme) { m_scheme = scheme; }
    /// The rotation strip, px: whatever begins there turns the view about the vertical, while another finger
    /// works with the tool.
    void setStrip(const QRectF& strip) { m_strip = strip; }
    /// A pen came into or left the tablet's reach; while it moves or touches, the reader knows by itself. A
    /// gesture of a pen that leaves ends as it stands.
    void setPenInReach(bool inReach, double time);
    /// Gives up the gesture under way; what is still held counts for nothing until it is lifted.
    void cancel();
    /// Ends the tool's gesture under way as it stands; what is still held counts for nothing until it is
    /// lifted. Gestures that move the camera go on.
    void finish();

    bool isBusy() const { return m_mode != Mode::Idle; }

private:
    enum class Mode {
        Idle,
        Tool,
        Orbit,
        Pan,
        Zoom,
        TwoFingers,
        ThreeFingers,
        Strip,
        Spent, ///< Waits until everything is lifted
    };
    struct Finger {
        int id = 0;
        QPointF position;
        bool isPalm = false;
        bool isOnStrip = false; ///< It came down there

        /// Whether it is one of the fingers of a gesture.
        bool counts() const { return !isPalm && !isOnStrip; }
    };

    void readPointer(const PointerSample& sample);
    void readFingers(std::span<const PointerSample> samples);
    Mode modeOfButton(const PointerSample& sample) const;
    bool updateFingers(std::span<const PointerSample> samples);
    void changeFingers(std::span<const PointerSample> samples);
    bool changeToolFingers(std::span<const PointerSample> samples);
    bool giveToTool(std::span<const PointerSample> samples);
    void moveFingers(std::span<const PointerSample> samples);
    void penIsNear(double time);
    bool isPenNear(double time) const;
    std::size_t fingerCount() const;
    void measureFingers();
    void leaveTool();
    void leaveToolToPen(double time);

    GestureTarget& m_target;
    Mode m_mode = Mode::Idle;
    PointerDevice m_device = PointerDevice::Mouse; ///< That drives the mode
    Qt::MouseButton m_button = Qt::NoButton;       ///< That began it
    QPointF m_position;
    QPointF m_pressedAt;
    double m_begun = 0.0;      ///< When the tool's gesture began, s
    bool m_mayBeClick = false; ///< Alt and the left button are held, and the pointer has not moved
    QRectF m_strip;
    bool m_panKey = false;
    MouseScheme m_scheme = MouseScheme::Espalier;

    std::vector<Finger> m_fingers;
    std::vector<int> m_toolFingers; ///< Ids
    QPointF m_centre;
    double m_spread = 0.0; ///< Mean distance from the centre, px

    bool m_penInReach = false;
    bool m_penDown = false;
    double m_penSeen = -1e9; ///< s
};

} // namespace espalier
