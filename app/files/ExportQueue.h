// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/project/ProjectFile.h"

#include <QObject>
#include <QStringList>

#include <atomic>
#include <deque>
#include <memory>

namespace espalier {

class Notice;

/// Exports on a worker thread, one after the other, and shows in a notice which is being written and how far
/// it is.
class ExportQueue : public QObject {
    Q_OBJECT

public:
    explicit ExportQueue(Notice& notice, QObject* parent = nullptr);
    /// Cancels the exports that are not finished.
    ~ExportQueue() override;

    /// Writes @p project when the exports before it have ended. The suffix of @p fileName says the format.
    void add(Project project, const QString& fileName);

private:
    struct Export {
        Project project;
        QString fileName;
        QString shortName;
        std::atomic<bool> isCancelled = false;
    };

    void begin();
    /// Shows which exports are under way, and that the share @p share of the first is done.
    void show(double share);
    void end(const Result<void>& written);
    /// Shows what became of all exports since the queue was last empty.
    void tellResults();

    Notice& m_notice;
    std::deque<std::shared_ptr<Export>> m_exports; ///< The first one is being written
    double m_share = 0.0;                          ///< Of the first one, 0...1
    QStringList m_written;                         ///< Names of files
    QStringList m_notWritten;                      ///< Sentences
    bool m_hasFailed = false;
};

} // namespace espalier
