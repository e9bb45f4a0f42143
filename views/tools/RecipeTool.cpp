// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/RecipeTool.h"

#include "views/tools/ToolColours.h"

#include <vector>

namespace espalier {

void RecipeTool::paint(Overlay& overlay) const
{
    const RecipeMoment* const moment = m_moment();
    if (!moment)
        return;
    const bool hasMarkers = context().viewSettings().values().markersShown;
    if (moment->isFilling) {
        if (hasMarkers)
            overlay.addDots(moment->markers, kBrushColour, 2.5F, 0.5F);
        m_envelopes.show(context().document().tree().lassosInForce());
        m_envelopes.paint(overlay, kBrushColour);
    }
    if (moment->stroke.empty())
        return;
    if (hasMarkers)
        overlay.addDots(moment->markers, kBrushColour, 3.0F, 0.7F);
    std::vector<Vec3> trail;
    for (const BrushSample& sample : moment->stroke)
        trail.push_back(sample.position);
    if (trail.size() > 1)
        overlay.addLine(trail, kBrushColour, 1.8F, 5.0F);
    const BrushSample& brush = moment->stroke.back();
    if (brush.radius > 0.0F)
        overlay.addSphere({brush.position, brush.radius, kBrushColour, 0.16F});
    overlay.addDots(std::span(&brush.position, 1), kBrushColour, 6.0F);
}

} // namespace espalier
