// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/RecipeTool.h"

#include "panels/Theme.h"

#include <vector>

namespace espalier {

void RecipeTool::paint(Overlay& overlay) const
{
    const RecipePlayer* player = m_runner.player();
    if (const LassoGesture* lasso = player ? player->lasso() : nullptr) {
        if (context().viewSettings().values().markersShown)
            overlay.addDots(lasso->markers(), theme::kHandle, 2.5F, 0.5F);
        m_envelopes.show(context().document().tree().lassosInForce());
        m_envelopes.paint(overlay, theme::kHandle);
    }
    const BrushGesture* stroke = player ? player->stroke() : nullptr;
    if (!stroke)
        return;
    if (context().viewSettings().values().markersShown)
        overlay.addDots(stroke->markers(), theme::kHandle, 3.0F, 0.7F);
    std::vector<Vec3> trail;
    for (const BrushSample& sample : stroke->path())
        trail.push_back(sample.position);
    if (trail.size() > 1)
        overlay.addLine(trail, theme::kHandle, 1.8F, 5.0F);
    const BrushSample& brush = stroke->path().back();
    if (brush.radius > 0.0F)
        overlay.addSphere({brush.position, brush.radius, theme::kHandle, 0.16F});
    overlay.addDots(std::span(&brush.position, 1), theme::kHandle, 6.0F);
}

} // namespace espalier
