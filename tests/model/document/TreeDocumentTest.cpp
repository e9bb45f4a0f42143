// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/document/TreeDocument.h"

#include "commands/DocumentProject.h"
#include "commands/SetParameters.h"
#include "model/document/PreparedTree.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>

namespace espalier::test {

class TreeDocumentTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void newDocument_isASeedling();
    void change_isSignalledOnceAfterAllHasFollowed();
    void afterAnyEdits_theIndicesAreAsIfFreshlyMade();
    void allUndone_isTheBeginning_allRedoneIsTheEnd();
    void nothingToUndo_isNoEvent();
    void reset_startsAnew();
    void resetToAJournal_revertsThroughIt();
    void openedProject_hasItsStepsAgain();
    void openedProject_namesItsStepsAsBefore();
    void openedProject_inThePast_canUndoTheTravel();
    void openedProject_keepsToTheUndoLimit();
    void openedProject_ofWhichNothingIsKnown_isOneStep();
    void exchange_isUndoneAndRedoneWithAllThatSurroundsIt();
    void revertAndApplyOfEachDelta_passesThroughTheSameTrees();
    void memoryOfALivingInternode_isLimited();
    void journal_hasNoUnusedMemory();
};

void TreeDocumentTest::newDocument_isASeedling()
{
    const TreeDocument document;
    QCOMPARE(document.tree().size(), 1U);
    QCOMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.journal().empty());
    QCOMPARE(document.undoStack().count(), 0);
    QCOMPARE(indexFault(document), QString());
}

void TreeDocumentTest::change_isSignalledOnceAfterAllHasFollowed()
{
    TreeDocument document;
    int applied = 0;
    int reverted = 0;
    connect(&document, &TreeDocument::changed, this, [&](const TreeChange& change) {
        QVERIFY((change.kind == TreeChange::Kind::Reset) == (change.delta == nullptr));
        applied += change.kind == TreeChange::Kind::Applied ? 1 : 0;
        reverted += change.kind == TreeChange::Kind::Reverted ? 1 : 0;
        QCOMPARE(document.index().size(), document.tree().size());
        QCOMPARE(document.tree().step(), change.kind == TreeChange::Kind::Applied ? change.delta->stepAfter
                                                                                  : change.delta->stepBefore);
    });
    const int steps = grow(document, 5);
    QVERIFY(steps > 0);
    QCOMPARE(applied, steps);
    document.undoStack().undo();
    QCOMPARE(applied, steps);
    QCOMPARE(reverted, steps);
}

void TreeDocumentTest::afterAnyEdits_theIndicesAreAsIfFreshlyMade()
{
    for (std::uint64_t seed = 1; seed <= 14; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 20, 120);
        Random random(seed, 2, 0, Purpose::ShootLength);
        int checks = 0;
        for (int edit = 0; edit < 40; ++edit) {
            switch (random.bits() % 6) {
            case 0:
                if (document.index().livingCount() < 700)
                    brush(document, randomStroke(random, document.parameters().growth, 0.6));
                break;
            case 1:
                if (document.index().livingCount() < 700)
                    grow(document, 2);
                break;
            case 2: {
                TreeParameters parameters = randomParameters(random);
                // Internodes keep their length, otherwise old and new parts of the tree would not meet.
                parameters.growth.internodeLength = document.parameters().growth.internodeLength;
                setParameters(document, parameters);
                break;
            }
            case 3:
                document.undoStack().undo();
                break;
            case 4:
                document.undoStack().redo();
                break;
            default: { // a stroke that is taken back
                BrushGesture gesture(document, {0.0, Vec3(0.0F, 0.5F, 0.0F), 0.4F});
                gesture.add({0.3, Vec3(0.3F, 0.8F, 0.1F), 0.4F});
                gesture.cancel();
            }
            }
            if (edit % 4 == 3) {
                QCOMPARE(indexFault(document), QString());
                ++checks;
            }
        }
        QCOMPARE(checks, 10);
    }
}

void TreeDocumentTest::allUndone_isTheBeginning_allRedoneIsTheEnd()
{
    for (std::uint64_t seed = 30; seed < 40; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        QVERIFY(document.undoStack().count() >= 1);
        const Tree done = document.tree();
        const std::size_t journal = document.journal().size();
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QCOMPARE(document.journal().size(), std::size_t{0});
        QCOMPARE(document.index().livingCount(), 1U);
        QCOMPARE(document.tree().step(), 0U);
        QCOMPARE(document.tree().buds(0), kTerminalBud);
        QCOMPARE(indexFault(document), QString());
        const Tree undone = document.tree();
        while (document.undoStack().canRedo())
            document.undoStack().redo();
        QVERIFY(document.tree() == done);
        QCOMPARE(document.journal().size(), journal);
        QCOMPARE(indexFault(document), QString());
        while (document.undoStack().canUndo())
            document.undoStack().undo();
        QVERIFY(document.tree() == undone);
    }
}

void TreeDocumentTest::nothingToUndo_isNoEvent()
{
    TreeDocument document;
    int events = 0;
    document.setEditListener([&](const EditEvent&) { ++events; });
    document.undo();
    document.redo();
    QCOMPARE(events, 0);
    TreeParameters others = document.parameters();
    others.growth.branchingAngle *= 0.5;
    setParameters(document, others);
    events = 0;
    document.undo();
    document.redo();
    QCOMPARE(events, 2);
}

void TreeDocumentTest::reset_startsAnew()
{
    TreeDocument document;
    growAtRandom(document, 50);
    int resets = 0;
    connect(&document, &TreeDocument::changed, this,
            [&](const TreeChange& change) { resets += change.kind == TreeChange::Kind::Reset ? 1 : 0; });
    document.reset(9);
    QCOMPARE(resets, 1);
    QVERIFY(document.tree() == Tree(9));
    QVERIFY(document.journal().empty());
    QCOMPARE(document.undoStack().count(), 0);
    QCOMPARE(indexFault(document), QString());
}

void TreeDocumentTest::resetToAJournal_revertsThroughIt()
{
    TreeDocument document;
    growAtRandom(document, 51);
    TreeDocument other;
    other.reset(document.tree(), document.journal());
    QVERIFY(other.tree() == document.tree());
    QCOMPARE(indexFault(other), QString());
    travel(other, 0);
    QCOMPARE(other.index().livingCount(), 1U);
    QCOMPARE(indexFault(other), QString());
}

namespace {

void undoAll(TreeDocument& document)
{
    while (document.undoStack().canUndo())
        document.undo();
}

void redoAll(TreeDocument& document)
{
    while (document.undoStack().canRedo())
        document.redo();
}

} // namespace

void TreeDocumentTest::openedProject_hasItsStepsAgain()
{
    for (std::uint64_t seed = 60; seed < 66; ++seed) {
        TreeDocument document;
        growAtRandom(document, seed, 60, 300);
        travel(document, document.journal().size() + document.future().size());
        TreeDocument other;
        int indexChanges = 0;
        connect(&other.undoStack(), &QUndoStack::indexChanged, this, [&] { ++indexChanges; });
        showProject(other, projectOf(document, QStringLiteral("Tree")));
        QVERIFY(indexChanges <= 2);
        const QUndoStack& stack = other.undoStack();
        QVERIFY(stack.isClean());
        QVERIFY(stack.canUndo() && !stack.canRedo());
        int edits = 0;
        for (std::size_t i = 0; i < document.journal().size(); ++edits)
            i = JournalEdit::at(document.journal(), i).end;
        QCOMPARE(stack.count(), edits);

        undoAll(other);
        QCOMPARE(other.index().livingCount(), 1U);
        QCOMPARE(other.journal().size(), std::size_t{0});
        QCOMPARE(indexFault(other), QString());
        redoAll(other);
        QVERIFY(other.tree() == document.tree());
        QVERIFY(stack.isClean());
        QCOMPARE(indexFault(other), QString());
    }
}

void TreeDocumentTest::openedProject_namesItsStepsAsBefore()
{
    TreeDocument document;
    document.reset(3);
    const std::array line{Vec3(0.0F, 0.1F, 0.0F), Vec3(0.0F, 1.0F, 0.0F)};
    brush(document, strokeAlong(line, 0.6F, 1.0));
    grow(document, 4);
    grow(document, 1);
    TreeParameters others = document.parameters();
    others.growth.branchingAngle *= 0.5;
    setParameters(document, others);
    TreeDocument opened;
    showProject(opened, projectOf(document, QStringLiteral("Tree")));
    QCOMPARE(opened.undoStack().count(), document.undoStack().count());
    for (int i = 0; i < opened.undoStack().count(); ++i)
        QCOMPARE(opened.undoStack().text(i), document.undoStack().text(i));
    QVERIFY(document.undoStack().text(0) != document.undoStack().text(2));
}

void TreeDocumentTest::openedProject_inThePast_canUndoTheTravel()
{
    TreeDocument document;
    growAtRandom(document, 52);
    travel(document, document.journal().size() + document.future().size());
    const std::size_t whole = document.journal().size();
    QVERIFY(whole > 3);
    Project project = projectOf(document, QStringLiteral("Tree"));
    project.ahead = 2; // in the middle of an edit, maybe
    TreeDocument other;
    showProject(other, project);
    QCOMPARE(other.journal().size(), whole - 2);
    QVERIFY(other.undoStack().isClean());
    other.undo();
    QCOMPARE(other.journal().size(), whole);
    QVERIFY(other.tree() == document.tree());
    other.redo();
    QCOMPARE(other.future().size(), std::size_t{2});
    undoAll(other);
    QCOMPARE(other.index().livingCount(), 1U);
    redoAll(other);
    QCOMPARE(other.journal().size(), whole - 2);
    QCOMPARE(indexFault(other), QString());
}

void TreeDocumentTest::openedProject_keepsToTheUndoLimit()
{
    TreeDocument document;
    for (int i = 0; i < 5; ++i)
        grow(document, 1);
    TreeDocument other;
    other.undoStack().setUndoLimit(2);
    showProject(other, projectOf(document, QStringLiteral("Tree")));
    QCOMPARE(other.undoStack().count(), 2);
    QVERIFY(other.undoStack().isClean());
    undoAll(other);
    QCOMPARE(other.journal().size(), document.journal().size() - 2);
    redoAll(other);
    QVERIFY(other.tree() == document.tree());
    QVERIFY(other.undoStack().isClean());
}

void TreeDocumentTest::openedProject_ofWhichNothingIsKnown_isOneStep()
{
    TreeDocument document;
    for (int i = 0; i < 5; ++i)
        grow(document, 2);
    Project project = projectOf(document, QStringLiteral("Tree"));
    for (auto& delta : project.journal) {
        auto nameless = std::make_shared<TreeDelta>(*delta);
        nameless->record = nullptr;
        delta = std::move(nameless);
    }
    TreeDocument other;
    showProject(other, project);
    QCOMPARE(other.undoStack().count(), 1);
    QCOMPARE(other.undoStack().text(0), QStringLiteral("Earlier Steps"));
    undoAll(other);
    QCOMPARE(other.index().livingCount(), 1U);
    redoAll(other);
    QVERIFY(other.tree() == document.tree());
}

void TreeDocumentTest::exchange_isUndoneAndRedoneWithAllThatSurroundsIt()
{
    TreeDocument document;
    grow(document, 4);
    grow(document, 3);
    travel(document, 5); // It has a future
    const Tree before = document.tree();
    const std::size_t future = document.future().size();
    QVERIFY(future > 0);
    TreeDocument other;
    other.reset(77);
    grow(other, 6);
    const Tree taken = other.tree();
    int exchanged = 0;
    connect(&document, &TreeDocument::changed, this, [&](const TreeChange& change) {
        if (change.kind != TreeChange::Kind::Exchanged)
            return;
        ++exchanged;
        QVERIFY(change.delta == nullptr);
        QCOMPARE(indexFault(document), QString());
    });
    const int steps = document.undoStack().count();
    document.exchange(PreparedTree(other.tree(), other.journal()), QStringLiteral("Exchange"));
    QCOMPARE(document.undoStack().count(), steps + 1);
    QVERIFY(document.tree() == taken && document.future().empty());
    grow(document, 2);
    const Tree further = document.tree();

    for (int round = 0; round < 2; ++round) {
        document.undo();
        QVERIFY(document.tree() == taken);
        document.undo();
        QVERIFY(document.tree() == before);
        QCOMPARE(document.journal().size(), std::size_t{5});
        QCOMPARE(document.future().size(), future);
        // Further back through the own tree's steps, and all the way forward again.
        while (document.undoStack().canUndo())
            document.undo();
        QCOMPARE(document.index().livingCount(), 1U);
        QCOMPARE(document.tree().seed(), before.seed());
        while (document.undoStack().canRedo())
            document.redo();
        QVERIFY(document.tree() == further);
        QCOMPARE(indexFault(document), QString());
    }
    QCOMPARE(exchanged, 5);
    // An edit after it is a step of its own, though the exchange has no deltas.
    document.undo();
    grow(document, 1);
    QCOMPARE(document.undoStack().count(), steps + 2);
}

void TreeDocumentTest::revertAndApplyOfEachDelta_passesThroughTheSameTrees()
{
    TreeDocument document;
    growAtRandom(document, 52, 100, 300);
    std::vector<Tree> trees{document.tree()};
    const std::size_t steps = document.journal().size();
    QVERIFY(steps > 5);
    for (std::size_t position = steps; position-- > 0;) {
        travel(document, position);
        trees.push_back(document.tree());
    }
    for (std::size_t position = 1; position <= steps; ++position) {
        trees.pop_back();
        travel(document, position);
        QVERIFY(document.tree() == trees[trees.size() - 1]);
        QCOMPARE(indexFault(document), QString());
    }
}

void TreeDocumentTest::memoryOfALivingInternode_isLimited()
{
    TreeDocument document;
    GrowGesture growth(document);
    // At many sizes, since the headroom of columns depends on it.
    std::size_t most = 0;
    while (document.index().livingCount() < 30'000 && growth.step()) {
        document.growthModel();
        document.pickIndex();
        if (document.index().livingCount() > 15'000)
            most = std::max(most, document.bytes() / document.index().livingCount());
    }
    growth.finish();
    QVERIFY(document.index().livingCount() >= 30'000);
    QVERIFY2(most <= 330, qPrintable(QStringLiteral("%1 bytes").arg(most)));
}

void TreeDocumentTest::journal_hasNoUnusedMemory()
{
    TreeDocument document;
    grow(document, 30);
    std::size_t changes = 0;
    for (const auto& delta : document.journal()) {
        QCOMPARE(delta->died.capacity(), delta->died.size());
        TreeDelta exact = *delta; // a copy has room for its changes only
        QCOMPARE(delta->bytes(), exact.bytes());
        changes += delta->internodes.buds.size();
    }
    QVERIFY(changes > 100);
}

const TestClass<TreeDocumentTest> treeDocumentTest;

} // namespace espalier::test

#include "TreeDocumentTest.moc"
