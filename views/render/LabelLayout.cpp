// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/render/LabelLayout.h"

#include <algorithm>

namespace espalier {

namespace {

constexpr double kLabelPadding = 6.0; ///< px
constexpr double kLabelGap = 2.0;

} // namespace

std::vector<QRectF> labelBoxes(const Overlay& overlay, const Camera& camera, const QFontMetricsF& metrics)
{
    std::vector<QRectF> boxes;
    for (const Overlay::Label& label : overlay.labels()) {
        const auto place = camera.project(label.place);
        if (!place) {
            boxes.emplace_back();
            continue;
        }
        const double height = metrics.height() + 4.0;
        QRectF box(place->x() + label.offset.x(), place->y() + label.offset.y() - height / 2.0,
                   metrics.horizontalAdvance(label.text) + 2.0 * kLabelPadding, height);
        const auto covers = [&](const QRectF& other) { return other.intersects(box); };
        // Each move goes down, so it ends.
        for (auto other = std::ranges::find_if(boxes, covers); other != boxes.end();
             other = std::ranges::find_if(boxes, covers))
            box.moveTop(other->bottom() + kLabelGap);
        boxes.push_back(box);
    }
    return boxes;
}

} // namespace espalier
