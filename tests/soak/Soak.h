// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands/HistoryFollower.h"
#include "model/io/project/HistoryChange.h"
#include "tests/soak/RandomOperations.h"
#include "tests/soak/RecipeLog.h"

#include <QHash>
#include <QTemporaryDir>

#include <map>
#include <utility>

namespace espalier::test {

struct SoakOptions {
    std::uint64_t seed = 1;
    int operations = 800;
    std::uint32_t mostLiving = 250; ///< Internodes; larger trees are cut back
    int saveEvery = 40;             ///< Operations, on average
    int checkEvery = 100;           ///< Operations, on average
    int mostUnsaved = 1000;         ///< Operations after which the document is saved in any case
    std::size_t mostHistory = 0;    ///< Bytes; a longer history is shortened. 0: no history is.
};

/// A document to which random operations of all kinds are applied, and which is saved and read back now and
/// then. The operations are kept as a recipe; played in a new document, without files, the recipe must lead
/// to an equal document.
///
/// After each operation, what has changed is packed and made to a copy of the document as well, as safety
/// copies do; the copy must stay equal to the document.
///
/// When the history takes more memory than it may, its oldest part is dropped, as the program does; the
/// replay drops the same part after the same operation.
///
/// Reading a file loses the undo stack. The recipe is played without files, so nothing is undone beyond the
/// last reading, nor the command that would have joined a travel before it.
class Soak {
public:
    /// @param recipeFile where the recipe is written
    Soak(const SoakOptions& options, const QString& recipeFile);

    /// Performs all operations; returns what went wrong, or nothing.
    QString run();

    int operationsDone() const { return static_cast<int>(m_milestones.size()); }
    /// Mean memory of the process, MB, over the third quarter of the operations and over the last one.
    std::pair<double, double> memoryOfLastQuarters() const;
    const RecipeLog& log() const { return m_log; }
    RecipeLog& log() { return m_log; }
    /// A text for the user: the operations, and the resulting tree.
    QString figures() const;

private:
    int undoable() const;
    /// The beginning of a copy that follows the document.
    void beginCopy();
    /// Makes the last change to the copy; only a part of the work, sometimes, if it need not be @p whole.
    QString followByCopy(bool whole);
    QString checkCopy();
    QString saveAndReload();
    QString check();
    QString shorten();
    void noteMemory();
    QString memoryFault() const;
    QString replay();

    SoakOptions m_options;
    RandomOperations m_random;
    TreeDocument m_document;
    HistoryFollower m_follower{m_document};
    std::optional<HistoryReplay> m_copy;
    QSet<QString> m_copiedImages;
    std::size_t m_changes = 0;
    QTemporaryDir m_folder;
    RecipeLog m_log;
    int m_restored = 0;                           ///< Commands that the last reading restored
    int m_floor = 0;                              ///< Commands that are not undone
    std::vector<std::size_t> m_milestones;        ///< A hash of the document after each operation
    std::map<std::size_t, std::size_t> m_dropped; ///< Deltas, by the number of operations before
    std::vector<double> m_memory;                 ///< MB, from time to time
    int m_unsaved = 0;                            ///< Operations since the document was saved
    QHash<QString, int> m_done;                   ///< By the name of the operation
    int m_reloads = 0;
    int m_reloadsInThePast = 0;
    int m_checks = 0;
    std::uint32_t m_mostLiving = 0;
    std::size_t m_longestHistory = 0;
};

} // namespace espalier::test
