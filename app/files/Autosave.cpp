// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"

#include "app/runners/Background.h"
#include "model/document/Edit.h"
#include "model/io/FileWriter.h"

#include <QCoreApplication>
#include <QDir>
#include <QEventLoop>
#include <QFile>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

namespace espalier {

namespace {

const QString kProject = QStringLiteral(".espalier");
const QString kOrigin = QStringLiteral(".origin");
const QString kLock = QStringLiteral(".lock");
/// ms
constexpr int kRetry = 100;

const QString kUnreadable = QStringLiteral("/unreadable");

void removeFiles(const QString& base)
{
    for (const QString& suffix : {kProject, kOrigin})
        QFile::remove(base + suffix);
}

QString baseOf(const Leftover& leftover)
{
    return leftover.fileName.chopped(kProject.size());
}

/// The origin of the document: the file's name, and a line about what that file held.
struct Origin {
    QString fileName{};
    FileContent content{};
};

QByteArray packOrigin(const Origin& origin)
{
    QString text = origin.fileName;
    if (origin.content.exists())
        text += QLatin1Char('\n') + origin.content.toLine();
    return text.toUtf8();
}

Origin readOrigin(const QString& fileName)
{
    constexpr qint64 kMost = 8192; // bytes
    QFile file(fileName);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.read(kMost));
    const qsizetype end = text.lastIndexOf(QLatin1Char('\n'));
    const FileContent content = FileContent::fromLine(text.mid(end + 1));
    return content.exists() && end >= 0 ? Origin{text.left(end), content} : Origin{text, {}};
}

Result<void> writeFiles(const Project& project, const QString& base, const Origin& origin)
{
    if (Result<void> written = writeFile(base + kOrigin, packOrigin(origin)); !written)
        return written;
    return saveProject(project, base + kProject);
}

} // namespace

QString Leftover::displayName() const
{
    return original.isEmpty() ? Autosave::tr("A tree that was never saved") : QFileInfo(original).fileName();
}

Autosave::Autosave(const TreeDocument& document, DocumentFile& file, int interval, QObject* parent)
    : QObject(parent), m_document(document), m_file(file), m_interval(interval * 1000)
{
    QDir().mkpath(folder());
    takeNewPlace();
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &Autosave::followDocument);
    connect(&document, &TreeDocument::lookChanged, this, &Autosave::followDocument);
    connect(&file, &DocumentFile::saved, this, &Autosave::clear);
    const auto beDue = [this] {
        m_isDue = true;
        schedule();
    };
    connect(&file, &DocumentFile::saveFailed, this, beDue);
    connect(&file, &DocumentFile::saveRefused, this, beDue);
}

Autosave::~Autosave()
{
    // Otherwise a file that is being written now could be mistaken for one that a crash has left.
    backgroundThreads().waitForDone();
    removeCopies();
}

void Autosave::takeNewPlace()
{
    m_base = folder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces);
    // The lock is held as long as this program runs; a copy without a lock was left by a crash.
    m_lock = std::make_shared<QLockFile>(m_base + kLock);
    m_lock->setStaleLockTime(0);
    m_lock->tryLock(0);
}

std::optional<Leftover> Autosave::handOut()
{
    if (!m_file.isModified())
        return {};
    while (m_isWriting)
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
    m_timer.stop();
    const QString base = m_base;
    const Leftover leftover{base + kProject, m_file.fileName(), m_file.knownContent(),
                            QDateTime::currentDateTime(), m_lock};
    // The lock lives until the copy is written, too, so that it cannot be mistaken for one that a crash left.
    runInBackground(
        this,
        [project = m_file.snapshot(), base, origin = Origin{leftover.original, leftover.content},
         lock = m_lock] { return writeFiles(project, base, origin); },
        [this, adopted = std::exchange(m_adopted, std::nullopt)](const Result<void>& result) {
            if (!result)
                Q_EMIT failed(result.error().message);
            else if (adopted)
                discard(*adopted);
        });
    takeNewPlace();
    return leftover;
}

QString Autosave::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/autosave");
}

std::vector<Leftover> Autosave::leftovers()
{
    std::vector<Leftover> found;
    const QDir place(folder());
    for (const QFileInfo& file :
         place.entryInfoList({QLatin1Char('*') + kProject}, QDir::Files, QDir::Time)) {
        const QString base = file.filePath().chopped(kProject.size());
        auto lock = std::make_shared<QLockFile>(base + kLock);
        lock->setStaleLockTime(0);
        if (!lock->tryLock(0))
            continue;
        const Origin origin = readOrigin(base + kOrigin);
        found.push_back(
            {file.filePath(), origin.fileName, origin.content, file.lastModified(), std::move(lock)});
    }
    return found;
}

void Autosave::discard(const Leftover& leftover)
{
    removeFiles(baseOf(leftover));
}

QString Autosave::keepAside(const Leftover& leftover)
{
    const QDir place(folder() + kUnreadable);
    place.mkpath(QStringLiteral("."));
    const QString name =
        QStringLiteral("%1 %2").arg(QFileInfo(leftover.displayName()).completeBaseName(),
                                    leftover.written.toString(QStringLiteral("yyyy-MM-dd hh.mm.ss")));
    QString path = place.filePath(name + kProject);
    for (int number = 2; QFileInfo::exists(path); ++number)
        path = place.filePath(QStringLiteral("%1 (%2)").arg(name).arg(number) + kProject);
    if (!QFile::rename(leftover.fileName, path))
        return leftover.fileName;
    QFile::remove(baseOf(leftover) + kOrigin);
    return path;
}

void Autosave::followDocument()
{
    m_isDue = true;
    // While the document is being saved it counts as unmodified, although the file is not complete yet.
    if (!m_file.isModified() && !m_file.isSaving())
        clear();
    else
        schedule();
}

void Autosave::schedule()
{
    if (!m_isDue || !m_file.isModified() || m_timer.isActive() || m_isWriting)
        return;
    const qint64 pause = std::max(m_interval, 10 * m_lastCost);
    const qint64 since = m_sinceWritten.isValid() ? m_sinceWritten.elapsed() : pause;
    m_timer.start(static_cast<int>(std::clamp<qint64>(pause - since, 0, pause)));
}

void Autosave::write()
{
    if (!m_file.isModified())
        return;
    // An undo that is under way ends soon.
    if (const Edit* edit = m_document.edit(); edit != nullptr && !edit->hasChanges()) {
        m_timer.start(kRetry);
        return;
    }
    m_isWriting = true;
    m_isDue = false;
    m_sinceWritten.start();
    runInBackground(
        this,
        [project = m_file.snapshot(), base = m_base,
         origin = Origin{m_file.fileName(), m_file.knownContent()}] {
            return writeFiles(project, base, origin);
        },
        [this, generation = m_generation](const Result<void>& result) {
            m_isWriting = false;
            m_lastCost = m_sinceWritten.elapsed();
            if (generation != m_generation) {
                removeFiles(m_base);
            } else if (result) {
                m_hasFailed = false;
                if (m_adopted)
                    discard(*std::exchange(m_adopted, std::nullopt));
                Q_EMIT written();
            } else {
                m_isDue = true;
                if (!std::exchange(m_hasFailed, true))
                    Q_EMIT failed(result.error().message);
            }
            schedule();
        });
}

void Autosave::adopt(const Leftover& leftover)
{
    clear();
    m_adopted = leftover;
    m_isDue = true;
    schedule();
}

void Autosave::removeCopies()
{
    removeFiles(m_base);
    if (m_adopted)
        discard(*std::exchange(m_adopted, std::nullopt));
}

void Autosave::clear()
{
    ++m_generation;
    m_timer.stop();
    removeCopies();
    // Edits that were made while the file was being saved are not in it.
    m_isDue = m_file.isModified();
    schedule();
}

} // namespace espalier
