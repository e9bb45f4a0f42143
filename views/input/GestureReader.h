// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/MouseScheme.h"
#include "views/input/PointerSample.h"

#include <QRectF>

#include <span>
#include <vector>

namespace espalier {

/// Performs gestures: the work of a tool, or a move of the camera.
class GestureTarget {
public:
    virtual ~GestureTarget() = default;

    virtual void toolBegins(const PointerSample& sample) = 0;
    virtual void toolMoves(const PointerSample& sample) = 0;
    virtual void toolEnds(const PointerSample& sample) = 0;
    /// The pointer was lost before it was lifted: what the tool has done so far stays.
    virtual void toolIsFinished() = 0;
    virtual void toolIsCancelled() = 0;
    virtual void toolHovers(const PointerSample& sample) = 0;
    /// Whether the tool uses one more finger: see Tool::takesFinger.
    virtual bool toolTakesFinger(const PointerSample& sample) = 0;
    /// A click with Alt held, without a move of the view: it selects a bud.
    virtual void budIsAsked(const PointerSample& sample) = 0;

    /// A click with the right button, or with the side button of a pen: it asks for a menu.
    virtual void menuIsAsked(const PointerSample& sample) = 0;

    /// @p fingers, 2...4, have tapped the screen together.
    virtual void fingersTap(int fingers) = 0;

    /// Distances in px.
    virtual void orbitBy(const QPointF& distance) = 0;
    virtual void panBy(const QPointF& distance) = 0;
    /// A @p factor above 1 magnifies the picture under @p about.
    virtual void magnify(double factor, const QPointF& about) = 0;
};

/// Recognises gestures before samples go to tools (TreeSketch §3.1): one finger, a pen's tip or the left
/// mouse button works with the tool; two fingers pan and pinch, three rotate. Other mouse buttons move the
/// camera as MouseScheme says, and the left one pans while the space bar is held. A
/// click of the right button asks for a menu. When a second finger joins
/// the first, the tool's gesture is cancelled, unless the tool uses the second finger too. So a second finger
/// corresponds to Escape on a keyboard. Several fingers that come and go at their places within kTapTime tap.
/// While a pen is near or down, touches are treated as a palm and ignored.
class GestureReader {
public:
    /// A palm can touch the screen at most this long before the pen is detected, s.
    static constexpr double kPalmTime = 1.0;
    /// From the first finger's press to the last one's release, a tap lasts at most this long, s.
    static constexpr double kTapTime = 0.4;
    /// A tap's fingers move at most this far, px.
    static constexpr double kTapReach = 12.0;

    explicit GestureReader(GestureTarget& target) : m_target(target) {}

    /// Reads all samples of one event.
    void read(std::span<const PointerSample> samples);

    /// Whether dragging pans (the space bar is held).
    void setPanKey(bool held) { m_panKey = held; }
    void setScheme(MouseScheme scheme) { m_scheme = scheme; }
    /// Sets the rotation strip, px: a gesture that begins there turns the view about the vertical, while
    /// another finger works with the tool.
    void setStrip(const QRectF& strip) { m_strip = strip; }
    /// A pen has come into or left the tablet's reach; the reader also recognises a pen that moves or
    /// touches. When a pen leaves, its gesture ends and its result stays.
    void setPenInReach(bool inReach, double time);
    /// Cancels the gesture under way; pointers that are still held are ignored until they are lifted.
    void cancel();
    /// Finishes the tool's gesture under way; pointers that are still held are ignored until they are lifted.
    /// Gestures that move the camera continue.
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
        Menu,  ///< The right button is down and does not move the camera
        Spent, ///< Waits until everything is lifted
    };
    struct Finger {
        int id = 0;
        QPointF position;
        QPointF pressedAt;
        bool isPalm = false;
        bool isOnStrip = false; ///< It touched the screen on the strip first

        /// Whether it is one of the fingers of a gesture.
        bool counts() const { return !isPalm && !isOnStrip; }
    };

    void readPointer(const PointerSample& sample);
    void readFingers(std::span<const PointerSample> samples);
    void watchForTap(std::span<const PointerSample> samples);
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
    PointerDevice m_device = PointerDevice::Mouse; ///< Device of the gesture
    Qt::MouseButton m_button = Qt::NoButton;       ///< Button that began the gesture
    QPointF m_position;
    QPointF m_pressedAt;
    double m_begun = 0.0; ///< When the tool's gesture began, s
    /// The right button is held, or the left one with Alt, and the pointer has not moved.
    bool m_mayBeClick = false;
    QRectF m_strip;
    bool m_panKey = false;
    MouseScheme m_scheme = MouseScheme::Espalier;

    /// From the first finger's press on, until all fingers are lifted.
    struct Tap {
        double begun = 0.0;      ///< s
        std::size_t fingers = 0; ///< The greatest number so far
        bool isPossible = false;
    };
    Tap m_tap;
    std::vector<Finger> m_fingers;
    std::vector<int> m_toolFingers; ///< Ids of the fingers that the tool uses
    QPointF m_centre;
    double m_spread = 0.0; ///< Mean distance from the centre, px

    bool m_penInReach = false;
    bool m_penDown = false;
    double m_penSeen = -1e9; ///< Time of the pen's last sample, s
};

} // namespace espalier
