// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

/// Why no window can be opened here; empty if one can. To be asked before there is a QGuiApplication, which
/// would abort the program.
QString displayProblem();

/// Whether the display is one that nobody looks at (the environment variable ESPALIER_VIRTUAL_DISPLAY says
/// so).
bool isDisplayVirtual();

} // namespace espalier
