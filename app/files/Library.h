// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "panels/library/LibraryEntry.h"

#include <QCoreApplication>
#include <QString>

#include <functional>
#include <vector>

namespace espalier {

/// The user's trees: the projects of one folder, without its subfolders. Beside them the species that come
/// with the program, which are recipes. The object holds no list of its own: it reads the folder each time.
class Library {
    Q_DECLARE_TR_FUNCTIONS(Library)

public:
    /// Moves a file to the trash of the system; false if there is none for it.
    using SystemTrash = std::function<bool(const QString& fileName)>;

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
    /// Moves a tree to the system's trash and returns an empty name. If the system has none for the file,
    /// moves it into the folder "Trash" of the library and returns its new file name.
    Result<QString> moveToTrash(const QString& fileName) const;

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
