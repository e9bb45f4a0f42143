// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/ViewSettings.h"

#include <algorithm>

namespace espalier {

void ViewSettings::setValues(const ViewValues& values)
{
    ViewValues wanted = values;
    wanted.brushRadius = std::clamp(wanted.brushRadius, 0.0, kMaxBrushRadius);
    wanted.sunElevation = std::clamp(wanted.sunElevation, radians(5), radians(90));
    if (wanted == m_values)
        return;
    m_values = wanted;
    Q_EMIT changed();
}

} // namespace espalier
