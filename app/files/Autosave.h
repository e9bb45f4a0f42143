// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/DocumentFile.h"
#include "app/files/FileLock.h"
#include "app/files/SafetyCopy.h"
#include "commands/HistoryFollower.h"

#include <QElapsedTimer>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

namespace espalier {

/// A safety copy that a crash left behind. As long as a copy of this value lives, other running programs do
/// not see the leftover.
struct Leftover {
    QString fileName;      ///< File of the autosaved project
    QString original;      ///< File that the document had been opened from, or empty
    FileContent content{}; ///< What the original held when the changes were begun; does not exist if unknown
    QDateTime written;
    std::shared_ptr<FileLock> lock;
    bool isHandedOut = false; ///< Not by a crash, but by Autosave::handOut()

    /// The name of the original without its folder, for the user.
    QString displayName() const;
};

/// Keeps a safety copy of a document that has changes which are in no file. After each finished command, what
/// it changed is added to the copy in the background, so the cost depends on the change and not on the size
/// of the tree. A gesture is added when it ends, or after some seconds. The copy is removed as soon as the
/// document has no such changes any more: saved, discarded, or undone. A safety copy that outlives its
/// program is offered at the next start.
class Autosave : public QObject {
    Q_OBJECT

public:
    Autosave(const TreeDocument& document, DocumentFile& file, QObject* parent = nullptr);
    ~Autosave() override;

    /// The folder of the safety copies.
    static QString folder();
    /// Safety copies whose program is gone, the newest first. They stay until discard() is called with them.
    static std::vector<Leftover> leftovers();
    static void discard(const Leftover& leftover);
    /// Moves a leftover that cannot be read into the folder "unreadable" of folder(), under the name of its
    /// original and its time, so that it is not offered again. Returns the new file name, or the old one if
    /// the file cannot be moved.
    static QString keepAside(const Leftover& leftover);

    /// The document has just been recovered from this leftover, which therefore stays until it has a safety
    /// copy of its own.
    void adopt(const Leftover& leftover);
    /// Removes the safety copy, because all is saved or given up. What the document has now, it was opened
    /// with, or begins with.
    void clear();
    /// The document is going to be set aside: its safety copy, brought up to date, is handed out and stays;
    /// adopt() takes it back. None if the document has no changes that are in no file.
    std::optional<Leftover> handOut();
    /// Brings the safety copy up to date, with what is under way, and lets it outlive the program. For the
    /// end of a session that leaves no time for questions. Returns false if it could not be written.
    bool leave();

Q_SIGNALS:
    /// The safety copy is up to date.
    void written();
    /// The safety copy could not be written; emitted once until writing works again.
    void failed(const QString& sentence);

private:
    /// What a worker thread hands back.
    struct Outcome {
        Result<void> result{};
        std::optional<SafetyCopy::Written> written{};
        qint64 took = 0; ///< ms
    };
    /// What the copy begins with: a project, or else what a file or another copy holds; if there is none of
    /// them, the document as it is then.
    struct Beginning {
        std::optional<Project> project{};
        std::optional<SafetyCopy::Origin> file{};
        std::optional<SafetyCopy> copy{};
    };

    bool hasUnsaved() const;
    SafetyCopy::Origin origin() const { return {m_file.fileName(), m_file.knownContent()}; }
    void followDocument();
    void followTree(const TreeChange& change);
    void followSaved();
    void beDue();
    void schedule();
    void write();
    void begin();
    void add(HistoryChange change);
    bool addAll();
    /// Lets a worker thread do @p work(), which returns an Outcome; @p done(outcome) follows.
    template <class Work, class Done>
    void run(Work work, Done done);
    void waitForWriting();
    /// What the document has now is what its safety copy will begin with.
    void startFollowing();
    void beginAnew();
    void beUpToDate();
    void fail(const QString& sentence);
    /// Removes the safety copy, and the leftover that the document was recovered from.
    void removeCopies();
    void takeNewPlace();

    const TreeDocument& m_document;
    DocumentFile& m_file;
    HistoryFollower m_follower;
    SafetyCopy m_copy;
    std::shared_ptr<FileLock> m_lock;
    std::optional<Leftover> m_adopted;
    Beginning m_beginning;
    /// What the files hold; none as long as they do not hold what the follower knows.
    std::optional<SafetyCopy::Written> m_written;
    QTimer m_timer;
    QElapsedTimer m_sinceWritten;
    QElapsedTimer m_sinceDue; ///< Valid while something waits
    qint64 m_pause = 0;       ///< ms from one writing to the next: twice what the last one took
    bool m_isWriting = false;
    bool m_hasFailed = false;
    bool m_isLeft = false;
    /// Grows with every clear(): a copy whose writing began before must not come back.
    int m_generation = 0;
    int m_beginnings = 0; ///< Grows when the follower begins anew
};

} // namespace espalier
