// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <Qt>

#include <vector>

namespace espalier {

/// Keys that move the camera for as long as they are held, a stroke under way or not: arrows and Q, E
/// rotate, Shift and arrows pan, plus and minus zoom.
class HeldKeys {
public:
    /// Whether the key is one of these; then it counts as held.
    bool press(int key, Qt::KeyboardModifiers modifiers);
    /// Whether the key was held.
    bool release(int key);
    void clear() { m_held.clear(); }
    bool isAnyHeld() const { return !m_held.empty(); }

    /// What the held keys ask for.
    struct Motion {
        QPointF orbit;     ///< Azimuth and elevation, rad/s
        QPointF pan;       ///< Of what is seen, px/s
        double zoom = 0.0; ///< Natural logarithm of the magnification, 1/s
    };
    Motion motion() const;

private:
    struct Held {
        int key;
        bool shift; ///< When it was pressed
    };

    std::vector<Held> m_held;
};

} // namespace espalier
