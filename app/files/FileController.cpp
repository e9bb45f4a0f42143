// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileController.h"

#include "app/files/FileDialogs.h"
#include "app/files/Library.h"
#include "app/runners/Background.h"
#include "model/io/import/Skeleton.h"
#include "panels/Notice.h"

#include <QDir>
#include <QFileInfo>
#include <QMenu>
#include <QTimer>

namespace espalier {

using dialogs::suffixOf;

namespace {

/// ms; reading and saving that take longer are shown while they last.
constexpr int kSlow = 300;

/// Outside the template that shows it, where lupdate finds its context.
QString openingText(const QString& name)
{
    return QCoreApplication::translate("espalier::FileController", "Opening %1").arg(name);
}

} // namespace

FileController::FileController(QWidget& window, TreeDocument& document, Settings& settings, Notice& notice,
                               std::function<QImage()> thumbnail)
    : QObject(&window),
      m_window(window),
      m_document(document),
      m_settings(settings),
      m_notice(&notice),
      m_thumbnail(std::move(thumbnail)),
      m_file(document),
      m_autosave(document, m_file),
      m_recovery(window, notice),
      m_exports(notice)
{
    connectFile();
    connect(&m_autosave, &Autosave::failed, this,
            [this](const QString& sentence) { warn(tr("No safety copy can be saved: %1").arg(sentence)); });
    connect(&m_recovery, &Recovery::wanted, this, &FileController::recover);
}

FileController::~FileController()
{
    // Whatever a file being written has to tell is told while all members are there to hear it.
    m_file.waitForSaving();
    m_file.disconnect(this);
}

void FileController::connectFile()
{
    connect(&m_file, &DocumentFile::saved, this, &FileController::showSaved);
    connect(&m_file, &DocumentFile::saveFailed, this, [this](const QString& sentence) {
        m_keeping.clear();
        warn(tr("Not saved. %1").arg(sentence));
    });
    connect(&m_file, &DocumentFile::saveRefused, this, &FileController::askAboutChanged);
    connect(&m_file, &DocumentFile::changedOnDisk, this, &FileController::offerOpeningAgain);
    connect(&m_file, &DocumentFile::removedFromDisk, this, [this](const QString& fileName) {
        warn(tr("%1 was moved or deleted by another program. The tree is still here; save it to keep it.")
                 .arg(QFileInfo(fileName).fileName()));
    });
}

void FileController::setNotice(Notice& notice)
{
    m_notice = &notice;
    m_recovery.setNotice(notice);
}

void FileController::warn(const QString& sentence)
{
    m_notice->showWarning(sentence);
}

void FileController::startNew(TreeSize size)
{
    m_settings.setTreeSize(size);
    startWith(NewTree::ofSize(size, true));
}

void FileController::startWith(const NewTree& tree)
{
    cancelOpening();
    if (mayLeave())
        begin(tree);
}

void FileController::begin(const NewTree& tree)
{
    Q_EMIT aboutToReplace();
    Q_EMIT newTreeBegins(tree);
    m_file.startNew(tree.parameters, tree.name);
    m_autosave.clear();
}

template <class Read, class Show, class Failed>
void FileController::replaceWith(const QString& name, Read read, Show show, Failed failed)
{
    cancelOpening();
    const auto opening = std::make_shared<Opening>();
    m_opening = opening;
    QTimer::singleShot(kSlow, this, [this, name, opening] {
        if (m_opening != opening || opening->isRead)
            return;
        opening->isShown = true;
        m_notice->showProgress(*this, openingText(name), -1.0, [this] { cancelOpening(); });
    });
    runInBackground(
        this, [read = std::move(read), opening] { return read(opening->isCancelled); },
        [=, this](auto result) mutable {
            if (m_opening != opening)
                return;
            opening->isRead = true; // Questions about unsaved changes may take their time
            if (std::exchange(opening->isShown, false))
                m_notice->finishProgress(*this);
            if (!result)
                failed(result.error().message);
            else if (mayLeave() && m_opening == opening)
                show(std::move(*result));
            if (m_opening == opening)
                m_opening.reset();
        });
}

bool FileController::cancelOpening()
{
    const std::shared_ptr<Opening> opening = std::exchange(m_opening, nullptr);
    if (!opening)
        return false;
    opening->isCancelled = true;
    if (opening->isShown)
        m_notice->finishProgress(*this);
    return true;
}

void FileController::startFrom(const QString& fileName)
{
    replaceWith(
        QFileInfo(fileName).completeBaseName(), [fileName](const auto&) { return NewTree::like(fileName); },
        [this](const NewTree& tree) { begin(tree); }, [this](const QString& sentence) { warn(sentence); });
}

void FileController::keepIn(const QString& fileName)
{
    m_file.waitForSaving();
    if (m_file.fileName().isEmpty()) {
        m_keeping = fileName;
        saveTo(fileName, DocumentFile::Overwrite::WhatIsKnown);
        return;
    }
    m_document.interruptEdit();
    Project project = m_file.snapshot();
    project.name = QFileInfo(fileName).completeBaseName();
    project.thumbnail = m_thumbnail();
    runInBackground(
        this, [project = std::move(project), fileName] { return saveProject(project, fileName); },
        [this, fileName](const Result<void>& written) {
            if (written)
                Q_EMIT kept(fileName);
            else
                warn(tr("Not saved. %1").arg(written.error().message));
        });
}

bool FileController::canOpen(const QString& fileName)
{
    const QString suffix = suffixOf(fileName);
    return suffix == dialogs::kProjectSuffix || suffix == dialogs::kRecipeSuffix || suffix == kSkeletonSuffix;
}

void FileController::open()
{
    if (const QString name = dialogs::askForOpening(m_window, m_settings); !name.isEmpty())
        openFile(name);
}

void FileController::openFile(const QString& fileName)
{
    const QString suffix = suffixOf(fileName);
    if (suffix == dialogs::kRecipeSuffix || suffix == kSkeletonSuffix)
        openRecipe(fileName);
    else
        openProject(fileName);
}

void FileController::openProject(const QString& fileName)
{
    const auto show = [this](DocumentFile::Read read) {
        const QString warning = read.warning;
        const QString name = read.fileName;
        Q_EMIT aboutToReplace();
        Q_EMIT scenePrepared(read.scene);
        m_file.show(std::move(read));
        m_autosave.clear();
        m_notice->finish();
        if (!warning.isEmpty())
            warn(warning);
        m_settings.addRecentFile(name);
        rememberFolder(name);
        Q_EMIT opened(name);
    };
    replaceWith(
        QFileInfo(fileName).fileName(),
        [fileName](const auto& isCancelled) { return DocumentFile::read(fileName, isCancelled); }, show,
        [this](const QString& sentence) { warn(sentence); });
}

void FileController::openRecipe(const QString& fileName)
{
    const auto show = [this, fileName](Recipe recipe) {
        if (recipe.name.isEmpty())
            recipe.name = QFileInfo(fileName).completeBaseName();
        Q_EMIT aboutToReplace();
        rememberFolder(fileName);
        m_notice->finish();
        Q_EMIT recipeOpened(recipe);
    };
    replaceWith(
        QFileInfo(fileName).fileName(), [fileName](const auto&) { return readRecipe(fileName); }, show,
        [this](const QString& sentence) { warn(sentence); });
}

void FileController::recover(const Leftover& leftover)
{
    const auto show = [this, leftover](DocumentFile::Read read) {
        const QString warning = read.warning;
        Q_EMIT aboutToReplace();
        Q_EMIT scenePrepared(read.scene);
        m_file.recover(std::move(read), leftover.original, leftover.content);
        m_autosave.adopt(leftover);
        if (warning.isEmpty())
            m_recovery.remind();
        else
            warn(warning);
    };
    replaceWith(
        leftover.displayName(),
        [copy = SafetyCopy::ofProject(leftover.fileName)](const auto& isCancelled) {
            return DocumentFile::readCopy(copy, isCancelled);
        },
        show, [this, leftover](const QString&) { m_recovery.keepAside(leftover); });
}

void FileController::save()
{
    if (m_file.fileName().isEmpty())
        saveAs();
    else
        saveTo(m_file.fileName(), DocumentFile::Overwrite::WhatIsKnown);
}

void FileController::saveTo(const QString& fileName, DocumentFile::Overwrite overwrite)
{
    m_document.interruptEdit();
    m_file.waitForSaving();
    m_file.save(fileName, m_thumbnail(), overwrite);
    QTimer::singleShot(kSlow, this, [this] {
        if (m_file.isSaving())
            m_notice->showProgress(m_file, tr("Saving %1").arg(m_file.displayName()), -1.0);
    });
}

QString FileController::proposedPath() const
{
    return m_file.fileName().isEmpty() ? QDir(m_settings.folder()).filePath(m_file.displayName())
                                       : m_file.fileName();
}

void FileController::saveAs()
{
    // The dialog has asked about replacing a file.
    if (const QString name = dialogs::askForSaving(m_window, proposedPath()); !name.isEmpty())
        saveTo(name, DocumentFile::Overwrite::Anything);
}

void FileController::askAboutChanged(const QString& fileName)
{
    m_keeping.clear();
    m_notice->finishProgress(m_file);
    switch (dialogs::askAboutChanged(m_window, QFileInfo(fileName).fileName())) {
    case dialogs::Changed::Overwrite:
        saveTo(fileName, DocumentFile::Overwrite::Anything);
        break;
    case dialogs::Changed::SaveAs:
        saveAs();
        break;
    case dialogs::Changed::Cancel:
        break;
    }
}

void FileController::offerOpeningAgain(const QString& fileName)
{
    m_notice->ask(
        tr("%1 was changed by another window or program. Saving here asks before it replaces that version.")
            .arg(QFileInfo(fileName).fileName()),
        tr("Open Again"), tr("Keep This"), [this, fileName](bool again) {
            if (again)
                openFile(fileName);
        });
}

void FileController::exportTree()
{
    if (const QString name = dialogs::askForExport(m_window, proposedPath(), m_settings); !name.isEmpty())
        exportTo(name);
}

void FileController::exportTo(const QString& fileName)
{
    m_document.interruptEdit();
    m_settings.setExportSuffix(suffixOf(fileName));
    rememberFolder(fileName);
    Project project = m_file.snapshot();
    if (project.name.isEmpty())
        project.name = QFileInfo(fileName).completeBaseName();
    m_exports.add(std::move(project), fileName);
}

void FileController::showSaved(const QString& fileName)
{
    m_settings.addRecentFile(fileName);
    rememberFolder(fileName);
    m_notice->showInformation(tr("Saved %1").arg(QFileInfo(fileName).fileName()));
    if (std::exchange(m_keeping, {}) == fileName)
        Q_EMIT kept(fileName);
}

void FileController::rememberFolder(const QString& fileName)
{
    // A person's own folders only: the program's recipes and the library are no place to look for files.
    const QString folder = QFileInfo(fileName).absolutePath();
    if (!folder.startsWith(QLatin1Char(':')) && !Library(m_settings.libraryFolder()).holds(fileName))
        m_settings.setFolder(folder);
}

void FileController::setAside()
{
    cancelOpening();
    m_document.interruptEdit();
    m_file.waitForSaving();
    const bool isModified = m_file.isModified();
    std::optional<Leftover> copy = m_autosave.handOut();
    m_aside = Aside{m_file.setAside(), isModified, std::move(copy)};
    m_autosave.clear();
    Q_EMIT asideChanged();
}

void FileController::showAside()
{
    Aside aside = std::move(*m_aside);
    m_aside.reset();
    Q_EMIT aboutToReplace();
    m_file.bringBack(std::move(aside.file));
    if (aside.copy)
        m_autosave.adopt(*aside.copy);
    else
        m_autosave.clear();
    m_notice->finish();
    Q_EMIT asideChanged();
}

bool FileController::bringBack()
{
    cancelOpening();
    if (!m_aside || !mayLeaveShown())
        return false;
    showAside();
    return true;
}

void FileController::leave()
{
    cancelOpening();
    // A file that was changed by another program would be asked about.
    disconnect(&m_file, &DocumentFile::saveRefused, this, nullptr);
    m_file.waitForSaving();
    m_autosave.leave();
}

bool FileController::mayLeave()
{
    if (!mayLeaveShown())
        return false;
    if (!m_aside)
        return true;
    if (m_aside->isModified) {
        showAside();
        return mayLeaveShown();
    }
    m_aside.reset();
    Q_EMIT asideChanged();
    return true;
}

bool FileController::mayLeaveShown()
{
    if (m_isAsking)
        return false;
    Q_EMIT aboutToAsk();
    m_file.waitForSaving();
    const bool isGrowing = m_work.isUnderWay();
    if (!m_file.isModified() && !isGrowing)
        return true;
    m_isAsking = true;
    const dialogs::Unsaved answer = dialogs::askAboutUnsaved(m_window, m_file.displayName(), isGrowing);
    m_isAsking = false;
    if (answer != dialogs::Unsaved::Save)
        return answer == dialogs::Unsaved::Discard;
    m_work.finish();
    save();
    m_file.waitForSaving();
    return !m_file.isModified();
}

void FileController::fillRecentFiles(QMenu& menu)
{
    const QStringList files = m_settings.recentFiles();
    for (const QString& file : files)
        menu.addAction(QFileInfo(file).fileName(), this, [this, file] { openFile(file); })->setToolTip(file);
    if (files.isEmpty()) {
        menu.addAction(tr("None yet"))->setEnabled(false);
        return;
    }
    menu.addSeparator();
    menu.addAction(tr("Clear List"), this, [this] { m_settings.clearRecentFiles(); });
}

} // namespace espalier
