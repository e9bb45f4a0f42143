// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Error.h"
#include "model/tree/Parameters.h"
#include "panels/library/LibraryEntry.h"

#include <QCoreApplication>
#include <QString>

#include <functional>
#include <vector>

namespace espalier {

/// The trees that a person keeps: the projects of one folder, without its subfolders. Beside them the species
/// that come with the program, which are recipes. It holds no list of its own: the folder says what there is.
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

    /// The projects in the folder, those first that were changed last.
    std::vector<LibraryEntry> trees() const;
    /// The recipes of the program by their names; those that cannot be read are left out. It reads them all:
    /// for a worker thread.
    static std::vector<LibraryEntry> species();

    /// A file that is not there yet, for a tree of that name or, if there is one, of the name and a number.
    Result<QString> newFile(const QString& name) const;
    /// The file's new name. Fails if another tree has that name, or if none can.
    Result<QString> rename(const QString& fileName, const QString& name) const;
    /// The copy's file.
    Result<QString> duplicate(const QString& fileName) const;
    /// Where the file is now, if the system has no trash for it: in the folder "Trash" of the library. Empty
    /// if the system took it.
    Result<QString> moveToTrash(const QString& fileName) const;

    /// What is wrong with a name for a tree, in a sentence; empty for nothing.
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

/// The parameters that a tree of a project or recipe is grown with: those in force at the moment that the
/// project shows, those that the recipe begins with. May run on any thread.
Result<TreeParameters> libraryParameters(const QString& fileName);

} // namespace espalier
