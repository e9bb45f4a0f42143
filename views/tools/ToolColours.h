// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

namespace espalier {

/// Colours that several tools paint with over the tree; they are legible on a dark and on a light backdrop.
inline const QColor kBrushColour(232, 168, 100);  ///< The brush, and strokes under way
inline const QColor kTrunkInk(240, 138, 48);      ///< A new trunk, as in Okabe 2005, figure 12
inline const QColor kSilhouetteInk(84, 146, 240); ///< A new crown's outline, likewise
inline const QColor kPickedColour(240, 168, 184); ///< The branch or the bud under the pointer

} // namespace espalier
