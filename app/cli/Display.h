// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

/// Why no window can be opened here; empty if one can. Call it before a QGuiApplication is made, since that
/// would abort the program.
QString displayProblem();

/// Whether no person sees the display (the environment variable ESPALIER_VIRTUAL_DISPLAY says so).
bool isDisplayVirtual();

} // namespace espalier
