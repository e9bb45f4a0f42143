// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/ViewSettings.h"

#include <QColor>

#include <optional>

namespace espalier {

/// How a picture is drawn.
struct RenderOptions {
    static constexpr int kBestSamples = 8;

    ViewValues view;
    /// Behind the tree instead of the backdrop, as is; a transparent colour leaves the tree and its shadow
    /// alone.
    std::optional<QColor> background;
    /// Passes that a picture is the mean of, each seen from a place within the pixel of its own: 1, or smooth
    /// edges by more.
    int samples = kBestSamples;
    double shadowStrength = 1.0; ///< 0...1, for letting shadows appear softly
    /// The tree may be shown as it was a moment ago, where a large one would take too long to follow.
    bool mayLag = false;
    bool isPlain = false; ///< Lit corner by corner, without shadows: about what it will look like
};

} // namespace espalier
