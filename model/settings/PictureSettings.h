// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>

namespace espalier {

/// How a picture of the tree is to be made for a file or for the clipboard.
struct PictureSettings {
    static constexpr int kLeastEdge = 16;   ///< px
    static constexpr int kMostEdge = 16384; ///< px

    /// From where the tree is seen: as the window shows it, or all of it from a side.
    enum class View : int { Shown, Front, Side, Top, ThreeQuarter };
    static constexpr int kViewCount = 5;

    QSize size{};             ///< px, kLeastEdge...kMostEdge along each edge; empty for the window's
    View view = View::Shown;  ///< From where
    bool transparent = false; ///< Nothing is behind the tree
    bool shadow = true;       ///< A transparent picture has the tree's shadow, as black of some opacity

    bool operator==(const PictureSettings&) const = default;
};

} // namespace espalier
