// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Settings.h"

#include <QString>

class QWidget;

/// The modal questions about files. Functions that return a name return an empty one if the user cancels.
namespace espalier::dialogs {

inline const QString kProjectSuffix = QStringLiteral("espalier");
inline const QString kRecipeSuffix = QStringLiteral("json");

enum class Unsaved { Save, Discard, Stay };
enum class Changed { Overwrite, SaveAs, Cancel };

/// The suffix in lower case, without a dot.
QString suffixOf(const QString& fileName);

QString askForOpening(QWidget& window, const Settings& settings);
/// @p start is the path that is proposed. The dialog asks whether an existing file is to be replaced.
QString askForSaving(QWidget& window, const QString& start);
/// The same for a recipe.
QString askForRecipe(QWidget& window, const QString& start);
/// The same for a picture.
QString askForPicture(QWidget& window, const QString& start);
/// Proposes @p start without its suffix, in the format that was used last.
QString askForExport(QWidget& window, const QString& start, const Settings& settings);
/// @p isGrowing: whether growth or a gesture is under way, which saving ends.
Unsaved askAboutUnsaved(QWidget& window, const QString& name, bool isGrowing);
/// Asks what to do when another program has written the file that is to be saved.
Changed askAboutChanged(QWidget& window, const QString& name);

} // namespace espalier::dialogs
