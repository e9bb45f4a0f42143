// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/runners/PictureRunner.h"
#include "model/settings/PictureSettings.h"
#include "model/settings/ViewSettings.h"

#include <QElapsedTimer>
#include <QObject>

namespace espalier {

class FileController;
class Notice;
class Settings;
class Viewport;

/// Saves pictures of the tree, and copies them to the clipboard. The reference picture, and what tools draw
/// over the tree, are not in them.
class PictureController : public QObject {
    Q_OBJECT

public:
    struct Parts {
        FileController& files;
        Settings& settings;
        const ViewSettings& viewSettings;
        const Viewport& viewport;
        Notice& notice;
        QWidget& window;
    };

    explicit PictureController(const Parts& parts);

    /// Opens the sheet that asks what the picture is to be like.
    void ask();
    /// Copies what the window shows of the tree.
    void copyShown() { copy({}); }
    void copy(const PictureSettings& settings);
    /// Asks for a file first.
    void save(const PictureSettings& settings);
    void saveTo(const PictureSettings& settings, const QString& fileName);

    PictureRunner& runner() { return m_runner; }

Q_SIGNALS:
    /// The picture is in the file, or on the clipboard.
    void finished();

private:
    QSize windowSize() const;
    PictureRequest requestFor(const PictureSettings& settings) const;
    void start(const PictureSettings& settings, std::function<void(const QImage&)> done);

    Parts m_parts;
    PictureRunner m_runner;
    QElapsedTimer m_since; ///< The picture under way was begun
};

} // namespace espalier
