// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/files/Autosave.h"

#include "app/runners/Background.h"

#include <QDir>
#include <QFile>
#include <QSaveFile>
#include <QStandardPaths>
#include <QThreadPool>
#include <QUuid>

namespace espalier {

namespace {

const QString kProject = QStringLiteral(".espalier");
const QString kOrigin = QStringLiteral(".origin");
const QString kLock = QStringLiteral(".lock");

void removeFiles(const QString& base)
{
    for (const QString& suffix : {kProject, kOrigin})
        QFile::remove(base + suffix);
}

Result<void> writeFiles(const Project& project, const QString& base, const QString& origin)
{
    QSaveFile file(base + kOrigin);
    const QByteArray name = origin.toUtf8();
    if (!file.open(QIODevice::WriteOnly) || file.write(name) != name.size() || !file.commit())
        return Error{Error::Kind::Output, QStringLiteral("%1: %2").arg(file.fileName(), file.errorString())};
    return saveProject(project, base + kProject);
}

} // namespace

Autosave::Autosave(const TreeDocument& document, DocumentFile& file, int interval, QObject* parent)
    : QObject(parent),
      m_file(file),
      m_base(folder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces)),
      m_interval(interval * 1000)
{
    QDir().mkpath(folder());
    // Held as long as this program lives; what a crash leaves can be told by it.
    m_lock = std::make_unique<QLockFile>(m_base + kLock);
    m_lock->setStaleLockTime(0);
    m_lock->tryLock(0);
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, [this] {
        m_isDue = true;
        schedule();
    });
    connect(&file, &DocumentFile::saved, this, &Autosave::clear);
}

Autosave::~Autosave()
{
    // A file that is being written now would be taken for what a crash has left.
    QThreadPool::globalInstance()->waitForDone();
    removeFiles(m_base);
}

QString Autosave::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/autosave");
}

std::vector<Leftover> Autosave::leftovers()
{
    std::vector<Leftover> found;
    const QDir place(folder());
    for (const QString& name : place.entryList({QLatin1Char('*') + kProject}, QDir::Files, QDir::Time)) {
        const QString path = place.filePath(name);
        const QString base = path.chopped(kProject.size());
        QLockFile lock(base + kLock);
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0))
            continue;
        QFile origin(base + kOrigin);
        QString original;
        if (origin.open(QIODevice::ReadOnly))
            original = QString::fromUtf8(origin.read(4096));
        found.push_back({path, original});
    }
    return found;
}

void Autosave::discard(const Leftover& leftover)
{
    const QString base = leftover.fileName.chopped(kProject.size());
    removeFiles(base);
    QFile::remove(base + kLock);
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
    m_isWriting = true;
    m_isDue = false;
    m_sinceWritten.start();
    runInBackground(
        this,
        [project = m_file.snapshot(), base = m_base, origin = m_file.fileName()] {
            return writeFiles(project, base, origin);
        },
        [this, generation = m_generation](const Result<void>& result) {
            m_isWriting = false;
            m_lastCost = m_sinceWritten.elapsed();
            if (generation != m_generation)
                removeFiles(m_base);
            else if (!result && !std::exchange(m_hasFailed, true))
                Q_EMIT failed(result.error().message);
            if (result) {
                m_hasFailed = false;
                Q_EMIT written();
            }
            schedule();
        });
}

void Autosave::adopt(const Leftover& leftover)
{
    const QString base = leftover.fileName.chopped(kProject.size());
    for (const QString& suffix : {kProject, kOrigin})
        QFile::rename(base + suffix, m_base + suffix);
    QFile::remove(base + kLock);
}

void Autosave::clear()
{
    ++m_generation;
    m_timer.stop();
    removeFiles(m_base);
    // What was done while the file was being saved is not in it.
    m_isDue = m_file.isModified();
    schedule();
}

} // namespace espalier
