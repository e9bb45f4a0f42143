// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace espalier {

/// The way of a handle that is dragged along a track: as far as the pointer goes if it is near the track,
/// less far the farther it is away, and with Shift. Lengths in px.
class FineDrag {
public:
    /// The pointer takes the handle at @p place, while it is at @p pointer along the track. The handle can be
    /// dragged from @p least to @p most.
    void begin(double place, double pointer, double least, double most);
    /// The pointer moved to @p pointer, @p away from the track (≥ 0).
    void move(double pointer, double away, bool isShiftHeld);
    /// Where the handle was dragged to.
    double place() const { return m_place; }

private:
    double m_least = 0.0;
    double m_most = 0.0;
    double m_place = 0.0;
    double m_pointer = 0.0;
};

} // namespace espalier
