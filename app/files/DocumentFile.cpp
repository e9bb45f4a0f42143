// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/DocumentFile.h"

#include "app/files/SafetyCopy.h"
#include "app/runners/Background.h"
#include "commands/DocumentProject.h"
#include "model/base/Parallel.h"
#include "model/io/FileWriter.h"
#include "model/io/JsonReader.h"
#include "views/render/PreparedScene.h"

#include <QEventLoop>
#include <QFileInfo>
#include <QRandomGenerator>

namespace espalier {

/// The result of a save.
struct DocumentFile::Outcome {
    Result<void> written;
    bool isRefused = false;
    FileContent content{};
    FileStamp stamp{};
};

DocumentFile::DocumentFile(TreeDocument& document, QObject* parent) : QObject(parent), m_document(document)
{
    connect(&document.undoStack(), &QUndoStack::cleanChanged, this, &DocumentFile::titleChanged);
    connect(&document, &TreeDocument::lookChanged, this, &DocumentFile::titleChanged);
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

void DocumentFile::startNew(const TreeParameters& parameters, const QString& displayName)
{
    // Each new tree has another seed, so that the same strokes give another tree.
    m_document.reset(QRandomGenerator::global()->generate(), parameters);
    startUnsaved(displayName);
}

void DocumentFile::setLookOfNewTrees(const SceneLook& look)
{
    m_newLook = look;
    keepWithinLimits(m_newLook);
}

void DocumentFile::startUnsaved(const QString& displayName)
{
    m_savedLook = m_newLook;
    m_foreign = {};
    m_document.setLook(m_newLook);
    forgetFile(displayName);
}

void DocumentFile::setUnmodified()
{
    m_savedLook = m_document.look();
    m_document.undoStack().setClean();
    Q_EMIT titleChanged();
}

/// Gives a tree without a look that of new ones.
void DocumentFile::showTree(PreparedTree tree)
{
    if (!tree.look)
        tree.look = m_newLook;
    m_savedLook = *tree.look;
    keepWithinLimits(m_savedLook);
    m_document.reset(std::move(tree));
}

Result<DocumentFile::Read> DocumentFile::read(const QString& fileName, const std::atomic<bool>& isCancelled)
{
    // The hash is computed before the project is read: if the file is replaced in between, saving asks once
    // too often, not once too seldom.
    const FileStamp stamp = FileStamp::of(fileName);
    const FileContent content = FileContent::of(fileName);
    Result<Project> project = loadProject(fileName);
    if (!project)
        return project.error();
    Read read = prepare(std::move(*project), isCancelled);
    read.fileName = fileName;
    read.content = content;
    read.stamp = stamp;
    return read;
}

Result<DocumentFile::Read> DocumentFile::readCopy(const SafetyCopy& copy,
                                                  const std::atomic<bool>& isCancelled)
{
    Result<Project> project = copy.read();
    if (!project)
        return project.error();
    return prepare(std::move(*project), isCancelled);
}

DocumentFile::Read DocumentFile::prepare(Project project, const std::atomic<bool>& isCancelled)
{
    const QString warning = project.warning;
    ForeignParts foreign = std::move(project.foreign);
    Read read{{}, prepared(std::move(project)), nullptr, warning, std::move(foreign), {}, {}};
    if (isCancelled)
        return read;
    leavingOneThread([&read] {
        PreparedTree& tree = read.tree;
        tree.preparePicking();
        read.scene = std::make_shared<PreparedScene>(tree.tree, tree.index, tree.growthModel->space());
    });
    return read;
}

void DocumentFile::show(Read read)
{
    showTree(std::move(read.tree));
    m_foreign = std::move(read.foreign);
    m_content = read.content;
    m_stamp = read.stamp;
    setFile(read.fileName, QFileInfo(read.fileName).fileName());
}

void DocumentFile::recover(Read read, const QString& fileName, const FileContent& content)
{
    const QString name = fileName.isEmpty() ? QString() : QFileInfo(fileName).fileName();
    showTree(std::move(read.tree));
    m_foreign = std::move(read.foreign);
    m_document.undoStack().resetClean();
    m_content = content;
    m_stamp = FileStamp::of(fileName);
    setFile(fileName, name);
}

DocumentFile::Aside DocumentFile::setAside()
{
    waitForSaving();
    Aside aside{{}, m_savedLook, m_foreign, m_fileName, m_displayName, m_content, m_stamp};
    aside.document = AsideDocument::takenFrom(m_document);
    startUnsaved({});
    return aside;
}

void DocumentFile::bringBack(Aside aside)
{
    m_savedLook = aside.savedLook;
    m_foreign = std::move(aside.foreign);
    aside.document.bringBackTo(m_document);
    m_content = aside.content;
    m_stamp = aside.stamp;
    setFile(aside.fileName, aside.displayName);
}

void DocumentFile::forgetFile(const QString& displayName)
{
    m_content = {};
    m_stamp = {};
    setFile({}, displayName);
}

void DocumentFile::fileMoved(const QString& fileName)
{
    m_stamp = FileStamp::of(fileName);
    setFile(fileName, QFileInfo(fileName).fileName());
}

void DocumentFile::fileLost()
{
    forgetFile(QFileInfo(m_displayName).completeBaseName());
    m_document.undoStack().resetClean();
}

Project DocumentFile::snapshot() const
{
    Project project = projectOf(m_document, QFileInfo(m_displayName).completeBaseName());
    project.foreign = m_foreign;
    return project;
}

DocumentFile::Outcome DocumentFile::write(const Project& project, const QString& fileName,
                                          const std::optional<FileContent>& expected)
{
    const Result<QByteArray> bytes = packProject(project);
    if (!bytes) {
        const QString name = QFileInfo(fileName).fileName();
        return {Error{Error::Kind::Output, inputError(name, bytes.error().message).message}};
    }
    if (expected) {
        const FileContent there = FileContent::of(fileName);
        if (there.exists() && there != *expected)
            return {.written = {}, .isRefused = true};
    }
    Result<void> written = writeFile(fileName, *bytes);
    if (!written)
        return {written.error()};
    return {.written = {}, .content = FileContent::of(*bytes), .stamp = FileStamp::of(fileName)};
}

void DocumentFile::save(const QString& fileName, const QImage& thumbnail, Overwrite overwrite)
{
    if (m_isSaving)
        return;
    m_isSaving = true;
    std::optional<FileContent> expected;
    if (overwrite == Overwrite::WhatIsKnown && m_content.exists() &&
        QFileInfo(fileName).absoluteFilePath() == m_fileName)
        expected = m_content;
    m_previousName = m_fileName;
    m_previousDisplayName = m_displayName;
    // Edits from now on are not in the file. If writing fails, the document becomes modified again.
    m_savedLook = m_document.look();
    m_document.undoStack().setClean();
    setFile(fileName, QFileInfo(fileName).fileName());
    Project project = snapshot();
    project.thumbnail = thumbnail;
    runInBackground(
        this,
        [project = std::move(project), name = m_fileName, expected] {
            try {
                return write(project, name, expected);
            } catch (const std::bad_alloc&) {
                return Outcome{.written = memoryError()};
            }
        },
        [this, name = m_fileName](const Outcome& outcome) { finishSaving(name, outcome); });
}

void DocumentFile::finishSaving(const QString& fileName, const Outcome& outcome)
{
    m_isSaving = false;
    if (outcome.written && !outcome.isRefused) {
        m_content = outcome.content;
        m_stamp = outcome.stamp;
        Q_EMIT titleChanged();
        Q_EMIT saved(fileName);
        return;
    }
    m_document.undoStack().resetClean();
    setFile(m_previousName, m_previousDisplayName);
    if (outcome.isRefused)
        Q_EMIT saveRefused(fileName);
    else
        Q_EMIT saveFailed(outcome.written.error().message);
}

void DocumentFile::waitForSaving()
{
    while (m_isSaving)
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
}

void DocumentFile::lookAtDisk()
{
    if (m_fileName.isEmpty() || !m_content.exists() || m_isSaving)
        return;
    using OnDisk = std::pair<FileStamp, FileContent>;
    runInBackground(
        this,
        [name = m_fileName, before = m_stamp, content = m_content]() -> OnDisk {
            const FileStamp stamp = FileStamp::of(name);
            return {stamp, stamp == before ? content : FileContent::of(name)};
        },
        [this, name = m_fileName, before = m_stamp](const OnDisk& look) {
            // Saving or opening, which came between, knows better.
            if (name == m_fileName && before == m_stamp && !m_isSaving)
                compareWithDisk(look.first, look.second);
        });
}

void DocumentFile::compareWithDisk(const FileStamp& stamp, const FileContent& content)
{
    if (stamp == m_stamp)
        return;
    m_stamp = stamp;
    if (stamp == FileStamp()) {
        m_document.undoStack().resetClean();
        Q_EMIT removedFromDisk(m_fileName);
    } else if (content != m_content) {
        Q_EMIT changedOnDisk(m_fileName);
    }
}

} // namespace espalier
