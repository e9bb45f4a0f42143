// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/settings/ViewSettings.h"

#include <QObject>

namespace espalier {

class BackgroundPanel;
class DocumentFile;
class Notice;
class Settings;

/// Does what the background panel asks for: reads the picture to draw after in the background, and keeps the
/// look of the scene for new trees.
class SceneController : public QObject {
    Q_OBJECT

public:
    struct Parts {
        const TreeDocument& document;
        DocumentFile& file;
        ViewSettings& viewSettings;
        Settings& settings;
        BackgroundPanel& panel;
        Notice& notice;
        QWidget& window;
    };

    explicit SceneController(const Parts& parts);

    /// Asks for a file.
    void choosePicture();
    /// Reads a file and shows it behind the tree instead of the previous picture; a notice tells if that
    /// fails. If another document is shown meanwhile, the picture is dropped.
    void takePicture(const QString& fileName);
    /// New documents have the look of this one from now on, without its picture.
    void keepForNewTrees();

Q_SIGNALS:
    /// The picture is shown, or the attempt has failed.
    void pictureTaken();

private:
    Parts m_parts;
    int m_asked = 0; ///< Pictures asked for, and documents shown, so far
};

} // namespace espalier
