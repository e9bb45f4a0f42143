// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/PictureSettings.h"
#include "model/settings/Preferences.h"
#include "model/settings/ViewSettings.h"
#include "model/tree/TreeSize.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace espalier {

/// The program's persistent settings. Each has its default here and nowhere else.
class Settings {
public:
    static constexpr int kMaxRecentFiles = 10;

    /// Without the look of the scene, which is the document's.
    ViewValues viewValues() const;
    void setViewValues(const ViewValues& values);
    /// The look that a new document has; without a picture to draw after.
    SceneLook lookOfNewTrees() const;
    void setLookOfNewTrees(const SceneLook& look);

    /// Recently opened projects, the latest first; only those that still exist.
    QStringList recentFiles() const;
    void addRecentFile(const QString& fileName);
    void clearRecentFiles();

    /// The folder where files were opened or saved last; at first the user's documents.
    QString folder() const;
    void setFolder(const QString& folder);
    /// Values out of range are moved to its nearest end, unknown ones are the defaults.
    Preferences preferences() const;
    void setPreferences(const Preferences& preferences);
    /// The library's folder that is set, or the default one.
    QString libraryFolder() const;
    /// Those of the last picture that was saved or copied.
    PictureSettings pictureSettings() const;
    void setPictureSettings(const PictureSettings& settings);
    /// Suffix of the last export; at first "glb".
    QString exportSuffix() const;
    void setExportSuffix(const QString& suffix);

    /// Of new trees.
    TreeSize treeSize() const;
    void setTreeSize(TreeSize size);

    /// Geometry of the window; empty at first.
    QByteArray windowGeometry() const;
    void setWindowGeometry(const QByteArray& geometry);

    /// Whether the tour was shown.
    bool isTourSeen() const;
    void setTourSeen(bool seen);

    /// The size of the interface from the next start on, in percent of the system's: one of
    /// SettingsSheet::scales().
    int interfaceScale() const;
    /// Gives the interface that size, unless the environment gives it one. To be called before the
    /// application is made.
    void scaleInterface() const;
    void setInterfaceScale(int percent);
};

} // namespace espalier
