// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/io/project/ProjectFile.h"

#include <QObject>

namespace espalier {

/// The file that a document comes from and goes to. It is written on a worker thread, from a snapshot.
class DocumentFile : public QObject {
    Q_OBJECT

public:
    explicit DocumentFile(TreeDocument& document, QObject* parent = nullptr);
    /// Waits for a file that is being written.
    ~DocumentFile() override;

    /// Absolute; empty as long as there is none.
    const QString& fileName() const { return m_fileName; }
    /// For a person, without the folder.
    QString displayName() const;
    /// Whether the document has changes that are in no file.
    bool isModified() const { return !m_document.undoStack().isClean(); }
    bool isSaving() const { return m_isSaving; }

    /// A seedling without a file.
    void startNew(const TreeParameters& parameters = {});
    /// Shows the tree of a file; the result is the project's warning, if any. On an error everything stays as
    /// it was.
    Result<QString> open(const QString& fileName);
    /// Takes over what a crash left: its changes are in no file, and @p fileName (may be empty) is where
    /// saving will go.
    void recover(Project project, const QString& fileName);
    /// A tree that came from elsewhere, and has no file yet.
    void forgetFile(const QString& displayName);
    /// Its file has another name now.
    void fileMoved(const QString& fileName);
    /// Its file is gone: all of the tree is a change that is in no file.
    void fileLost();

    /// The document as it is now; copies nothing of the columns.
    Project snapshot() const;
    /// Begins to write the document as it is now; one file at a time. saved() or saveFailed() follow.
    void save(const QString& fileName, const QImage& thumbnail);
    /// Comes back when nothing is being written any more.
    void waitForSaving();

Q_SIGNALS:
    /// Name or modification.
    void titleChanged();
    void saved(const QString& fileName);
    void saveFailed(const QString& sentence);

private:
    void setFile(const QString& fileName, const QString& displayName);

    TreeDocument& m_document;
    QString m_fileName;
    QString m_displayName;
    bool m_isSaving = false;
};

} // namespace espalier
