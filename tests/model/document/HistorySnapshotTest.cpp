// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/HistorySnapshot.h"

#include "commands/DocumentProject.h"
#include "commands/Prune.h"
#include "model/document/EditCommand.h"
#include "model/io/project/ProjectFile.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Strands.h"
#include "tests/support/TestClasses.h"
#include "tests/support/TreeBuilder.h"

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
    void allKindsOfRows_areTheSameUnderTheirNewIds();
    void replacedDeltas_comeBackByUndo();
    void whatWasThere_isLeftToTheCaller();

private:
    /// The keys and the world positions of the living internodes.
    static std::vector<std::pair<InternodeKey, Vec3>> living(const TreeDocument& document);
    /// Growth and pruning in turn, so that most internodes that ever lived are dead.
    static void workOn(TreeDocument& document, int turns);
    static bool shorten(TreeDocument& document, std::size_t most);
    static LassoStroke lasso(float width)
    {
        return {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0.0F, 0.0F}, {width, 0.0F}, {width, 1.0F}}};
    }
    /// What differs between the living parts of two trees, apart from ids; empty if nothing does.
    static QString differenceOfLiving(const Tree& a, const Tree& b);
};

QString HistorySnapshotTest::differenceOfLiving(const Tree& a, const Tree& b)
{
    const auto idsOf = [](const Tree& tree) {
        std::vector<InternodeId> ids;
        for (InternodeId id = 0; id < tree.size(); ++id) {
            if (tree.isAlive(id))
                ids.push_back(id);
        }
        return ids;
    };
    const auto leavesOf = [](const Tree& tree) {
        std::vector<LeafId> leaves;
        for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf) {
            if (tree.placedLeaves().death[leaf] == kNever &&
                tree.isAlive(tree.placedLeaves().internode[leaf]))
                leaves.push_back(leaf);
        }
        return leaves;
    };
    const std::vector<InternodeId> ids[] = {idsOf(a), idsOf(b)};
    const std::vector<LeafId> leaves[] = {leavesOf(a), leavesOf(b)};
    if (ids[0].size() != ids[1].size() || leaves[0].size() != leaves[1].size())
        return QStringLiteral("counts");
    if (!(a.parameters() == b.parameters()) || a.lassosInForce() != b.lassosInForce() || a.step() != b.step())
        return QStringLiteral("values in force");
    QString difference;
    const auto parentKey = [](const Tree& tree, InternodeId id) {
        return tree.isRoot(id) ? InternodeKey{} : tree.key(tree.parent(id));
    };
    for (std::size_t i = 0; i < ids[0].size(); ++i) {
        const InternodeId x = ids[0][i];
        const InternodeId y = ids[1][i];
        const auto compare = [&](const auto& column, const auto& left, const auto& right) {
            if (column.name != QLatin1String("parent") && column.name != QLatin1String("parameterSet") &&
                !(left[x] == right[y]))
                difference = QLatin1String(column.name);
        };
        InternodeTable::visit(compare, a.columns(), b.columns());
        const auto compareSparse = [&](const auto& column, const auto& left, const auto& right) {
            if (column.name != QLatin1String("profile") && left.at(x) != right.at(y))
                difference = QLatin1String(column.name);
        };
        SparseTable::visit(compareSparse, a.content().sparse, b.content().sparse);
        if (parentKey(a, x) != parentKey(b, y) || !(a.parametersOf(x) == b.parametersOf(y)))
            difference = QStringLiteral("parent or parameters");
        const StrandProfile* const profiles[] = {a.profileOf(x), b.profileOf(y)};
        if ((profiles[0] == nullptr) != (profiles[1] == nullptr) ||
            (profiles[0] && !(*profiles[0] == *profiles[1])))
            difference = QStringLiteral("profile");
    }
    for (std::size_t i = 0; i < leaves[0].size(); ++i) {
        const LeafId x = leaves[0][i];
        const LeafId y = leaves[1][i];
        const auto compare = [&](const auto& column, const auto& left, const auto& right) {
            if (column.name != QLatin1String("internode") && !(left[x] == right[y]))
                difference = QLatin1String(column.name);
        };
        LeafTable::visit(compare, a.placedLeaves(), b.placedLeaves());
        if (a.key(a.placedLeaves().internode[x]) != b.key(b.placedLeaves().internode[y]))
            difference = QStringLiteral("internode of a leaf");
    }
    return difference;
}

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
    InternodeId last = document.tree().size() - 1;
    while (!document.tree().isAlive(last))
        --last;
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

void HistorySnapshotTest::allKindsOfRows_areTheSameUnderTheirNewIds()
{
    TreeDocument document;
    const Tree& tree = document.tree();
    std::vector<Tree> states;
    const auto act = [&](TreeDelta delta) {
        apply(document, std::move(delta));
        states.push_back(tree);
    };
    TreeParameters parameters = tree.parameters();
    for (int turn = 0; turn < 8; ++turn) {
        const auto value = static_cast<float>(turn + 1);
        const InternodeId stem = tree.size();
        const InternodeId side = stem + 1;
        act(births(tree, std::vector<NewInternode>{{.parent = turn == 0 ? 0 : stem - 3},
                                                   {.parent = stem, .slot = 0, .rotation = branching(0.8)},
                                                   {.parent = side}}));
        act(leafPlacement(tree, std::vector{stem, side}));
        act(widthChange(tree, stem, 0.01F * value));
        act(widthChange(tree, side, 0.02F * value));
        act(profileChange(tree, stem, rectangle(1.0F, 0.1F * value)));
        act(twistChange(tree, stem, 0.1F * value));
        act(newLasso(tree, lasso(value)));
        if (turn % 2 == 1)
            act(lassoChange(tree, static_cast<std::uint32_t>(turn - 1), false));
        parameters.leaves.length = 0.01 * static_cast<double>(value);
        act(parameterChange(tree, parameters));
        act(leafRemoval(tree, 2 * static_cast<LeafId>(turn)));
        act(death(tree, document.index(), side));
    }
    const std::uint32_t rows = tree.size();
    const auto profiles = tree.profiles().size();
    const auto lassos = tree.lassos().size();
    QVERIFY(shorten(document, 1));
    QCOMPARE(differenceOfLiving(tree, states.back()), QString());
    QCOMPARE(indexFault(document), QString());
    QVERIFY(tree.size() < rows);
    QVERIFY(tree.profiles().size() == profiles && tree.lassos().size() < lassos);
    const auto last = states.size() - 1;
    std::size_t undone = 0;
    for (; document.undoStack().canUndo(); ++undone) {
        document.undo();
        QCOMPARE(differenceOfLiving(tree, states[last - undone - 1]), QString());
    }
    QVERIFY(undone >= 10);
    for (; undone > 0; --undone) {
        document.redo();
        QCOMPARE(differenceOfLiving(tree, states[last - undone + 1]), QString());
    }
    QCOMPARE(indexFault(document), QString());
}

void HistorySnapshotTest::replacedDeltas_comeBackByUndo()
{
    TreeDocument document;
    workOn(document, 40);
    const auto end = living(document);
    // An edit in the past takes the place of what came after it.
    travel(document, document.journal().size() - 4);
    grow(document, 1);
    const auto before = living(document);
    QVERIFY(shorten(document, 1));
    QVERIFY(living(document) == before);
    while (document.undoStack().canUndo() && living(document) != end)
        document.undo();
    QVERIFY(living(document) == end);
    QCOMPARE(indexFault(document), QString());
}

void HistorySnapshotTest::whatWasThere_isLeftToTheCaller()
{
    TreeDocument document;
    workOn(document, 30);
    document.exchange(PreparedTree(Tree(7), {}), QStringLiteral("Another"));
    workOn(document, 30);
    const std::weak_ptr<PreparedTree> other = EditCommand::at(document.undoStack(), 30).content().other;
    QVERIFY(!other.expired());
    {
        std::optional<ShortenedHistory> shortened = HistorySnapshot(document).shortenedTo(1);
        QVERIFY(shortened && document.shorten(*shortened));
        QVERIFY(!other.expired());
    }
    QVERIFY(other.expired());
}

} // namespace espalier::test

static const espalier::test::TestClass<espalier::test::HistorySnapshotTest> historySnapshotTest;

#include "HistorySnapshotTest.moc"
