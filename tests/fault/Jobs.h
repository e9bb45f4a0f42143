// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/HistoryFollower.h"
#include "model/base/Error.h"
#include "model/document/TreeDocument.h"
#include "model/io/project/Project.h"

#include <QByteArray>
#include <QMap>
#include <QString>
#include <QTemporaryDir>

#include <cstddef>
#include <functional>
#include <vector>

namespace espalier::test {

/// Content by name.
using Files = QMap<QString, QByteArray>;

/// All files of a folder, also hidden ones.
Files filesIn(const QString& folder);
/// Makes the folder hold these files and no others.
void put(const QString& folder, const Files& files);
/// Whether the program gives such a name to what only it needs, for a moment.
bool isTemporary(const QString& fileName);

/// One thing that is written, by the code that the program uses.
struct Job {
    QString name;
    std::function<Result<void>(const QString& folder)> work;
    /// Whether the files are those of the document before the job, or after it, and not a mixture.
    std::function<bool(const Files& found, const Files& before, const Files& after)> isWhole;
    /// Name of a file that the job adds to, so that it can be found with a part of what was to be added.
    QString grows{};

    bool isExport() const { return name.startsWith(QLatin1String("export")); }
};

/// A document before and after an edit, and all that the program writes of it: saving, exporting, the safety
/// copy.
class Jobs {
public:
    /// @p internodes: how many there are at least. @p textureSize: pixels of an exported texture's edge.
    Jobs(std::size_t internodes, int textureSize);

    QString folder() const { return m_folder.path(); }
    std::vector<Job> all();
    /// Makes the folder hold what stands there before a job: what the same job has written for another tree.
    Result<void> prepare(const Job& job);
    bool hasDocumentChanged() const;

private:
    /// As writeOutput(), with smaller textures.
    Result<void> exportAfter(const QString& fileName) const;

    const int m_textureSize;
    TreeDocument m_document;
    HistoryFollower m_follower{m_document};
    Project m_before;
    Project m_after;
    QByteArray m_bytes;
    QByteArray m_change;
    QTemporaryDir m_folder;
};

} // namespace espalier::test
