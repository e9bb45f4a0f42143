// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Autosave.h"
#include "app/files/DocumentFile.h"
#include "app/files/ExportQueue.h"
#include "app/files/NewTree.h"
#include "app/files/Recovery.h"
#include "app/files/Settings.h"
#include "app/files/WorkInHand.h"
#include "commands/recipe/Recipe.h"

#include <QObject>

#include <atomic>
#include <functional>
#include <memory>
#include <optional>

class QMenu;
class QWidget;

namespace espalier {

class Notice;

/// Everything that a person does with files: it asks for names, asks about unsaved changes, tells how it
/// went. A file that replaces the document is read in the background first, and all that is derived from its
/// tree is made there, while the document, and whatever grows in it, goes on; only a file that could be read
/// replaces it, and only after the question about unsaved changes.
class FileController : public QObject {
    Q_OBJECT

public:
    /// @p thumbnail takes a picture of the tree.
    FileController(QWidget& window, TreeDocument& document, Settings& settings, Notice& notice,
                   std::function<QImage()> thumbnail);
    /// Cancels an export; waits for a file that is being written.
    ~FileController() override;
    /// Tells of everything there from now on.
    void setNotice(Notice& notice);
    void setWorkInHand(WorkInHand work) { m_work = std::move(work); }

    DocumentFile& file() { return m_file; }
    Autosave& autosave() { return m_autosave; }

    /// A seedling of the size that was chosen last.
    void startNew() { startWith(NewTree::ofSize(m_settings.treeSize(), false)); }
    /// A seedling of that size, and so are new ones from now on.
    void startNew(TreeSize size);
    /// A seedling with the parameters of a project or recipe and at its scale (NewTree::like()). The file is
    /// read in the background; asks about unsaved changes then.
    void startFrom(const QString& fileName);
    /// Saves the tree into a file of the library: its own, if it has none yet; else a copy. kept() follows.
    void keepIn(const QString& fileName);
    /// Asks for a file.
    void open();
    /// A project or a recipe; opened() or an error's notice follows.
    void openFile(const QString& fileName);
    void save();
    void saveAs();
    /// Asks for a file.
    void saveAsRecipe();
    /// Writes what was done to the tree as a recipe.
    void saveRecipeTo(const QString& fileName);
    /// Asks for a file.
    void exportTree();
    /// The suffix says the format.
    void exportTo(const QString& fileName);

    /// Sets the document aside with its undo stack and its file, so that another tree can be shown for a
    /// while. Nothing is asked, since nothing is lost. Precondition: !isAside().
    void setAside();
    /// Whether a document is set aside.
    bool isAside() const { return m_aside.has_value(); }
    /// Shows the document again that was set aside, after the question about unsaved changes of the one that
    /// is shown. Returns false if the person would rather stay.
    bool bringBack();

    /// Gives up the file that is being read; the document stays as it is. Returns false if there is none.
    bool cancelOpening();

    /// Ends saving that is under way, and leaves what is in no file in safety copies.
    void leave();
    /// Asks about unsaved changes and work that is under way; false if the person would rather stay, or if
    /// saving failed. Staying changes nothing, but that a document that is set aside may have come back: it
    /// is shown when there is a question about it.
    bool mayLeave();
    /// The same for the document that is shown alone.
    bool mayLeaveShown();
    /// Offers everything that crashes have left, see Recovery.
    void offerRecovery(Recovery::Occasion occasion) { m_recovery.start(occasion); }
    /// Tells if another program has changed the document's file; for a window that gets the focus.
    void lookAtDisk() { m_file.lookAtDisk(); }
    void fillRecentFiles(QMenu& menu);
    /// What is proposed when a name is asked for.
    QString proposedPath() const;
    /// Files that can be opened, by their names.
    static bool canOpen(const QString& fileName);

Q_SIGNALS:
    /// The user is asked about unsaved changes now, so what is under the hand must be one of them.
    void aboutToAsk();
    /// Another tree will take the place of this one now.
    void aboutToReplace();
    /// The next reset of the document shows the seedling of @p tree.
    void newTreeBegins(const espalier::NewTree& tree);
    /// The next reset of the document shows the tree of @p scene.
    void scenePrepared(const std::shared_ptr<espalier::PreparedScene>& scene);
    void recipeOpened(const espalier::Recipe& recipe);
    /// The project of this file is shown now.
    void opened(const QString& fileName);
    void kept(const QString& fileName);
    /// A document was set aside, or is no longer.
    void asideChanged();

private:
    struct Aside {
        DocumentFile::Aside file;
        bool isModified = false;
        std::optional<Leftover> copy; ///< The safety copy
    };

    void showAside();

    void startWith(const NewTree& tree);
    void begin(const NewTree& tree);
    /// Calls @p read(isCancelled) on a worker thread, and with what it gives @p show(value), once the person
    /// agrees; with an Error @p failed(message). Of several that are under way only the one begun last is
    /// shown.
    template <class Read, class Show, class Failed>
    void replaceWith(const QString& name, Read read, Show show, Failed failed);
    void openProject(const QString& fileName);
    void openRecipe(const QString& fileName);
    void recover(const Leftover& leftover);
    void warn(const QString& sentence);
    void connectFile();
    void saveTo(const QString& fileName, DocumentFile::Overwrite overwrite);
    void askAboutChanged(const QString& fileName);
    void offerOpeningAgain(const QString& fileName);
    void showSaved(const QString& fileName);
    void rememberFolder(const QString& fileName);

    QWidget& m_window;
    TreeDocument& m_document;
    Settings& m_settings;
    Notice* m_notice;
    std::function<QImage()> m_thumbnail;
    WorkInHand m_work;
    QString m_keeping; ///< The library's file that the tree is being saved into
    /// The file that is being read and will replace the document; null if there is none.
    struct Opening {
        std::atomic<bool> isCancelled = false;
        bool isRead = false;
        bool isShown = false; ///< As progress
    };
    std::shared_ptr<Opening> m_opening;
    std::optional<Aside> m_aside;
    bool m_isAsking = false; ///< Whether the question about unsaved changes is open
    // These deliver to what is above.
    DocumentFile m_file;
    Autosave m_autosave;
    Recovery m_recovery;
    ExportQueue m_exports;
};

} // namespace espalier
