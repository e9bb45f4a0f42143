// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/settings/Preferences.h"

#include <QDir>

namespace espalier {

QStringList Preferences::languages()
{
    QStringList codes{QStringLiteral("en")};
    // The folder also contains Qt's own translations.
    const QDir folder(QStringLiteral(":/translations"));
    for (const QString& file : folder.entryList({QStringLiteral("espalier_*")}, QDir::Files, QDir::Name))
        codes << file.section(QLatin1Char('_'), 1).section(QLatin1Char('.'), 0, 0);
    return codes;
}

} // namespace espalier
