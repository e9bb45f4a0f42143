// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace espalier {

/// The stroked icon ":/icons/<name>.svg" in the theme's colours: they follow from whether it is on, under the
/// pointer or disabled, and it is as sharp at any size as the screen allows.
QIcon icon(const QString& name);

} // namespace espalier
