// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/Performance.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr qsizetype kFaultsNamed = 3;

} // namespace

QString joinedFaults(const QStringList& faults)
{
    const QString named = faults.mid(0, kFaultsNamed).join(QLatin1String("; "));
    return faults.size() <= kFaultsNamed
               ? named
               : RecipeText::tr("%1; and %2 more").arg(named).arg(faults.size() - kFaultsNamed);
}

} // namespace espalier
