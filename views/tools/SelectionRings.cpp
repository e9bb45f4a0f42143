// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/SelectionRings.h"

#include <cmath>

namespace espalier {

namespace {

constexpr int kRings = 3;
constexpr double kLeast = 12.0;    ///< px
constexpr double kGreatest = 52.0; ///< px

const QColor kRingColour(235, 84, 72);

} // namespace

void paintSelectionRings(Overlay& overlay, const Camera& camera, const Vec3& position, double age)
{
    const float metres = 1.0F / camera.pixelsPerMetre(std::max(camera.depth(position), Camera::kMinDistance));
    const auto ring = [&](double pixels, double opacity) {
        QColor colour = kRingColour;
        colour.setAlphaF(static_cast<float>(opacity));
        overlay.addCircle(position, camera.right(), camera.up(), static_cast<float>(pixels) * metres, colour,
                          2.5F);
    };
    ring(kLeast, 0.95);
    for (int i = 0; i < kRings && age < kRingsExpand; ++i) {
        const double grown = age / kRingsExpand * 1.6 - 0.3 * i;
        if (grown > 0.0 && grown < 1.0)
            ring(kLeast + (kGreatest - kLeast) * grown, 1.0 - grown);
    }
}

} // namespace espalier
