// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace espalier {

/// Loads the translations of the program and of Qt for a language ("de"), as far as there are any; an empty
/// code means the system's language. Texts that are already on the screen do not change.
void speakLanguage(const QString& code);

} // namespace espalier
