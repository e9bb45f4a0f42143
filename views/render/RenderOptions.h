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
    /// Colour behind the tree, used unchanged instead of the backdrop; with a transparent colour only the
    /// tree and its shadow are drawn.
    std::optional<QColor> background;
    /// Number of passes that a picture is the mean of, each from another place within the pixel: with more
    /// than 1, edges are smooth.
    int samples = kBestSamples;
    /// Large trees that take too long to update may be shown in a slightly older state.
    bool mayLag = false;
    /// Shadows may be those of an earlier state, or of an earlier sun.
    bool keepsShadows = false;
    /// The scene is drawn as it was for another camera just before, with that one's detail.
    bool isSecond = false;
    float boldness = 0.0F; ///< Wood is drawn thicker by so many pixels on each side
    bool isPlain = false;  ///< Light is computed per vertex: a fast approximation
};

} // namespace espalier
