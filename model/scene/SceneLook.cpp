// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/scene/SceneLook.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace espalier {

void keepWithinLimits(SceneLook& look)
{
    look.sunElevation = std::clamp(look.sunElevation, kLeastSunElevation, radians(90));
    look.sunAzimuth = std::remainder(look.sunAzimuth, 2.0 * std::numbers::pi);
    for (QColor* colour : {&look.backgroundColour, &look.backgroundTop})
        *colour = QColor(colour->rgb());
    TracingImage& tracing = look.tracing;
    for (double* offset : {&tracing.right, &tracing.up})
        *offset = std::clamp(*offset, -TracingImage::kMaxOffset, TracingImage::kMaxOffset);
    tracing.height = std::clamp(tracing.height, TracingImage::kMinHeight, TracingImage::kMaxHeight);
    tracing.opacity = std::clamp(tracing.opacity, 0.0, 1.0);
}

SceneLook withoutPicture(SceneLook look)
{
    look.tracing = {};
    return look;
}

} // namespace espalier
