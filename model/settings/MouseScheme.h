// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace espalier {

/// Which mouse buttons move the camera. In all schemes the left button alone works with the tool, Space and
/// the left button pan, and a click with Alt selects a bud.
enum class MouseScheme : int {
    Espalier, ///< Right, middle, or Alt and left rotate; Shift and middle pan
    Blender,  ///< Middle rotates, Shift and middle pan, Ctrl and middle zoom; Alt and left rotate, too
    Maya,     ///< Alt and left rotate, Alt and middle pan, Alt and right zoom
};

} // namespace espalier
