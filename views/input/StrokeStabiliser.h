// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/Preferences.h"
#include "views/input/PointerSample.h"

#include <optional>

namespace espalier {

/// Calms the strokes of a trembling hand: the stroke follows the pointer at a distance, like a stone on a
/// string, and comes there with a delay. It changes nothing while both are 0.
class StrokeStabiliser {
public:
    void set(const Stabilising& stabilising) { m_stabilising = stabilising; }

    /// A stroke begins with @p sample.
    void begin(const PointerSample& sample);
    /// The sample of the stroke for the pointer's @p sample, which is not earlier than the one before.
    PointerSample move(const PointerSample& sample);
    /// The pointer rests up to @p time, s, of the samples' clock. Returns a sample while the stroke still
    /// comes nearer.
    std::optional<PointerSample> rest(double time);

private:
    PointerSample approach();

    Stabilising m_stabilising;
    PointerSample m_last;   ///< The pointer's last sample
    QPointF m_pulled;       ///< Where the pointer has pulled the stroke to, as by a string, px
    QPointF m_at;           ///< Where the stroke is, px
    double m_reached = 0.0; ///< Time of the last sample of the stroke, s
};

} // namespace espalier
