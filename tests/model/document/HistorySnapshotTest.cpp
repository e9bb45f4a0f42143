// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/HistorySnapshot.h"

#include "commands/DocumentProject.h"
#include "commands/Prune.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

class HistorySnapshotTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void oldestSteps_goAndTheTreeStays();
    void shortHistory_isLeftAlone();
    void undoneStepsAndTheFuture_stay();
    void shortenedDocument_canBeSavedAndOpened();
    void saved_staysSaved();
    void selectedBud_staysSelected();
    void changedMeanwhile_isNotShortened();
    void exchangedTree_goesWithItsStep();
    void parametersThatNothingUses_go();

private:
    /// The keys and the world positions of the living internodes.
    static std::vector<std::pair<InternodeKey, Vec3>> living(const TreeDocument& document);
    /// Growth and pruning in turn, so that most internodes that ever lived are dead.
    static void workOn(TreeDocument& document, int turns);
    static bool shorten(TreeDocument& document, std::size_t most);
};

std::vector<std::pair<InternodeKey, Vec3>> HistorySnapshotTest::living(const TreeDocument& document)
{
    std::vector<std::pair<InternodeKey, Vec3>> found;
    const Tree& tree = document.tree();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            found.emplace_back(tree.key(id), document.index().nodePosition(id));
    }
    return found;
}

void HistorySnapshotTest::workOn(TreeDocument& document, int turns)
{
    constexpr std::uint32_t kMost = 60;
    for (int turn = 0; turn < turns; ++turn) {
        const TreeIndex& index = document.index();
        if (index.livingCount() < kMost) {
            QVERIFY(grow(document, 1) > 0);
            continue;
        }
        InternodeId cut = 1;
        while (!document.tree().isAlive(cut) || index.subtreeSize(cut) > index.livingCount() / 2)
            ++cut;
        pruneBranches(document, {{cut}});
    }
}

bool HistorySnapshotTest::shorten(TreeDocument& document, std::size_t most)
{
    std::optional<ShortenedHistory> shortened = HistorySnapshot(document).shortenedTo(most);
    return shortened && document.shorten(*shortened);
}

void HistorySnapshotTest::oldestSteps_goAndTheTreeStays()
{
    TreeDocument document;
    workOn(document, 40);
    const auto before = living(document);
    const std::uint32_t rows = document.tree().size();
    const int steps = document.undoStack().count();
    const std::size_t most = HistorySnapshot(document).bytes() / 2;
    int undone = 0;

    QVERIFY(shorten(document, most));
    QVERIFY(living(document) == before);
    QCOMPARE(indexFault(document), QString());
    QVERIFY(document.tree().size() < rows);
    QVERIFY(document.undoStack().count() < steps);
    QCOMPARE(document.undoStack().index(), document.undoStack().count());
    QVERIFY(HistorySnapshot(document).bytes() <= most);
    while (document.undoStack().canUndo()) {
        document.undo();
        ++undone;
    }
    QVERIFY(undone >= 10);
    QCOMPARE(indexFault(document), QString());
    while (document.undoStack().canRedo())
        document.redo();
    QVERIFY(living(document) == before);
}

void HistorySnapshotTest::shortHistory_isLeftAlone()
{
    TreeDocument document;
    workOn(document, 20);
    QVERIFY(!HistorySnapshot(document).shortenedTo(HistorySnapshot(document).bytes()));
}

void HistorySnapshotTest::undoneStepsAndTheFuture_stay()
{
    TreeDocument document;
    workOn(document, 40);
    travel(document, document.journal().size() - 1);
    const auto before = living(document);
    const std::size_t future = document.future().size();

    QVERIFY(shorten(document, 1));
    QVERIFY(living(document) == before);
    QCOMPARE(document.future().size(), future);
    document.undo(); // the travel
    QCOMPARE(indexFault(document), QString());
    QVERIFY(living(document) != before);

    TreeDocument other;
    workOn(other, 40);
    const auto end = living(other);
    for (int i = 0; i < 3; ++i)
        other.undo();
    QVERIFY(shorten(other, 1));
    QCOMPARE(other.undoStack().count() - other.undoStack().index(), 3);
    while (other.undoStack().canRedo())
        other.redo();
    QVERIFY(living(other) == end);
    QCOMPARE(indexFault(other), QString());
}

void HistorySnapshotTest::shortenedDocument_canBeSavedAndOpened()
{
    TreeDocument document;
    workOn(document, 40);
    QVERIFY(shorten(document, 1));
    const Result<QByteArray> file = packProject(projectOf(document, QStringLiteral("short")));
    QVERIFY2(file, file ? "" : qPrintable(file.error().message));
    Result<Project> project = unpackProject(*file);
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    TreeDocument opened;
    showProject(opened, std::move(*project));
    QVERIFY(opened.tree() == document.tree());
    QVERIFY(living(opened) == living(document));
}

void HistorySnapshotTest::saved_staysSaved()
{
    TreeDocument document;
    workOn(document, 40);
    document.undoStack().setClean();
    QVERIFY(shorten(document, 1));
    QVERIFY(document.undoStack().isClean());
    document.undo();
    QVERIFY(!document.undoStack().isClean());
    document.redo();
    QVERIFY(document.undoStack().isClean());

    // What is saved is further back than undo goes now.
    TreeDocument other;
    workOn(other, 3);
    other.undoStack().setClean();
    workOn(other, 40);
    QVERIFY(shorten(other, 1));
    while (other.undoStack().canUndo()) {
        QVERIFY(!other.undoStack().isClean());
        other.undo();
    }
    QVERIFY(!other.undoStack().isClean());
}

void HistorySnapshotTest::selectedBud_staysSelected()
{
    TreeDocument document;
    workOn(document, 41);
    const InternodeId last = document.tree().size() - 1;
    QVERIFY(document.tree().isAlive(last));
    document.setCompetitors({last, kTerminalSlot});
    const InternodeKey key = document.tree().key(last);
    QVERIFY(shorten(document, 1));
    QVERIFY(document.competitors().node != last);
    QCOMPARE(document.tree().key(document.competitors().node), key);
}

void HistorySnapshotTest::changedMeanwhile_isNotShortened()
{
    TreeDocument document;
    workOn(document, 40);
    std::optional<ShortenedHistory> early = HistorySnapshot(document).shortenedTo(1);
    QVERIFY(early);
    grow(document, 1);
    const DocumentState state(document);
    QVERIFY(!document.shorten(*early));
    QCOMPARE(differenceFrom(state, document), QString());

    std::optional<ShortenedHistory> late = HistorySnapshot(document).shortenedTo(1);
    QVERIFY(late);
    const Edit edit(document);
    QVERIFY(!document.shorten(*late));
}

void HistorySnapshotTest::exchangedTree_goesWithItsStep()
{
    TreeDocument document;
    workOn(document, 30);
    document.exchange(PreparedTree(Tree(7), {}), QStringLiteral("Another"));
    workOn(document, 30);
    const auto before = living(document);
    const std::size_t bytes = HistorySnapshot(document).bytes();
    QVERIFY(shorten(document, 1));
    QVERIFY(living(document) == before);
    QVERIFY(HistorySnapshot(document).bytes() < bytes / 2);
    while (document.undoStack().canUndo())
        document.undo();
    QCOMPARE(document.tree().seed(), std::uint64_t{7});
    QCOMPARE(indexFault(document), QString());

    // While the exchange can be undone, its tree is left alone.
    TreeDocument other;
    workOn(other, 30);
    const auto first = living(other);
    TreeDocument source;
    source.reset(7);
    workOn(source, 60);
    Result<Project> project = unpackProject(*packProject(projectOf(source, QStringLiteral("source"))));
    QVERIFY(project);
    other.exchange(prepared(std::move(*project)), QStringLiteral("Another"));
    for (int i = 0; i < 3; ++i)
        grow(other, 1);
    QVERIFY(shorten(other, 1));
    QVERIFY(other.tree().size() < source.tree().size());
    while (other.undoStack().text(other.undoStack().index()) != QStringLiteral("Another"))
        other.undo();
    QVERIFY(living(other) == first);
    QCOMPARE(indexFault(other), QString());
}

void HistorySnapshotTest::parametersThatNothingUses_go()
{
    TreeDocument document;
    TreeParameters parameters = document.parameters();
    for (int i = 0; i < 60; ++i) {
        parameters.leaves.length = 0.02 + 0.001 * i;
        TreeDelta delta = deltaStartingAt(document.tree());
        delta.parametersAfter = keepParameters(delta, document.tree(), parameters);
        apply(document, std::move(delta));
    }
    const TreeParameters last = document.parameters();
    QCOMPARE(document.tree().parameterSets().size(), 61);
    QVERIFY(shorten(document, 1));
    QVERIFY(document.tree().parameterSets().size() < 15);
    QVERIFY(document.parameters() == last);
    document.undo();
    QCOMPARE(document.parameters().leaves.length, 0.02 + 0.001 * 58);
}

} // namespace espalier::test

static const espalier::test::TestClass<espalier::test::HistorySnapshotTest> historySnapshotTest;

#include "HistorySnapshotTest.moc"
