// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/FileContent.h"
#include "model/document/AsideDocument.h"
#include "model/document/TreeDocument.h"
#include "model/io/project/ProjectFile.h"

#include <QObject>

#include <atomic>
#include <memory>
#include <optional>

namespace espalier {

class SafetyCopy;
struct PreparedScene;

/// The file that a document comes from and goes to. It is written on a worker thread, from a snapshot. Of
/// what the document last read from the file or wrote into it a hash is kept, so that saving does not replace
/// what another window or program has written since.
class DocumentFile : public QObject {
    Q_OBJECT

public:
    /// A project that was read, with what follows from its tree, and what to know about its file.
    struct Read {
        QString fileName;
        PreparedTree tree;
        std::shared_ptr<PreparedScene> scene; ///< Of the tree; null if reading was cancelled
        QString warning;                      ///< See Project::warning
        ForeignParts foreign;
        FileContent content;
        FileStamp stamp;
    };
    /// A document and its file while another tree takes their place.
    struct Aside {
        AsideDocument document;
        SceneLook savedLook;
        ForeignParts foreign;
        QString fileName;
        QString displayName;
        FileContent content;
        FileStamp stamp;
    };
    enum class Overwrite {
        WhatIsKnown, ///< Nothing is written if the document's own file was changed by another program
        Anything,
    };

    explicit DocumentFile(TreeDocument& document, QObject* parent = nullptr);
    /// Waits for a file that is being written.
    ~DocumentFile() override;

    /// Absolute; empty as long as there is none.
    const QString& fileName() const { return m_fileName; }
    /// The name of the file without its folder, for the user.
    QString displayName() const;
    /// Whether the document has changes that are in no file.
    bool isModified() const { return !m_document.undoStack().isClean() || m_document.look() != m_savedLook; }
    /// The document as it is now has no changes that would be lost.
    void setUnmodified();
    bool isSaving() const { return m_isSaving; }
    /// What the document last read from its file or wrote into it; does not exist if that is not known.
    const FileContent& knownContent() const { return m_content; }

    /// The look that documents have which come without one: new ones, and those of older files.
    const SceneLook& lookOfNewTrees() const { return m_newLook; }
    void setLookOfNewTrees(const SceneLook& look);
    /// A seedling without a file. @p displayName: empty if it has no name yet.
    void startNew(const TreeParameters& parameters = {}, const QString& displayName = {});
    /// The document has just got a tree that came from elsewhere, and has no file yet.
    void startUnsaved(const QString& displayName);
    /// Reads a project and prepares all that showing it takes; may run on any thread. What it returns once @p
    /// isCancelled is set is not whole.
    static Result<Read> read(const QString& fileName, const std::atomic<bool>& isCancelled);
    /// The same with a safety copy.
    static Result<Read> readCopy(const SafetyCopy& copy, const std::atomic<bool>& isCancelled);
    /// Shows a project that was read.
    void show(Read read);
    /// Takes over what a crash left: its changes are in no file, @p fileName (may be empty) is where saving
    /// will go, and @p content what that file held when the changes were begun (does not exist if unknown).
    void recover(Read read, const QString& fileName, const FileContent& content);
    /// Takes document and file out; what is left is a seedling without a file.
    Aside setAside();
    /// Makes document and file again what they were.
    void bringBack(Aside aside);
    /// The document's file has been renamed to @p fileName.
    void fileMoved(const QString& fileName);
    /// The document's file has been removed: the whole tree is a change that is in no file.
    void fileLost();

    /// The document as it is now; copies nothing of the columns.
    Project snapshot() const;
    /// Begins to write the document as it is now; one file at a time. saved(), saveFailed() or saveRefused()
    /// follow. Unless it is saved, the document keeps the file that it had before.
    void save(const QString& fileName, const QImage& thumbnail, Overwrite overwrite = Overwrite::WhatIsKnown);
    /// Returns when no file is being written any more.
    void waitForSaving();
    /// Looks in the background whether another program has changed the file; changedOnDisk() or
    /// removedFromDisk() say so, once for each change.
    void lookAtDisk();

Q_SIGNALS:
    /// The name, the modified state or isSaving() has changed.
    void titleChanged();
    void saved(const QString& fileName);
    void saveFailed(const QString& sentence);
    /// Nothing was written, since another window or program has written the file meanwhile.
    void saveRefused(const QString& fileName);
    void changedOnDisk(const QString& fileName);
    /// The document is modified now, since no file holds it.
    void removedFromDisk(const QString& fileName);

private:
    struct Outcome;

    static Read prepare(Project project, const std::atomic<bool>& isCancelled);
    void forgetFile(const QString& displayName);
    void showTree(PreparedTree tree);
    void setFile(const QString& fileName, const QString& displayName);
    static Outcome write(const Project& project, const QString& fileName,
                         const std::optional<FileContent>& expected);
    void finishSaving(const QString& fileName, const Outcome& outcome);
    void compareWithDisk(const FileStamp& stamp, const FileContent& content);

    TreeDocument& m_document;
    SceneLook m_newLook;
    SceneLook m_savedLook;  ///< The look in the document's file, or that the document began with
    ForeignParts m_foreign; ///< Of the document's file
    QString m_fileName;
    QString m_displayName;
    FileContent m_content;
    FileStamp m_stamp; ///< State of the file when it was last looked at
    /// Name of the document's file before the save that is running.
    QString m_previousName;
    QString m_previousDisplayName;
    bool m_isSaving = false;
};

} // namespace espalier
