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

#include <algorithm>

namespace espalier {

namespace {

constexpr int kRetry = 100;             // ms, until an undo that is under way has ended
constexpr qint64 kLongestHold = 5'000;  // ms for which a gesture is held back
constexpr qint64 kFailurePause = 5'000; // ms
/// The GUI thread collects rows for so long at a time.
constexpr std::chrono::microseconds kSlice(2'000);
/// A copy with more bytes of changes than these, and than twice its project, begins anew.
constexpr qint64 kMostChanges = 16 << 20;
/// A tree of so few internodes is copied at once.
constexpr std::uint32_t kSmall = 5'000;

const QString kUnreadable = QStringLiteral("/unreadable");

} // namespace

QString Leftover::displayName() const
{
    return original.isEmpty() ? Autosave::tr("A tree that was never saved") : QFileInfo(original).fileName();
}

Autosave::Autosave(const TreeDocument& document, DocumentFile& file, QObject* parent)
    : QObject(parent), m_document(document), m_file(file), m_follower(document)
{
    QDir().mkpath(folder());
    takeNewPlace();
    startFollowing();
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(&document.undoStack(), &QUndoStack::indexChanged, this, &Autosave::followDocument);
    connect(&document.undoStack(), &QUndoStack::cleanChanged, this, &Autosave::followDocument);
    connect(&document, &TreeDocument::lookChanged, this, &Autosave::followDocument);
    connect(&document, &TreeDocument::changed, this, &Autosave::followTree);
    connect(&file, &DocumentFile::saved, this, &Autosave::followSaved);
    connect(&file, &DocumentFile::saveFailed, this, &Autosave::beDue);
    connect(&file, &DocumentFile::saveRefused, this, &Autosave::beDue);
}

Autosave::~Autosave()
{
    // Otherwise a file that is being written now could be mistaken for one that a crash has left.
    backgroundThreads().waitForDone();
    if (m_isLeft)
        return;
    removeCopies();
    QFile::remove(m_copy.lockFile());
}

void Autosave::takeNewPlace()
{
    // The lock is held as long as this program runs; a copy whose lock is free was left by a crash. Another
    // program that starts now can take a lock for a left one, so there is a second try.
    for (int tries = 0; tries < 2; ++tries) {
        m_copy = SafetyCopy(folder() + QLatin1Char('/') + QUuid::createUuid().toString(QUuid::WithoutBraces));
        m_lock = FileLock::taken(m_copy.lockFile());
        if (m_lock)
            break;
    }
    m_written.reset();
}

QString Autosave::folder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/autosave");
}

std::vector<Leftover> Autosave::leftovers()
{
    std::vector<Leftover> found;
    const QDir place(folder());
    for (const QFileInfo& file : place.entryInfoList({QStringLiteral("*.lock")}, QDir::Files)) {
        const SafetyCopy copy(file.filePath().chopped(file.suffix().size() + 1));
        std::shared_ptr<FileLock> lock = FileLock::taken(copy.lockFile());
        if (!lock)
            continue;
        // What is left of a program that ended in good order, or before it wrote anything.
        if (!QFileInfo::exists(copy.projectFile())) {
            copy.remove();
            QFile::remove(copy.lockFile());
        }
    }
    for (const QFileInfo& file : place.entryInfoList({QStringLiteral("*.espalier")}, QDir::Files)) {
        const SafetyCopy copy = SafetyCopy::ofProject(file.filePath());
        std::shared_ptr<FileLock> lock = FileLock::taken(copy.lockFile());
        if (!lock)
            continue;
        const SafetyCopy::Origin origin = copy.readOrigin();
        const QFileInfo changes(copy.changesFile());
        const QDateTime written = std::max(file.lastModified(), changes.lastModified());
        found.push_back({file.filePath(), origin.fileName, origin.content, written, std::move(lock)});
    }
    std::ranges::stable_sort(found, std::ranges::greater(), &Leftover::written);
    return found;
}

void Autosave::discard(const Leftover& leftover)
{
    const SafetyCopy copy = SafetyCopy::ofProject(leftover.fileName);
    copy.remove();
    QFile::remove(copy.lockFile());
}

QString Autosave::keepAside(const Leftover& leftover)
{
    const QDir place(folder() + kUnreadable);
    place.mkpath(QStringLiteral("."));
    const QString name =
        QStringLiteral("%1 %2").arg(QFileInfo(leftover.displayName()).completeBaseName(),
                                    leftover.written.toString(QStringLiteral("yyyy-MM-dd hh.mm.ss")));
    QString base = place.filePath(name);
    const auto isTaken = [](const SafetyCopy& copy) {
        return QFileInfo::exists(copy.projectFile()) || QFileInfo::exists(copy.changesFile());
    };
    for (int number = 2; isTaken(SafetyCopy(base)); ++number)
        base = place.filePath(QStringLiteral("%1 (%2)").arg(name).arg(number));
    const SafetyCopy from = SafetyCopy::ofProject(leftover.fileName);
    const SafetyCopy to(base);
    if (!QFile::rename(from.projectFile(), to.projectFile()))
        return from.projectFile();
    // What cannot be moved stays.
    if (QFileInfo::exists(from.changesFile()) && !QFile::rename(from.changesFile(), to.changesFile()))
        return to.projectFile();
    from.remove();
    QFile::remove(from.lockFile());
    return to.projectFile();
}

bool Autosave::hasUnsaved() const
{
    const Edit* edit = m_document.edit();
    return m_file.isModified() || (edit != nullptr && edit->hasChanges());
}

void Autosave::followDocument()
{
    // While the document is being saved it counts as unmodified, although the file is not complete yet.
    if (hasUnsaved() || m_file.isSaving())
        beDue();
    else
        clear();
}

void Autosave::followTree(const TreeChange& change)
{
    // What the copy tells of is not the history any more.
    if (change.kind == TreeChange::Kind::Exchanged || change.kind == TreeChange::Kind::Renumbered)
        beginAnew();
    if (hasUnsaved())
        beDue();
}

/// What was done while the file was being saved is not in it; until it is in a copy, the copy before stays.
void Autosave::followSaved()
{
    if (!hasUnsaved()) {
        clear();
        return;
    }
    beginAnew();
    beDue();
}

void Autosave::beDue()
{
    if (!m_sinceDue.isValid())
        m_sinceDue.start();
    schedule();
}

void Autosave::schedule()
{
    if (m_isLeft || !m_sinceDue.isValid() || m_timer.isActive() || m_isWriting)
        return;
    const qint64 since = m_sinceWritten.isValid() ? m_sinceWritten.elapsed() : m_pause;
    m_timer.start(static_cast<int>(std::clamp<qint64>(m_pause - since, 0, m_pause)));
}

void Autosave::write()
{
    if (m_isWriting || m_isLeft)
        return;
    if (!hasUnsaved()) {
        // A gesture that was cancelled, for example. A file that is being saved is not complete yet.
        if (!m_file.isSaving())
            clear();
        return;
    }
    // An undo that is under way ends soon, a gesture probably does.
    const Edit* edit = m_document.edit();
    if (edit != nullptr && (!edit->hasChanges() || m_sinceDue.elapsed() < kLongestHold)) {
        m_timer.start(kRetry);
        return;
    }
    if (!m_written) {
        begin();
        return;
    }
    if (!m_follower.isBehind()) {
        beUpToDate();
        return;
    }
    if (m_written->changeBytes > std::max(kMostChanges, 2 * m_written->projectBytes)) {
        m_follower.renumber();
        m_beginning = {.project = {}, .file = {}, .copy = m_copy};
        m_written.reset();
        begin();
        return;
    }
    if (std::optional<HistoryChange> change = m_follower.collect(kSlice))
        add(std::move(*change));
    else
        m_timer.start(0);
}

template <class Work, class Done>
void Autosave::run(Work work, Done done)
{
    m_isWriting = true;
    runInBackground(
        this,
        [work = std::move(work)]() mutable {
            QElapsedTimer timer;
            timer.start();
            Outcome outcome;
            try {
                outcome = work();
            } catch (const std::bad_alloc&) {
                outcome.result = memoryError();
            }
            outcome.took = timer.elapsed();
            return outcome;
        },
        [this, done = std::move(done), generation = m_generation, beginnings = m_beginnings,
         copy = m_copy](Outcome outcome) {
            m_isWriting = false;
            if (m_isLeft)
                return;
            m_sinceWritten.start();
            m_pause = 2 * outcome.took;
            if (generation != m_generation)
                copy.remove();
            else if (beginnings == m_beginnings)
                done(std::move(outcome));
            schedule();
        });
}

void Autosave::begin()
{
    if (!m_lock)
        m_lock = FileLock::taken(m_copy.lockFile());
    if (!m_lock) {
        // Another program would take the copy for one that a crash left.
        m_sinceWritten.start();
        fail(tr("The folder %1 cannot be written.").arg(QDir::toNativeSeparators(folder())));
        schedule();
        return;
    }
    Beginning from = std::exchange(m_beginning, {});
    const bool isOfNow = !from.project && !from.file && !from.copy;
    if (isOfNow) {
        from.project = m_file.snapshot();
        m_follower.start();
    }
    run(
        [from = std::move(from), copy = m_copy, origin = origin(), deltas = m_follower.size()]() -> Outcome {
            if (Result<void> done = copy.writeOrigin(origin); !done)
                return {done};
            const Result<SafetyCopy::Written> written =
                from.project ? copy.writeProject(*from.project)
                : from.file  ? copy.copyProject(from.file->fileName, from.file->content)
                             : copy.takeOver(*from.copy, deltas);
            return written ? Outcome{{}, *written} : Outcome{written.error()};
        },
        [this, isOfNow](const Outcome& outcome) {
            if (outcome.result) {
                m_written = outcome.written;
                // What was done meanwhile has waited long enough.
                m_pause = 0;
                if (!m_follower.isBehind())
                    beUpToDate();
            } else if (isOfNow) {
                fail(outcome.result.error().message);
            }
            // Else the next one begins with the document itself.
        });
}

void Autosave::add(HistoryChange change)
{
    // What changes from now on waits for the next time.
    m_sinceDue.restart();
    run(
        [change = std::move(change), copy = m_copy, written = *m_written]() mutable -> Outcome {
            const Result<QByteArray> packed = packChange(change, written.images);
            if (!packed)
                return {packed.error()};
            const Result<void> done = copy.addChange(*packed, written);
            return {done, std::move(written)};
        },
        [this](const Outcome& outcome) {
            if (!outcome.result) {
                beginAnew();
                fail(outcome.result.error().message);
                return;
            }
            m_written = outcome.written;
            if (!m_follower.isBehind())
                beUpToDate();
        });
}

void Autosave::beUpToDate()
{
    m_sinceDue.invalidate();
    m_hasFailed = false;
    if (m_adopted)
        discard(*std::exchange(m_adopted, std::nullopt));
    Q_EMIT written();
}

void Autosave::fail(const QString& sentence)
{
    m_pause = std::max(m_pause, kFailurePause);
    if (!std::exchange(m_hasFailed, true))
        Q_EMIT failed(sentence);
}

void Autosave::waitForWriting()
{
    while (m_isWriting)
        QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents | QEventLoop::WaitForMoreEvents);
}

/// The files hold another history than the follower will know; they stay until there are new ones.
void Autosave::beginAnew()
{
    ++m_beginnings;
    m_written.reset();
    m_beginning = {};
}

void Autosave::startFollowing()
{
    beginAnew();
    m_follower.start();
    if (m_document.tree().size() <= kSmall)
        m_beginning.project = m_file.snapshot();
    else if (m_document.edit() == nullptr && !m_file.isModified() && m_file.knownContent().exists())
        m_beginning.file = origin();
}

std::optional<Leftover> Autosave::handOut()
{
    if (!m_file.isModified())
        return {};
    waitForWriting();
    m_timer.stop();
    const Leftover leftover{m_copy.projectFile(),
                            m_file.fileName(),
                            m_file.knownContent(),
                            QDateTime::currentDateTime(),
                            m_lock,
                            true};
    m_isWriting = true;
    // The lock lives until the copy is written, too, so that it cannot be mistaken for one that a crash left.
    runInBackground(
        this,
        [project = m_file.snapshot(), copy = m_copy, origin = origin(), lock = m_lock]() -> Result<void> {
            if (Result<void> done = copy.writeOrigin(origin); !done)
                return done;
            const Result<SafetyCopy::Written> written = copy.writeProject(project);
            return written ? Result<void>() : written.error();
        },
        [this, adopted = std::exchange(m_adopted, std::nullopt)](const Result<void>& result) {
            m_isWriting = false;
            if (!result)
                fail(result.error().message);
            else if (adopted)
                discard(*adopted);
            schedule();
        });
    takeNewPlace();
    return leftover;
}

void Autosave::adopt(const Leftover& leftover)
{
    waitForWriting();
    clear();
    m_adopted = leftover;
    m_beginning = {};
    // What was handed out may not have been written whole.
    if (!leftover.isHandedOut)
        m_beginning.copy = SafetyCopy::ofProject(leftover.fileName);
    beDue();
}

bool Autosave::leave()
{
    waitForWriting();
    m_timer.stop();
    if (!hasUnsaved())
        return true;
    // Whatever happens, what there is stays.
    m_isLeft = true;
    if (!addAll()) {
        const Result<void> origin = m_copy.writeOrigin(this->origin());
        if (!origin || !m_copy.writeProject(m_file.snapshot()))
            return false;
    }
    if (m_adopted)
        discard(*std::exchange(m_adopted, std::nullopt));
    return true;
}

/// Adds all that waits to the copy, at once; returns false if that is not possible.
bool Autosave::addAll()
{
    if (!m_written)
        return false;
    if (!m_follower.isBehind())
        return true;
    const std::optional<HistoryChange> change = m_follower.collect(std::chrono::hours(1));
    const Result<QByteArray> packed = packChange(*change, m_written->images);
    return packed && m_copy.addChange(*packed, *m_written);
}

void Autosave::removeCopies()
{
    m_copy.remove();
    if (m_adopted)
        discard(*std::exchange(m_adopted, std::nullopt));
}

void Autosave::clear()
{
    if (m_isLeft)
        return;
    ++m_generation;
    m_timer.stop();
    m_sinceDue.invalidate();
    removeCopies();
    startFollowing();
    // Edits that were made while the file was being saved are not in it.
    if (hasUnsaved())
        beDue();
}

} // namespace espalier
