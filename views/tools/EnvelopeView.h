// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/LassoStroke.h"
#include "views/render/Overlay.h"

#include <memory>
#include <span>

namespace espalier {

/// How the envelopes of lasso strokes are shown: a translucent skin and their outlines.
class EnvelopeView {
public:
    /// Nothing to do if they are the same strokes as before. Of strokes that enclose nothing, nothing is
    /// shown.
    void show(std::span<const LassoStroke> strokes, int resolution = 128);
    void clear() { show({}); }
    void paint(Overlay& overlay, const QColor& colour) const;

private:
    std::vector<LassoStroke> m_strokes;
    std::shared_ptr<const EnvelopeMesh> m_mesh; ///< Of all of them; may be null
    std::vector<std::vector<Vec3>> m_outlines;  ///< Closed: the last point is the first
};

} // namespace espalier
