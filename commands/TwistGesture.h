// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Edit.h"
#include "model/shape/Twist.h"

namespace espalier {

/// A drag that twists the strands of a branch (Strands 2024 §5.4). The tree follows at each call of set().
/// finish() makes the whole drag one undo step; cancel() takes it back, and so does the destructor of an
/// unfinished gesture. Another edit that begins finishes it.
class TwistGesture {
public:
    /// @p id: the lowest internode that is twisted. If it is dead, set() does nothing.
    TwistGesture(TreeDocument& document, InternodeId id, TwistScope scope);

    /// Gives each internode that the gesture reaches the twist @p angle, degrees from node to node: rounded
    /// to a hundredth, clamped to ±kMostTwist; 0 takes the twist away. Each call replaces the one before. NaN
    /// changes nothing.
    void set(double angle);
    /// Of the last call of set(), degrees.
    double angle() const { return m_angle; }

    void finish();
    void cancel() { m_edit.cancel(); }

private:
    Edit m_edit;
    InternodeId m_id;
    TwistScope m_scope;
    double m_angle = 0.0;
};

/// Twists a branch as one undo step: see TwistGesture::set. Does nothing if nothing changes.
void twistBranch(TreeDocument& document, InternodeId id, TwistScope scope, double angle);

} // namespace espalier
