// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/Preferences.h"

#include <QDir>

namespace espalier {

QStringList Preferences::languages()
{
    QStringList codes{QStringLiteral("en")};
    for (const QString& file : QDir(QStringLiteral(":/translations")).entryList(QDir::Files, QDir::Name))
        codes << file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    return codes;
}

} // namespace espalier
