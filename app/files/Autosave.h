// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/DocumentFile.h"

#include <QElapsedTimer>
#include <QLockFile>
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
    std::shared_ptr<QLockFile> lock;

    /// The name of the original without its folder, for the user.
    QString displayName() const;
};

/// Keeps a safety copy of a document that has changes which are in no file. The copy is written in the
/// background after finished commands, not more often than the interval and ten times as seldom as writing
/// takes. It is removed as soon as the document has no such changes any more: saved, discarded, or undone. A
/// safety copy that outlives its program is offered at the next start.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// @p interval: s, between two autosaves.
    Autosave(const TreeDocument& document, DocumentFile& file, int interval, QObject* parent = nullptr);
    ~Autosave() override;

    /// @p interval in s; it counts from the next autosave on.
    void setInterval(int interval) { m_interval = interval * 1000; }
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
    /// Removes the safety copy, because all is saved or given up.
    void clear();
    /// The document is going to be set aside: its safety copy, brought up to date, is handed out and stays;
    /// adopt() takes it back. None if the document has no changes that are in no file.
    std::optional<Leftover> handOut();

Q_SIGNALS:
    /// The safety copy has been written.
    void written();
    /// The safety copy could not be written; emitted once until writing works again.
    void failed(const QString& sentence);

private:
    void schedule();
    void write();
    void followDocument();
    /// Removes the safety copy, and the leftover that the document was recovered from.
    void removeCopies();
    void takeNewPlace();

    const TreeDocument& m_document;
    DocumentFile& m_file;
    QString m_base; ///< Folder and base name of the safety copy's files
    std::shared_ptr<QLockFile> m_lock;
    std::optional<Leftover> m_adopted;
    QTimer m_timer;
    QElapsedTimer m_sinceWritten;
    qint64 m_interval;     ///< ms
    qint64 m_lastCost = 0; ///< ms
    bool m_isWriting = false;
    bool m_isDue = false; ///< Something has changed since the last snapshot
    bool m_hasFailed = false;
    /// Grows with every clear(): a copy whose writing began before a clear() must not come back.
    int m_generation = 0;
};

} // namespace espalier
