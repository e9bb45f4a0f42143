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
    double shadowStrength = 1.0; ///< 0...1, so that shadows can fade in
    /// Large trees that take too long to update may be shown in a slightly older state.
    bool mayLag = false;
    bool isPlain = false; ///< Light is computed per vertex, without shadows: a fast approximation
};

} // namespace espalier
