// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/DocumentFile.h"

#include "app/runners/Background.h"
#include "commands/DocumentProject.h"

#include <QEventLoop>
#include <QFileInfo>
#include <QRandomGenerator>

namespace espalier {

DocumentFile::DocumentFile(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&document.undoStack(), &QUndoStack::cleanChanged, this, &DocumentFile::titleChanged);
}

DocumentFile::~DocumentFile()
{
    waitForSaving();
}

QString DocumentFile::displayName() const
{
    return m_displayName.isEmpty() ? tr("Untitled") : m_displayName;
}

void DocumentFile::setFile(const QString& fileName, const QString& displayName)
{
    m_fileName = fileName.isEmpty() ? QString() : QFileInfo(fileName).absoluteFilePath();
    m_displayName = displayName;
    Q_EMIT titleChanged();
}

void DocumentFile::startNew(const TreeParameters& parameters)
{
    // Each tree is another one, even if the same hand makes it.
    m_document.reset(QRandomGenerator::global()->generate(), parameters);
    setFile({}, {});
}

Result<QString> DocumentFile::open(const QString& fileName)
{
    Result<Project> project = loadProject(fileName);
    if (!project)
        return project.error();
    const QString warning = project->warning;
    showProject(m_document, std::move(*project));
    setFile(fileName, QFileInfo(fileName).fileName());
    return warning;
}

void DocumentFile::recover(Project project, const QString& fileName)
{
    const QString name = fileName.isEmpty() ? QString() : QFileInfo(fileName).fileName();
    showProject(m_document, std::move(project));
    m_document.undoStack().resetClean();
    setFile(fileName, name);
}

void DocumentFile::forgetFile(const QString& displayName)
{
    setFile({}, displayName);
}

void DocumentFile::fileMoved(const QString& fileName)
{
    setFile(fileName, QFileInfo(fileName).fileName());
}

void DocumentFile::fileLost()
{
    setFile({}, QFileInfo(m_displayName).completeBaseName());
    m_document.undoStack().resetClean();
}

Project DocumentFile::snapshot() const
{
    return projectOf(m_document, QFileInfo(m_displayName).completeBaseName());
}

void DocumentFile::save(const QString& fileName, const QImage& thumbnail)
{
    if (m_isSaving)
        return;
    m_isSaving = true;
    // What is done from now on is not in the file. Should writing fail, nothing is.
    m_document.undoStack().setClean();
    setFile(fileName, QFileInfo(fileName).fileName());
    Project project = snapshot();
    project.thumbnail = thumbnail;
    runInBackground(
        this, [project = std::move(project), name = m_fileName] { return saveProject(project, name); },
        [this, name = m_fileName](const Result<void>& written) {
            m_isSaving = false;
            if (written) {
                Q_EMIT saved(name);
                return;
            }
            m_document.undoStack().resetClean();
            Q_EMIT titleChanged();
            Q_EMIT saveFailed(written.error().message);
        });
}

void DocumentFile::waitForSaving()
{
    while (m_isSaving)
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
}

} // namespace espalier
