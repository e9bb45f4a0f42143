// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/RecipeTool.h"

#include "commands/BrushGesture.h"
#include "commands/LassoGesture.h"
#include "views/tools/ToolColours.h"

#include <vector>

namespace espalier {

void RecipeTool::paint(Overlay& overlay) const
{
    const RecipePlayer* player = m_player();
    if (const LassoGesture* lasso = player ? player->lasso() : nullptr) {
        if (context().viewSettings().values().markersShown)
            overlay.addDots(lasso->markers(), kBrushColour, 2.5F, 0.5F);
        m_envelopes.show(context().document().tree().lassosInForce());
        m_envelopes.paint(overlay, kBrushColour);
    }
    const BrushGesture* stroke = player ? player->stroke() : nullptr;
    if (!stroke)
        return;
    if (context().viewSettings().values().markersShown)
        overlay.addDots(stroke->markers(), kBrushColour, 3.0F, 0.7F);
    std::vector<Vec3> trail;
    for (const BrushSample& sample : stroke->path())
        trail.push_back(sample.position);
    if (trail.size() > 1)
        overlay.addLine(trail, kBrushColour, 1.8F, 5.0F);
    const BrushSample& brush = stroke->path().back();
    if (brush.radius > 0.0F)
        overlay.addSphere({brush.position, brush.radius, kBrushColour, 0.16F});
    overlay.addDots(std::span(&brush.position, 1), kBrushColour, 6.0F);
}

} // namespace espalier
