// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/ViewSettings.h"

#include <algorithm>
#include <cmath>

namespace espalier {

double steppedBrushRadius(double radius, double notches)
{
    constexpr double kSmallest = 0.02;
    constexpr double kRatio = 1.1;
    if (radius < kSmallest && notches <= 0.0)
        return 0.0;
    const double stepped = std::max(radius, kSmallest / kRatio) * std::pow(kRatio, notches);
    return stepped < 0.999 * kSmallest ? 0.0 : std::min(stepped, kMaxBrushRadius);
}

Backdrop shownBackdrop(const ViewValues& values)
{
    if (values.backdrop != Backdrop::Studio)
        return values.backdrop;
    return values.isThemeLight ? Backdrop::LightStudio : Backdrop::DarkStudio;
}

bool isBackdropLight(const ViewValues& values)
{
    switch (shownBackdrop(values)) {
    case Backdrop::Plain:
    case Backdrop::Gradient: {
        const QColor& colour = values.backgroundColour;
        constexpr int kMiddle = 136;
        return (299 * colour.red() + 587 * colour.green() + 114 * colour.blue()) / 1000 > kMiddle;
    }
    case Backdrop::Horizon:
    case Backdrop::LightStudio:
        return true;
    default:
        return false;
    }
}

void ViewSettings::setValues(const ViewValues& values)
{
    ViewValues wanted = values;
    wanted.brushRadius = std::clamp(wanted.brushRadius, 0.0, kMaxBrushRadius);
    for (double* weight : {&wanted.bendingWeight, &wanted.stretchingWeight})
        *weight = std::clamp(*weight, kLeastBendWeight, kMostBendWeight);
    wanted.brushSymmetry = std::round(std::clamp(wanted.brushSymmetry, 1.0, kMostSymmetry));
    wanted.eraserThickest = std::clamp(wanted.eraserThickest, kLeastThickest, 1.0);
    wanted.thinShare = std::clamp(wanted.thinShare, kLeastThinShare, 1.0);
    wanted.newBuds = std::round(std::clamp(wanted.newBuds, kLeastNewBuds, kMostNewBuds));
    for (double* factor : {&wanted.depthHull, &wanted.depthLength, &wanted.depthAngle})
        *factor = std::clamp(*factor, kLeastDepthFactor, kMostDepthFactor);
    wanted.variation = std::clamp(wanted.variation, kLeastVariation, 1.0);
    wanted.variationNumber = std::round(std::clamp(wanted.variationNumber, 1.0, kMostVariations));
    wanted.budSpacing = std::clamp(wanted.budSpacing, 0.0, kMostBudSpacing);
    keepWithinLimits(wanted);
    if (wanted == m_values)
        return;
    m_values = wanted;
    Q_EMIT changed();
}

void ViewSettings::setLook(const SceneLook& look)
{
    if (static_cast<const SceneLook&>(m_values) == look)
        return;
    static_cast<SceneLook&>(m_values) = look;
    keepWithinLimits(m_values);
    Q_EMIT lookReplaced();
    Q_EMIT changed();
}

} // namespace espalier
