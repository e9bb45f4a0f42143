// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/Library.h"

#include <QObject>

namespace espalier {

class FileController;
class LibraryPanel;
class Notice;

/// Performs what the user does in the library, and shows how it went.
class LibraryController : public QObject {
    Q_OBJECT

public:
    LibraryController(LibraryPanel& panel, FileController& files, Notice& notice, Library library,
                      QObject* parent = nullptr);

    void setFolder(const QString& folder);
    /// Reads the folder again and shows its trees.
    void refresh();

private:
    void keep();
    void showKept(const QString& fileName);
    void rename(const QString& fileName, const QString& name);
    void duplicate(const QString& fileName);
    void moveToTrash(const QString& fileName);
    void restore(const Library::Trashed& trashed, bool wasOpen);
    bool isOpen(const QString& fileName) const;

    LibraryPanel& m_panel;
    FileController& m_files;
    Notice& m_notice;
    Library m_library;
    bool m_hasSpecies = false;
};

} // namespace espalier
