// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace espalier {

/// How an image becomes a square tile that repeats: edges that do not match are faded into each other, and an
/// oblong image is repeated within the tile. One object serves all images of a material, so that they fit.
class RepeatingTile {
public:
    /// For materials whose colours are @p image (Format_RGB888); of @p size pixels or fewer.
    RepeatingTile(const QImage& image, int size);

    /// The tile of an image of that material; Format_RGB888.
    QImage of(QImage image) const;

private:
    bool m_fadesRows;
    bool m_fadesColumns;
    QSize m_repeats; ///< Across and along
    int m_edge;      ///< px, of the tile
};

} // namespace espalier
