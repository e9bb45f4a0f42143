// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/FileController.h"

#include "app/files/Library.h"
#include "app/files/Outputs.h"
#include "app/runners/Background.h"
#include "panels/Notice.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

namespace espalier {

namespace {

const QString kProjectSuffix = QStringLiteral("espalier");
const QString kRecipeSuffix = QStringLiteral("json");
/// ms; saving that takes longer is shown while it lasts.
constexpr int kSlowSaving = 400;

QString suffixOf(const QString& fileName)
{
    return QFileInfo(fileName).suffix().toLower();
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
      m_autosave(document, m_file, settings.preferences().autosaveInterval)
{
    connect(&m_file, &DocumentFile::saved, this, &FileController::showSaved);
    connect(&m_file, &DocumentFile::saveFailed, this, [this](const QString& sentence) {
        m_keeping.clear();
        m_notice->showWarning(tr("Not saved. %1").arg(sentence));
    });
    connect(&m_autosave, &Autosave::failed, this, [this](const QString& sentence) {
        m_notice->showWarning(tr("The tree cannot be kept safe from a crash: %1").arg(sentence));
    });
}

FileController::~FileController()
{
    if (m_exportCancelled)
        *m_exportCancelled = true;
}

void FileController::startNew()
{
    startWith({});
}

void FileController::startWith(const TreeParameters& parameters)
{
    if (!mayLeave())
        return;
    Q_EMIT aboutToReplace();
    m_file.startNew(parameters);
    m_autosave.clear();
}

void FileController::startFrom(const QString& fileName)
{
    runInBackground(
        this, [fileName] { return libraryParameters(fileName); },
        [this, ask = ++m_startsAsked](const Result<TreeParameters>& parameters) {
            if (ask != m_startsAsked)
                return;
            if (parameters)
                startWith(*parameters);
            else
                m_notice->showWarning(parameters.error().message);
        });
}

void FileController::keepIn(const QString& fileName)
{
    m_file.waitForSaving();
    if (m_file.fileName().isEmpty()) {
        m_keeping = fileName;
        saveTo(fileName);
        return;
    }
    Project project = m_file.snapshot();
    project.name = QFileInfo(fileName).completeBaseName();
    project.thumbnail = m_thumbnail();
    runInBackground(
        this, [project = std::move(project), fileName] { return saveProject(project, fileName); },
        [this, fileName](const Result<void>& written) {
            if (written)
                Q_EMIT kept(fileName);
            else
                m_notice->showWarning(tr("Not saved. %1").arg(written.error().message));
        });
}

bool FileController::canOpen(const QString& fileName)
{
    return suffixOf(fileName) == kProjectSuffix || suffixOf(fileName) == kRecipeSuffix;
}

void FileController::open()
{
    const QString name = QFileDialog::getOpenFileName(
        &m_window, tr("Open"), m_settings.folder(),
        tr("Trees and recipes (*.espalier *.json);;Trees (*.espalier);;Recipes (*.json);;All files (*)"));
    if (!name.isEmpty())
        openFile(name);
}

void FileController::openFile(const QString& fileName)
{
    if (suffixOf(fileName) == kRecipeSuffix)
        openRecipe(fileName);
    else
        openProject(fileName);
}

void FileController::openProject(const QString& fileName)
{
    if (!mayLeave())
        return;
    Q_EMIT aboutToReplace();
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    const Result<QString> opened = m_file.open(fileName);
    QGuiApplication::restoreOverrideCursor();
    if (!opened) {
        m_notice->showWarning(opened.error().message);
        return;
    }
    m_autosave.clear();
    m_notice->finish();
    if (!opened->isEmpty())
        m_notice->showWarning(*opened);
    m_settings.addRecentFile(fileName);
    rememberFolder(fileName);
}

void FileController::openRecipe(const QString& fileName)
{
    Result<Recipe> recipe = readRecipe(fileName);
    if (!recipe) {
        m_notice->showWarning(recipe.error().message);
        return;
    }
    if (recipe->name.isEmpty())
        recipe->name = QFileInfo(fileName).completeBaseName();
    if (!mayLeave())
        return;
    Q_EMIT aboutToReplace();
    rememberFolder(fileName);
    m_notice->finish();
    Q_EMIT recipeOpened(*recipe);
}

void FileController::save()
{
    if (m_file.fileName().isEmpty()) {
        saveAs();
        return;
    }
    saveTo(m_file.fileName());
}

void FileController::saveTo(const QString& fileName)
{
    m_file.waitForSaving();
    m_file.save(fileName, m_thumbnail());
    QTimer::singleShot(kSlowSaving, this, [this] {
        if (m_file.isSaving())
            m_notice->showProgress(tr("Saving %1").arg(m_file.displayName()), -1.0);
    });
}

void FileController::saveAs()
{
    const QString start = m_file.fileName().isEmpty()
                              ? QDir(m_settings.folder()).filePath(m_file.displayName())
                              : m_file.fileName();
    QFileDialog dialog(&m_window, tr("Save"), QFileInfo(start).path(), tr("Trees (*.espalier)"));
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(kProjectSuffix);
    dialog.selectFile(QFileInfo(start).completeBaseName());
    if (dialog.exec() != QDialog::Accepted)
        return;
    saveTo(dialog.selectedFiles().constFirst());
}

void FileController::exportTree()
{
    QString start = m_file.fileName().isEmpty() ? QDir(m_settings.folder()).filePath(m_file.displayName())
                                                : m_file.fileName();
    const QStringList suffixes = exportSuffixes();
    QStringList filters;
    for (const ExportFormat* format : exportFormats())
        filters.append(QStringLiteral("%1 (*.%2)").arg(format->name(), format->suffix()));
    QFileDialog dialog(&m_window, tr("Export"), QFileInfo(start).path());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setNameFilters(filters);
    const qsizetype last = std::max<qsizetype>(0, suffixes.indexOf(m_settings.exportSuffix()));
    dialog.selectNameFilter(filters[last]);
    dialog.setDefaultSuffix(suffixes[last]);
    connect(&dialog, &QFileDialog::filterSelected, &dialog,
            [&dialog, filters, suffixes](const QString& filter) {
                dialog.setDefaultSuffix(suffixes[std::max<qsizetype>(0, filters.indexOf(filter))]);
            });
    dialog.selectFile(QFileInfo(start).completeBaseName());
    if (dialog.exec() == QDialog::Accepted)
        exportTo(dialog.selectedFiles().constFirst());
}

void FileController::exportTo(const QString& fileName)
{
    if (m_exportCancelled)
        *m_exportCancelled = true;
    const auto cancelled = std::make_shared<std::atomic<bool>>(false);
    m_exportCancelled = cancelled;
    m_settings.setExportSuffix(suffixOf(fileName));
    rememberFolder(fileName);

    const QString shortName = QFileInfo(fileName).fileName();
    const auto cancel = [cancelled] { *cancelled = true; };
    m_notice->showProgress(tr("Writing %1").arg(shortName), 0.0, cancel);
    const auto tell = [this, guard = QPointer<FileController>(this), cancelled, cancel,
                       shortName](double share) {
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [this, guard, cancelled, cancel, shortName, share] {
                if (guard && m_exportCancelled == cancelled && !*cancelled)
                    m_notice->showProgress(tr("Writing %1").arg(shortName), share, cancel);
            },
            Qt::QueuedConnection);
        return !*cancelled;
    };
    Project project = m_file.snapshot();
    if (project.name.isEmpty())
        project.name = QFileInfo(fileName).completeBaseName();
    runInBackground(
        this, [project = std::move(project), fileName, tell] { return writeOutput(project, fileName, tell); },
        [this, cancelled, shortName](const Result<void>& written) {
            if (m_exportCancelled != cancelled)
                return;
            m_exportCancelled.reset();
            if (written)
                m_notice->showInformation(tr("Wrote %1").arg(shortName));
            else if (written.error().kind == Error::Kind::Cancelled)
                m_notice->showInformation(tr("%1 was not written.").arg(shortName));
            else
                m_notice->showWarning(tr("Not exported. %1").arg(written.error().message));
        });
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

bool FileController::mayLeave()
{
    Q_EMIT aboutToAsk();
    m_file.waitForSaving();
    if (!m_file.isModified())
        return true;
    QMessageBox question(QMessageBox::NoIcon, tr("Espalier"),
                         tr("%1 has changes that are not saved.").arg(m_file.displayName()),
                         QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, &m_window);
    question.setDefaultButton(QMessageBox::Save);
    switch (question.exec()) {
    case QMessageBox::Save:
        save();
        m_file.waitForSaving();
        return !m_file.isModified();
    case QMessageBox::Discard:
        return true;
    default:
        return false;
    }
}

void FileController::offerRecovery()
{
    const std::vector<Leftover> leftovers = Autosave::leftovers();
    if (leftovers.empty())
        return;
    const Leftover& latest = leftovers.front();
    const QString name =
        latest.original.isEmpty() ? tr("A tree that was never saved") : QFileInfo(latest.original).fileName();
    m_notice->ask(tr("Espalier ended unexpectedly. %1 can be brought back as it was.").arg(name),
                  tr("Bring Back"), tr("Discard"), [this, latest](bool wanted) {
                      if (wanted)
                          recover(latest);
                      else
                          Autosave::discard(latest);
                  });
}

void FileController::recover(const Leftover& leftover)
{
    if (!mayLeave())
        return;
    Result<Project> project = loadProject(leftover.fileName);
    if (!project) {
        m_notice->showWarning(project.error().message);
        Autosave::discard(leftover);
        return;
    }
    Q_EMIT aboutToReplace();
    if (!project->warning.isEmpty())
        m_notice->showWarning(project->warning);
    m_file.recover(std::move(*project), leftover.original);
    m_autosave.adopt(leftover);
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
    menu.addAction(tr("Forget Them"), this, [this] { m_settings.clearRecentFiles(); });
}

} // namespace espalier
