// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <Qt>

#include <vector>

namespace espalier {

/// Keys that move the camera while they are held, also during a stroke: arrows and Q, E rotate, Shift and
/// arrows pan, plus and minus zoom.
class HeldKeys {
public:
    /// Records that a key is held. Returns whether it is one of these keys.
    bool press(int key, Qt::KeyboardModifiers modifiers);
    /// Records that a key is released. Returns whether it was held.
    bool release(int key);
    void clear() { m_held.clear(); }
    bool isAnyHeld() const { return !m_held.empty(); }

    /// The camera's motion for the held keys.
    struct Motion {
        QPointF orbit;     ///< Azimuth and elevation, rad/s
        QPointF pan;       ///< Motion of the picture, px/s
        double zoom = 0.0; ///< Natural logarithm of the magnification, 1/s
    };
    Motion motion() const;

private:
    struct Held {
        int key;
        bool shift; ///< Whether Shift was held at the press
    };

    std::vector<Held> m_held;
};

} // namespace espalier
