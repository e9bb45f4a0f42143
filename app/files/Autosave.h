// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/files/DocumentFile.h"

#include <QElapsedTimer>
#include <QLockFile>
#include <QTimer>

#include <memory>
#include <vector>

namespace espalier {

/// What a crash left behind.
struct Leftover {
    QString fileName; ///< Of the autosaved project
    QString original; ///< The file that it had been opened from, or empty
};

/// Keeps a side file of a document that has changes which are in no file: written in the background after
/// finished commands, not more often than its interval and ten times as seldom as writing takes. A side file
/// that outlives its program is offered at the next start.
class Autosave : public QObject {
    Q_OBJECT

public:
    /// @p interval: s, between two autosaves.
    Autosave(const TreeDocument& document, DocumentFile& file, int interval, QObject* parent = nullptr);
    ~Autosave() override;

    /// s; counts from the next autosave on.
    void setInterval(int interval) { m_interval = interval * 1000; }
    /// Where side files are.
    static QString folder();
    /// Side files whose program is gone. They stay until discard() is called with them.
    static std::vector<Leftover> leftovers();
    static void discard(const Leftover& leftover);

    /// Makes a leftover the side file of the document, which has just been recovered from it.
    void adopt(const Leftover& leftover);
    /// Removes the side file, because all is saved or given up.
    void clear();

Q_SIGNALS:
    /// The side file has been written.
    void written();
    /// It could not be written; said once until it works again.
    void failed(const QString& sentence);

private:
    void schedule();
    void write();

    DocumentFile& m_file;
    QString m_base; ///< Of the names of the side files, with folder
    std::unique_ptr<QLockFile> m_lock;
    QTimer m_timer;
    QElapsedTimer m_sinceWritten;
    qint64 m_interval;     ///< ms
    qint64 m_lastCost = 0; ///< ms
    bool m_isWriting = false;
    bool m_isDue = false; ///< Something has changed since the last snapshot
    bool m_hasFailed = false;
    /// Grows with every clear(): what was begun before must not come back.
    int m_generation = 0;
};

} // namespace espalier
