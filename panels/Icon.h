// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace espalier {

/// The stroked icon ":/icons/<name>.svg" in the theme's colours. The colour depends on whether the control is
/// on, under the pointer or disabled; the icon is sharp at any size.
QIcon icon(const QString& name);

} // namespace espalier
