// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/Preferences.h"
#include "model/settings/ViewSettings.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace espalier {

/// What the program remembers of a person from one day to the next. Each has its default here and nowhere
/// else.
class Settings {
public:
    static constexpr int kMaxRecentFiles = 10;

    ViewValues viewValues() const;
    void setViewValues(const ViewValues& values);

    /// Projects, the latest first; only those that are still there.
    QStringList recentFiles() const;
    void addRecentFile(const QString& fileName);
    void clearRecentFiles();

    /// Where files were opened or saved last; at first the person's documents.
    QString folder() const;
    void setFolder(const QString& folder);
    /// Values out of range are moved to its nearest end, unknown ones are the defaults.
    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);
    /// The one that is set, or the program's own.
    QString libraryFolder() const;
    /// Suffix of the last export; at first "glb".
    QString exportSuffix() const;
    void setExportSuffix(const QString& suffix);

    /// Of the window; empty at first.
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);

    /// Whether the person has been shown around.
    bool isTourSeen() const;
    void setTourSeen(bool seen);
};

} // namespace espalier
