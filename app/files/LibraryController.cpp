// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/LibraryController.h"

#include "app/files/FileController.h"
#include "app/runners/Background.h"
#include "panels/Notice.h"
#include "panels/library/LibraryPanel.h"

#include <QDir>
#include <QFileInfo>

namespace espalier {

LibraryController::LibraryController(LibraryPanel& panel, FileController& files, Notice& notice,
                                     Library library, QObject* parent)
    : QObject(parent), m_panel(panel), m_files(files), m_notice(notice), m_library(std::move(library))
{
    connect(&panel, &LibraryPanel::openAsked, &files, &FileController::openFile);
    connect(&panel, &LibraryPanel::startAsked, &files, &FileController::startFrom);
    connect(&panel, &LibraryPanel::keepAsked, this, &LibraryController::keep);
    // Queued, because the text field of the new name is still open when the signal is emitted.
    connect(&panel, &LibraryPanel::renameAsked, this, &LibraryController::rename, Qt::QueuedConnection);
    connect(&panel, &LibraryPanel::duplicateAsked, this, &LibraryController::duplicate);
    connect(&panel, &LibraryPanel::trashAsked, this, &LibraryController::moveToTrash);
    connect(&files, &FileController::kept, this, &LibraryController::showKept);
}

void LibraryController::setFolder(const QString& folder)
{
    m_library = Library(folder);
    refresh();
}

void LibraryController::refresh()
{
    m_panel.setEntries(LibraryPanel::Section::Trees, m_library.trees());
    if (std::exchange(m_hasSpecies, true))
        return;
    runInBackground(this, &Library::species, [this](std::vector<LibraryEntry> species) {
        m_panel.setEntries(LibraryPanel::Section::Species, std::move(species));
    });
}

bool LibraryController::isOpen(const QString& fileName) const
{
    const QString open = m_files.file().fileName();
    return !open.isEmpty() && QFileInfo(open) == QFileInfo(fileName);
}

void LibraryController::keep()
{
    if (m_library.holds(m_files.file().fileName())) {
        m_files.save();
        return;
    }
    const Result<QString> file =
        m_library.newFile(QFileInfo(m_files.file().displayName()).completeBaseName());
    if (file)
        m_files.keepIn(*file);
    else
        m_notice.showWarning(file.error().message);
}

void LibraryController::showKept(const QString& fileName)
{
    m_panel.showSection(LibraryPanel::Section::Trees);
    refresh();
    m_panel.choose(fileName);
    if (m_panel.isVisible())
        m_panel.editName();
}

void LibraryController::rename(const QString& fileName, const QString& name)
{
    m_files.file().waitForSaving();
    const bool wasOpen = isOpen(fileName);
    const Result<QString> moved = m_library.rename(fileName, name);
    if (!moved) {
        m_notice.showWarning(moved.error().message);
        return;
    }
    if (wasOpen)
        m_files.file().fileMoved(*moved);
    refresh();
    m_panel.choose(*moved);
}

void LibraryController::duplicate(const QString& fileName)
{
    m_files.file().waitForSaving();
    const Result<QString> copy = m_library.duplicate(fileName);
    if (!copy) {
        m_notice.showWarning(copy.error().message);
        return;
    }
    refresh();
    m_panel.choose(*copy);
}

void LibraryController::moveToTrash(const QString& fileName)
{
    m_files.file().waitForSaving();
    const bool wasOpen = isOpen(fileName);
    const QString name = QFileInfo(fileName).completeBaseName();
    const Result<Library::Trashed> moved = m_library.moveToTrash(fileName);
    if (!moved) {
        m_notice.showWarning(moved.error().message);
        return;
    }
    if (wasOpen)
        m_files.file().fileLost();
    const QString text =
        moved->isSystems ? tr("%1 is in the trash.").arg(name)
                         : tr("The system has no trash here. %1 is in %2 now.")
                               .arg(name, QDir::toNativeSeparators(QFileInfo(moved->path).absolutePath()));
    if (moved->path.isEmpty())
        m_notice.showInformation(text);
    else
        m_notice.showInformation(text, tr("Undo"),
                                 [this, trashed = *moved, wasOpen] { restore(trashed, wasOpen); });
    refresh();
}

void LibraryController::restore(const Library::Trashed& trashed, bool wasOpen)
{
    if (const Result<void> restored = m_library.restore(trashed); !restored) {
        m_notice.showWarning(restored.error().message);
        return;
    }
    // The open tree has its file again, if it has got no other one.
    if (wasOpen && m_files.file().fileName().isEmpty())
        m_files.file().fileMoved(trashed.original);
    refresh();
    m_panel.choose(trashed.original);
}

} // namespace espalier
