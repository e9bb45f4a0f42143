// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/Lengths.h"
#include "model/document/ViewSettings.h"
#include "panels/Theme.h"
#include "views/input/MouseScheme.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace espalier {

/// What a person sets once, in the sheet of settings.
struct Preferences {
    static constexpr double kSoftest = 0.25;
    static constexpr double kFirmest = 4.0;
    static constexpr int kLongestInterval = 3600;
    static constexpr int kMostUndoSteps = 10'000;

    theme::Look look = theme::Look::Dark;
    bool areToolsRight = false; ///< The bar of tools is on the right, for those who draw with the left hand
    double pressureExponent = 1.0; ///< kSoftest...kFirmest; see PointerReader::setPressureExponent
    MouseScheme mouse = MouseScheme::Espalier;
    int autosaveInterval = 20; ///< Shortest time between two autosaves, s, 1...kLongestInterval
    int undoSteps = 0;         ///< As many can be taken back, 0...kMostUndoSteps; 0 for all
    QString
        libraryFolder{}; ///< Where the library keeps its trees; empty for a folder among the program's data
    Units units = Units::Metric;
    QString language{}; ///< One of Settings::languages(); empty for the system's

    bool operator==(const Preferences&) const = default;
};

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
    /// Codes of the languages that the program speaks, as "de"; English first.
    static QStringList languages();
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
