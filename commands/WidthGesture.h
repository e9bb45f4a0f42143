// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <optional>

namespace espalier {

/// The least diameter of a constraint, m; the greatest is kGreatestDiameter.
inline constexpr double kLeastDiameter = 0.0002;

/// A drag that sets, moves or removes a width constraint (TreeSketch §3.3). The tree follows at each call.
/// finish() makes the whole drag one undo step; cancel() takes it back, and so does the destructor of an
/// unfinished gesture. Another edit that begins finishes it.
class WidthGesture {
public:
    /// @p id: the internode that has or will have the constraint. If it is dead, set() does nothing.
    WidthGesture(TreeDocument& document, InternodeId id);

    /// @p diameter, m, is clamped to kLeastDiameter...kGreatestDiameter; 0 or less removes the constraint.
    /// NaN changes nothing.
    void set(double diameter) { set(m_id, diameter); }
    /// The same, with the constraint moved to internode @p place, where it replaces another one. Does nothing
    /// if @p place is dead.
    void set(InternodeId place, double diameter);

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    Edit m_edit;
    InternodeId m_id;
    /// The arguments of the last call of set().
    InternodeId m_place;
    std::optional<float> m_diameter{};
};

/// Sets a width, m, or removes it (0), as one undo step: see WidthGesture::set.
void setWidth(TreeDocument& document, InternodeId id, double diameter);

} // namespace espalier
