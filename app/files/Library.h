// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "panels/library/LibraryEntry.h"

#include <QCoreApplication>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

namespace espalier {

/// The user's trees: the projects of one folder, without its subfolders. Beside them the species that come
/// with the program, which are recipes. The object holds no list of its own: it reads the folder each time.
class Library {
    Q_DECLARE_TR_FUNCTIONS(Library)

public:
    /// Moves a file to the trash of the system and returns its path there, which may be unknown (empty);
    /// nothing if the system has no trash for it.
    using SystemTrash = std::function<std::optional<QString>(const QString& fileName)>;
    /// A tree that was moved to the trash.
    struct Trashed {
        QString original;      ///< Its file name before
        QString path;          ///< Where it is now; empty if that is unknown
        bool isSystems = true; ///< In the system's trash, not in the library's folder "Trash"
    };

    /// @p folder is made when the first tree comes to it.
    explicit Library(QString folder);
    Library(QString folder, SystemTrash systemTrash);

    const QString& folder() const { return m_folder; }
    bool holds(const QString& fileName) const;

    /// The projects in the folder, the latest changed first.
    std::vector<LibraryEntry> trees() const;
    /// The recipes of the program by their names; those that cannot be read are left out. Reads all of them:
    /// call it on a worker thread.
    static std::vector<LibraryEntry> species();

    /// The name of a file that does not exist yet, for a tree of that name; a number is added if the name is
    /// taken.
    Result<QString> newFile(const QString& name) const;
    /// Renames a tree and returns its new file name. Fails if another tree has that name, or if the name is
    /// not valid.
    Result<QString> rename(const QString& fileName, const QString& name) const;
    /// Copies a tree and returns the copy's file name.
    Result<QString> duplicate(const QString& fileName) const;
    /// Moves a tree to the system's trash. If the system has none for the file, moves it into the folder
    /// "Trash" of the library.
    Result<Trashed> moveToTrash(const QString& fileName) const;
    /// Puts a tree from the trash back to its place. Fails if another tree is there now.
    Result<void> restore(const Trashed& trashed) const;

    /// What is wrong with a name for a tree, in a sentence; empty if the name is valid.
    static QString problemWith(const QString& name);

private:
    QString pathFor(const QString& name) const;
    Result<void> makeFolder(const QString& folder) const;

    QString m_folder;
    SystemTrash m_systemTrash;
};

/// Picture of a project or recipe; null if it has none. Fails for a file that cannot be read. May run on any
/// thread.
Result<QImage> libraryPicture(const QString& fileName);

} // namespace espalier
