// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"
#include "app/files/DocumentFile.h"
#include "app/files/Settings.h"
#include "commands/recipe/Recipe.h"

#include <QObject>

#include <atomic>
#include <functional>
#include <memory>

class QMenu;
class QWidget;

namespace espalier {

class Notice;

/// Everything that a person does with files: it asks for names, asks about unsaved changes, tells how it
/// went.
class FileController : public QObject {
    Q_OBJECT

public:
    /// @p thumbnail takes a picture of the tree.
    FileController(QWidget& window, TreeDocument& document, Settings& settings, Notice& notice,
                   std::function<QImage()> thumbnail);
    /// Cancels an export.
    ~FileController() override;
    /// Tells of everything there from now on.
    void setNotice(Notice& notice) { m_notice = &notice; }

    DocumentFile& file() { return m_file; }
    Autosave& autosave() { return m_autosave; }

    void startNew();
    /// A seedling with the parameters of a project or recipe, which is read in the background. Asks about
    /// unsaved changes then.
    void startFrom(const QString& fileName);
    /// Saves the tree into a file of the library: its own, if it has none yet; else a copy. kept() follows.
    void keepIn(const QString& fileName);
    /// Asks for a file.
    void open();
    /// A project or a recipe. Asks about unsaved changes first.
    void openFile(const QString& fileName);
    void save();
    void saveAs();
    /// Asks for a file.
    void exportTree();
    /// The suffix says the format.
    void exportTo(const QString& fileName);

    /// Asks about unsaved changes; false if the person would rather stay, or if saving failed.
    bool mayLeave();
    /// Offers what a crash has left, if it has.
    void offerRecovery();
    void fillRecentFiles(QMenu& menu);
    /// Files that can be opened, by their names.
    static bool canOpen(const QString& fileName);

Q_SIGNALS:
    /// The user is asked about unsaved changes now, so what is under the hand must be one of them.
    void aboutToAsk();
    /// Another tree will take the place of this one now.
    void aboutToReplace();
    void recipeOpened(const espalier::Recipe& recipe);
    void kept(const QString& fileName);

private:
    void startWith(const TreeParameters& parameters);
    void openProject(const QString& fileName);
    void openRecipe(const QString& fileName);
    void recover(const Leftover& leftover);
    void saveTo(const QString& fileName);
    void showSaved(const QString& fileName);
    void rememberFolder(const QString& fileName);

    QWidget& m_window;
    TreeDocument& m_document;
    Settings& m_settings;
    Notice* m_notice;
    std::function<QImage()> m_thumbnail;
    DocumentFile m_file;
    Autosave m_autosave;
    QString m_keeping; ///< The library's file that the tree is being saved into
    int m_startsAsked = 0;
    /// Of the export under way, if there is one.
    std::shared_ptr<std::atomic<bool>> m_exportCancelled;
};

} // namespace espalier
