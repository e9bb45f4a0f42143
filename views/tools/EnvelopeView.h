// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/LassoStroke.h"
#include "views/render/Overlay.h"

#include <memory>
#include <span>

namespace espalier {

/// The picture of the envelopes of lasso strokes: a translucent surface and outlines.
class EnvelopeView {
public:
    /// Sets the strokes; does nothing if they are the same as before. Strokes that enclose nothing are not
    /// shown.
    void show(std::span<const LassoStroke> strokes, int resolution = 128);
    void clear() { show({}); }
    void paint(Overlay& overlay, const QColor& colour) const;

private:
    std::vector<LassoStroke> m_strokes;
    std::shared_ptr<const EnvelopeMesh> m_mesh; ///< Of all envelopes together; may be null
    std::vector<std::vector<Vec3>> m_outlines;  ///< Closed: the last point is the first
};

} // namespace espalier
