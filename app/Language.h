// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

/// Puts the program's own texts and Qt's in a language, "de", as far as there are any; an empty code is the
/// system's. What has been shown before keeps its texts.
void speakLanguage(const QString& code);

} // namespace espalier
