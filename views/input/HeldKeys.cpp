// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/HeldKeys.h"

#include "model/base/Vector.h"

#include <algorithm>
#include <array>

namespace espalier {

namespace {

constexpr double kOrbitSpeed = radians(75); ///< rad/s
constexpr double kPanSpeed = 420.0;         ///< px/s
constexpr double kZoomSpeed = 1.2;          ///< 1/s

constexpr std::array kKeys{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up,    Qt::Key_Down,  Qt::Key_Q,
                           Qt::Key_E,    Qt::Key_Plus,  Qt::Key_Minus, Qt::Key_Equal, Qt::Key_Underscore};

} // namespace

bool HeldKeys::press(int key, Qt::KeyboardModifiers modifiers)
{
    if (std::find(kKeys.begin(), kKeys.end(), key) == kKeys.end())
        return false;
    if (modifiers & (Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier))
        return false;
    release(key);
    m_held.push_back({key, modifiers.testFlag(Qt::ShiftModifier)});
    return true;
}

bool HeldKeys::release(int key)
{
    return std::erase_if(m_held, [key](const Held& held) { return held.key == key; }) > 0;
}

HeldKeys::Motion HeldKeys::motion() const
{
    Motion motion;
    for (const Held& held : m_held) {
        QPointF arrow;
        switch (held.key) {
        case Qt::Key_Left:
            arrow = {-1.0, 0.0};
            break;
        case Qt::Key_Right:
            arrow = {1.0, 0.0};
            break;
        case Qt::Key_Up:
            arrow = {0.0, 1.0};
            break;
        case Qt::Key_Down:
            arrow = {0.0, -1.0};
            break;
        case Qt::Key_Q:
            motion.orbit.rx() -= kOrbitSpeed;
            break;
        case Qt::Key_E:
            motion.orbit.rx() += kOrbitSpeed;
            break;
        case Qt::Key_Plus:
        case Qt::Key_Equal: // The key of plus, without Shift, on many keyboards
            motion.zoom += kZoomSpeed;
            break;
        default:
            motion.zoom -= kZoomSpeed;
            break;
        }
        if (held.shift)
            motion.pan += kPanSpeed * QPointF(-arrow.x(), arrow.y());
        else
            motion.orbit += kOrbitSpeed * arrow;
    }
    return motion;
}

} // namespace espalier
