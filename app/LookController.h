// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/document/TreeDocument.h"
#include "panels/LookChoice.h"

#include <QObject>

#include <functional>

namespace espalier {

class Notice;
class Settings;

/// Gives leaves and bark the user's own images: asks for a file, reads it in the background, and puts it in
/// force as one undo step.
class LookController : public QObject {
    Q_OBJECT

public:
    /// @p isBusy tells whether something else is changing the document now; then an image waits.
    LookController(TreeDocument& document, Settings& settings, Notice& notice, std::function<bool()> isBusy,
                   QWidget& window);

    /// Asks for a file.
    void choose(LookKind kind);
    /// Reads a file and the files that belong to it, and puts the image in force; shows a notice if that
    /// fails.
    void take(LookKind kind, const QString& fileName);
    /// The same for a file that was dropped on the window: asks whether it is for leaves or for bark, or a
    /// picture to draw after.
    void askAndTake(const QString& fileName);

Q_SIGNALS:
    /// An image was put in force, or the attempt has failed.
    void taken();
    /// The user has dropped a picture to draw after.
    void pictureDropped(const QString& fileName);

private:
    struct Look;

    static Result<Look> read(LookKind kind, const QString& fileName);
    void putInForce(const Look& look);

    TreeDocument& m_document;
    Settings& m_settings;
    Notice& m_notice;
    std::function<bool()> m_isBusy;
    QWidget& m_window;
};

} // namespace espalier
