// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/soak/Soak.h"

#include "commands/DocumentProject.h"
#include "commands/TimeGesture.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/document/EditCommand.h"
#include "model/document/HistorySnapshot.h"
#include "tests/soak/Hand.h"
#include "tests/support/Documents.h"

#include <QFile>

#include <malloc.h>

#include <algorithm>
#include <numeric>
#include <span>

namespace espalier::test {

namespace {

/// The whole document, history and future included, without the record of how it was made: a hand goes other
/// ways than the recipe (it leads a branch, the recipe lets it go) to the same history.
Result<QByteArray> packed(const TreeDocument& document)
{
    Project project = projectOf(document, QStringLiteral("soak"));
    for (auto& delta : project.journal) {
        delta = std::make_shared<TreeDelta>(*delta);
        delta->record.reset();
    }
    return packProject(project);
}

/// The tree without anything that only its history knows.
Tree withoutPast(const TreeDocument& document)
{
    const RowsOfDeltas none;
    Renumbering renumbering(document.tree(), document.journal(), document.journal().size(), none);
    if (!renumbering.finish())
        qFatal("the tree has a fault");
    return renumbering.tree();
}

/// The difference between the documents, or nothing. @p wholly: also between what only the histories know.
QString difference(const TreeDocument& a, const TreeDocument& b, bool wholly)
{
    if (a.journal().size() != b.journal().size() || a.future().size() != b.future().size())
        return QStringLiteral("the histories are of different lengths");
    if (!wholly)
        return withoutPast(a) == withoutPast(b) ? QString() : QStringLiteral("the trees differ");
    if (!(a.tree() == b.tree()))
        return QStringLiteral("the trees differ");
    const Result<QByteArray> bytes = packed(a);
    const Result<QByteArray> others = packed(b);
    if (!bytes || !others)
        return (bytes ? others : bytes).error().message;
    return *bytes == *others ? QString() : QStringLiteral("the histories differ");
}

/// A fault that would make a file of the tree unreadable; empty if there is none.
QString lifeFault(const Tree& tree)
{
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (tree.isAlive(id) && !tree.isRoot(id) && !tree.isAlive(tree.parent(id)))
            return QStringLiteral("internode %1 lives on one that does not").arg(id);
    }
    return {};
}

/// The document in brief. A hash, since the memory of many operations is measured.
std::size_t milestoneOf(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    return qHashMulti(0, tree.size(), document.index().livingCount(), document.journal().size(),
                      document.future().size(), tree.step(), tree.widthConstraints().size(),
                      tree.lassoIndicesInForce().size());
}

} // namespace

Soak::Soak(const SoakOptions& options, const QString& recipeFile)
    : m_options(options),
      m_random(options.seed, options.mostLiving),
      m_log(recipeFile, {.name = QStringLiteral("Soak"),
                         .description = {},
                         .seed = options.seed,
                         .parameters = RandomOperations(options.seed, options.mostLiving).parameters(),
                         .camera = {},
                         .operations = {}})
{
    m_milestones.reserve(static_cast<std::size_t>(options.operations));
    m_document.reset(options.seed, m_random.parameters());
    beginCopy();
}

int Soak::undoable() const
{
    return std::max(0, m_document.undoStack().index() - m_floor);
}

QString Soak::run()
{
    while (operationsDone() < m_options.operations) {
        // Sometimes more steps than there are, if a document that was never read would do the same.
        const bool isWhole = m_reloads == 0 && m_dropped.empty();
        const int most = isWhole && m_random.onceIn(20) ? 1000 : undoable();
        RecipeOperation operation = m_random.next(m_document, most);
        // After reading, the same holds for redo.
        if (operation.as<RedoOperation>() && m_document.undoStack().count() <= m_restored)
            continue;
        if (!m_log.add(operation))
            return QStringLiteral("%1 could not be written").arg(m_log.fileName());
        const int stepsBefore = m_document.undoStack().index();
        doByHand(m_document, operation, m_random);
        m_milestones.push_back(milestoneOf(m_document));
        noteMemory();
        if (const QString fault = lifeFault(m_document.tree()); !fault.isEmpty())
            return fault;
        ++m_done[operation.name()];
        m_mostLiving = std::max(m_mostLiving, m_document.index().livingCount());
        m_longestHistory =
            std::max(m_longestHistory, m_document.journal().size() + m_document.future().size());
        if (const QString fault = followByCopy(false); !fault.isEmpty())
            return fault;
        // After a step that no redo can follow, in the replay neither.
        const QUndoStack& stack = m_document.undoStack();
        const bool isNewStep = !operation.as<UndoOperation>() && !operation.as<RedoOperation>() &&
                               stack.index() == stack.count() && stack.index() > stepsBefore;
        if (m_options.mostHistory > 0 && isNewStep && m_random.onceIn(20)) {
            if (const QString fault = shorten(); !fault.isEmpty())
                return fault;
        }
        if (m_random.onceIn(m_options.checkEvery)) {
            if (const QString fault = check(); !fault.isEmpty())
                return fault;
        }
        if (m_random.onceIn(m_options.saveEvery) || ++m_unsaved >= m_options.mostUnsaved) {
            m_unsaved = 0;
            if (const QString fault = saveAndReload(); !fault.isEmpty())
                return fault;
        }
    }
    if (const QString fault = check(); !fault.isEmpty())
        return fault;
    if (const QString fault = memoryFault(); !fault.isEmpty())
        return fault;
    return replay();
}

/// Whether a long history is shortened, and the memory of many operations stays the same.
QString Soak::memoryFault() const
{
    constexpr int kFew = 800;
    constexpr int kMany = 10'000;
    constexpr double kFlat = 1.05;
    if (m_options.mostHistory == 0 || operationsDone() < kFew)
        return {};
    if (m_dropped.empty())
        return QStringLiteral("the history was never shortened");
    const auto [before, last] = memoryOfLastQuarters();
    if (operationsDone() >= kMany && last > kFlat * before)
        return QStringLiteral("the memory is not flat: from %1 to %2 MB").arg(before).arg(last);
    return {};
}

void Soak::beginCopy()
{
    m_follower.start();
    // A copy of the deltas, too: the document writes rows into its own.
    m_copy.emplace(*unpackProject(*packProject(projectOf(m_document, QStringLiteral("soak")))));
}

QString Soak::followByCopy(bool whole)
{
    // Now and then the work is cut into pieces, between which the document goes on.
    const bool isCut = !whole && operationsDone() % 3 == 0;
    const std::chrono::microseconds budget(isCut ? 0 : 1'000'000'000);
    const std::optional<HistoryChange> change = m_follower.collect(budget);
    if (!change)
        return {};
    const Result<QByteArray> packed = packChange(*change, m_copiedImages);
    const Result<void> made = packed ? m_copy->add(*packed) : packed.error();
    if (!made)
        return QStringLiteral("the copy: ") + made.error().message;
    ++m_changes;
    return {};
}

QString Soak::checkCopy()
{
    if (const QString fault = followByCopy(true); !fault.isEmpty())
        return fault;
    if (m_follower.isBehind())
        return QStringLiteral("the copy's follower is still behind");
    const Project document = projectOf(m_document, {});
    const Project& copy = m_copy->project();
    const auto isSame = [](const auto& a, const auto& b) {
        const bool isSameRecord = (a->record == nullptr) == (b->record == nullptr) &&
                                  (a->record == nullptr || *a->record == *b->record);
        return isSameRecord && *a == *b;
    };
    if (copy.ahead != document.ahead || !(copy.tree == document.tree) ||
        !std::ranges::equal(copy.journal, document.journal, isSame))
        return QStringLiteral("the copy that follows the document differs from it");
    if (const Result<void> sound = checkProject(copy); !sound)
        return QStringLiteral("the copy that follows the document: ") + sound.error().message;
    return {};
}

QString Soak::saveAndReload()
{
    if (const QString fault = checkCopy(); !fault.isEmpty())
        return fault;
    const QString fileName = m_folder.filePath(QStringLiteral("soak.espalier"));
    if (const auto saved = saveProject(projectOf(m_document, QStringLiteral("soak")), fileName); !saved)
        return QStringLiteral("saving: ") + saved.error().message;
    Result<Project> project = loadProject(fileName);
    if (!project)
        return QStringLiteral("reading what was saved: ") + project.error().message;

    const QUndoStack& stack = m_document.undoStack();
    const bool wasTravel = stack.index() > 0 && EditCommand::at(stack, stack.index() - 1).isTravel();
    const Tree tree = m_document.tree();
    const std::size_t journal = m_document.journal().size();
    showProject(m_document, std::move(*project));
    if (!(m_document.tree() == tree) || m_document.journal().size() != journal)
        return QStringLiteral("the tree that was read is not the one that was saved");
    m_restored = stack.count();
    // A travel that led back to the present is not among the steps that were read.
    m_floor = m_restored + (wasTravel && m_document.future().empty() ? 1 : 0);
    QFile file(fileName);
    const Result<QByteArray> again = packProject(projectOf(m_document, QStringLiteral("soak")));
    if (!file.open(QIODevice::ReadOnly) || !again || file.readAll() != *again)
        return QStringLiteral("what was read, saved again, gives another file");
    beginCopy();
    ++m_reloads;
    m_reloadsInThePast += m_document.future().empty() ? 0 : 1;
    return {};
}

QString Soak::check()
{
    ++m_checks;
    if (const QString fault = checkCopy(); !fault.isEmpty())
        return fault;
    if (const QString fault = indexFault(m_document); !fault.isEmpty())
        return QStringLiteral("the indices are not those of the tree: ") + fault;

    const Tree tree = m_document.tree();
    const Journal journal = m_document.journal();
    const Journal future = m_document.future();
    const auto isSame = [&] {
        return m_document.tree() == tree && m_document.journal() == journal && m_document.future() == future;
    };
    QUndoStack& stack = m_document.undoStack();
    const int index = stack.index();
    stack.setIndex(0);
    if (const QString fault = indexFault(m_document); !fault.isEmpty())
        return QStringLiteral("after undoing all, the indices are not those of the tree: ") + fault;
    stack.setIndex(index);
    if (!isSame())
        return QStringLiteral("undoing and redoing all leads elsewhere");
    stack.setIndex(stack.count());
    stack.setIndex(index);
    if (!isSame())
        return QStringLiteral("redoing and undoing all leads elsewhere");

    TimeGesture gesture(m_document);
    gesture.moveTo(gesture.historyLength());
    gesture.moveTo(0);
    if (const QString fault = indexFault(m_document); !fault.isEmpty())
        return QStringLiteral("at the beginning of time the indices are not those of the tree: ") + fault;
    gesture.cancel();
    if (!isSame())
        return QStringLiteral("travelling through all of time leads elsewhere");
    if (const QString fault = indexFault(m_document); !fault.isEmpty())
        return QStringLiteral("after travelling the indices are not those of the tree: ") + fault;
    return {};
}

QString Soak::shorten()
{
    const HistorySnapshot history(m_document);
    std::optional<ShortenedHistory> shortened = history.shortenedTo(m_options.mostHistory);
    if (!shortened)
        return {};
    if (const QString fault = checkCopy(); !fault.isEmpty())
        return fault;
    const Tree tree = withoutPast(m_document);
    const std::size_t dropped = shortened->deltas;
    const int steps = shortened->steps;
    if (!m_document.shorten(*shortened))
        return QStringLiteral("the history is not shortened");
    m_dropped.emplace(m_milestones.size(), dropped);
    m_restored = std::max(0, m_restored - steps);
    m_floor = std::max(0, m_floor - steps);
    if (!(withoutPast(m_document) == tree))
        return QStringLiteral("another tree has the shortened history");
    beginCopy();
    return check();
}

void Soak::noteMemory()
{
    constexpr int kEvery = 100;
    if (operationsDone() % kEvery != 0)
        return;
    // What is free counts as in use until the allocator has given it back, which it does as it likes.
    ::malloc_trim(0);
    QFile status(QStringLiteral("/proc/self/statm"));
    if (!status.open(QIODevice::ReadOnly))
        return;
    const double pages = status.readAll().split(' ').value(1).toDouble();
    constexpr double kPagesOfMegabyte = 256;
    m_memory.push_back(pages / kPagesOfMegabyte);
}

std::pair<double, double> Soak::memoryOfLastQuarters() const
{
    const auto mean = [](std::span<const double> values) {
        return values.empty()
                   ? 0.0
                   : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
    };
    const std::size_t quarter = m_memory.size() / 4;
    const std::span<const double> last = std::span(m_memory).last(2 * quarter);
    return {mean(last.first(quarter)), mean(last.last(quarter))};
}

QString Soak::replay()
{
    Result<Recipe> recipe = readRecipe(m_log.fileName());
    if (!recipe)
        return recipe.error().message;
    TreeDocument replayed;
    const std::vector<RecipeOperation> operations = recipe->operations;
    RecipePlayer player(replayed, std::move(*recipe));
    for (std::size_t i = 0; !player.isDone(); ++i) {
        player.playOperation();
        if (i >= m_milestones.size() || milestoneOf(replayed) != m_milestones[i]) {
            return QStringLiteral("the replay goes another way at operation %1, %2")
                .arg(i)
                .arg(operations[i].name());
        }
        if (const auto dropped = m_dropped.find(i + 1); dropped != m_dropped.end()) {
            std::optional<ShortenedHistory> shortened = HistorySnapshot(replayed).without(dropped->second);
            if (!shortened || !replayed.shorten(*shortened))
                return QStringLiteral("the replay's history is not shortened after operation %1").arg(i);
        }
    }
    if (operations.size() != m_milestones.size())
        return QStringLiteral("the recipe is not whole");
    if (const QString fault = difference(m_document, replayed, m_dropped.empty()); !fault.isEmpty())
        return QStringLiteral("the replay does not end in the same document: ") + fault;
    if (const QString fault = indexFault(replayed); !fault.isEmpty())
        return QStringLiteral("the indices of the replay: ") + fault;
    // The way back is the same, too.
    for (int left = undoable(); left > 0; --left) {
        m_document.undoStack().undo();
        replayed.undoStack().undo();
        if (milestoneOf(replayed) != milestoneOf(m_document))
            return QStringLiteral("the replay's undo stack is another one");
    }
    if (const QString fault = difference(m_document, replayed, m_dropped.empty()); !fault.isEmpty())
        return QStringLiteral("after undoing, ") + fault;
    return {};
}

QString Soak::figures() const
{
    QStringList done;
    for (const QString& name : operationNames())
        done += QStringLiteral("%1 %2").arg(name).arg(m_done.value(name));
    return QStringLiteral(
               "%1 operations (%2); read back %3 times, %4 of them in the past; %5 checks; at most %6 "
               "living internodes and %7 deltas of history, shortened %8 times; %9 rows in the end; %10 "
               "changes "
               "followed; memory of the last quarters %11 and %12 MB")
        .arg(operationsDone())
        .arg(done.join(QStringLiteral(", ")))
        .arg(m_reloads)
        .arg(m_reloadsInThePast)
        .arg(m_checks)
        .arg(m_mostLiving)
        .arg(m_longestHistory)
        .arg(m_dropped.size())
        .arg(m_document.tree().size())
        .arg(m_changes)
        .arg(memoryOfLastQuarters().first, 0, 'f', 1)
        .arg(memoryOfLastQuarters().second, 0, 'f', 1);
}

} // namespace espalier::test
