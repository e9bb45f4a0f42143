// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/ViewSettings.h"

#include <QColor>

#include <optional>

namespace espalier {

/// How a picture is drawn.
struct RenderOptions {
    ViewValues view;
    /// Behind the tree instead of the backdrop, as is; a transparent colour leaves the tree and its shadow
    /// alone.
    std::optional<QColor> background;
    int samples = 4;             ///< A pixel: 1, or smooth edges by more
    double shadowStrength = 1.0; ///< 0...1, for letting shadows appear softly
};

} // namespace espalier
