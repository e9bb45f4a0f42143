// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"

#include <optional>

namespace espalier {

/// Diameters that a constraint may have, m.
inline constexpr double kLeastDiameter = 0.0002;

/// A width constraint in the hand of a person who sets, moves or removes it (TreeSketch §3.3). The tree
/// follows at each call; finish() makes the whole drag one undo step, cancel() takes it back, and so does the
/// end of an unfinished gesture.
class WidthGesture {
public:
    /// @p id: whose constraint it is, or will be. A dead internode has none, and nothing happens.
    WidthGesture(TreeDocument& document, InternodeId id);

    /// @p diameter, m, is moved into kLeastDiameter...kGreatestDiameter; 0 or less removes the constraint,
    /// and one that is no number leaves all as it stands.
    void set(double diameter) { set(m_id, diameter); }
    /// The same, with the constraint moved to internode @p place; one that is there gives way to it. A dead
    /// place is none.
    void set(InternodeId place, double diameter);

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    Edit m_edit;
    InternodeId m_id;
    /// Of the last call of set().
    InternodeId m_place;
    std::optional<float> m_diameter{};
};

/// Sets a width, or removes it (0), as one undo step: see WidthGesture::set.
void setWidth(TreeDocument& document, InternodeId id, double diameter);

} // namespace espalier
