// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/performances/RecipeReplica.h"
#include "model/document/EditFollower.h"
#include "model/io/project/ProjectFile.h"
#include "model/mesh/BranchMesher.h"
#include "model/mesh/LeafCard.h"
#include "model/mesh/LeafPlacer.h"
#include "tests/support/Documents.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QDir>
#include <QTest>

namespace espalier::test {

/// The samples that the program comes with.
class SampleRecipesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void undoingAndRedoingAll_restoresTheDocument_data();
    void undoingAndRedoingAll_restoresTheDocument();
    void documentThatFollowsAReplica_isTheSame_data() { undoingAndRedoingAll_restoresTheDocument_data(); }
    void documentThatFollowsAReplica_isTheSame();
    void nothing_liesBelowTheGround_data() { undoingAndRedoingAll_restoresTheDocument_data(); }
    void nothing_liesBelowTheGround();
    void historyOfAPlayedRecipe_isARecipeOfTheSameTree_data();
    void historyOfAPlayedRecipe_isARecipeOfTheSameTree();
};

namespace {

QByteArray packed(const TreeDocument& document)
{
    const Result<QByteArray> content = packProject({document.tree(), document.journal(), {}, {}});
    return content ? *content : QByteArray();
}

} // namespace

void SampleRecipesTest::undoingAndRedoingAll_restoresTheDocument_data()
{
    QTest::addColumn<QString>("fileName");
    const QDir folder(QStringLiteral(SOURCE_DIR "/resources/recipes"));
    const QStringList names = folder.entryList({QStringLiteral("*.json")});
    QVERIFY(names.size() >= 16);
    for (const QString& name : names)
        QTest::newRow(qPrintable(name)) << folder.filePath(name);
}

void SampleRecipesTest::undoingAndRedoingAll_restoresTheDocument()
{
    QFETCH(const QString, fileName);
    const Result<Recipe> recipe = readRecipe(fileName);
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument document;
    const RecipePlayer seedling(document, *recipe);
    const DocumentState empty(document);

    RecipePlayer player(document, *recipe);
    player.playAll();
    QCOMPARE(player.warnings(), QStringList());
    QVERIFY(document.index().livingCount() > 30);
    const DocumentState whole(document);
    const QByteArray file = packed(document);
    QVERIFY(!file.isEmpty());

    QUndoStack& stack = document.undoStack();
    while (stack.canUndo())
        stack.undo();
    QCOMPARE(document.index().livingCount(), 1U);
    QCOMPARE(differenceFrom(empty, document), QString());
    QCOMPARE(indexFault(document), QString());

    while (stack.canRedo())
        stack.redo();
    QVERIFY(DocumentState(document) == whole);
    QCOMPARE(packed(document), file);
    QCOMPARE(indexFault(document), QString());
}

void SampleRecipesTest::documentThatFollowsAReplica_isTheSame()
{
    QFETCH(const QString, fileName);
    const Result<Recipe> recipe = readRecipe(fileName);
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument straight;
    RecipePlayer(straight, *recipe).playAll();

    RecipeReplica replica(*recipe);
    TreeDocument document;
    document.reset(recipe->seed, recipe->parameters);
    EditFollower follower(document);
    for (bool isDone = false; !isDone;) {
        RecipePart part = replica.advance(0.25, std::chrono::milliseconds(1));
        isDone = part.moment.isDone;
        follower.add(std::move(part.events));
        while (follower.advance(std::chrono::milliseconds(0))) {
        }
    }
    QCOMPARE(differenceFrom(DocumentState(straight), document), QString());
    QCOMPARE(packed(document), packed(straight));
    QCOMPARE(document.undoStack().count(), straight.undoStack().count());
    QCOMPARE(document.undoStack().undoText(), straight.undoStack().undoText());
}

void SampleRecipesTest::nothing_liesBelowTheGround()
{
    QFETCH(const QString, fileName);
    const Result<Recipe> recipe = readRecipe(fileName);
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument document;
    RecipePlayer(document, *recipe).playAll();
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    // Bent branches may reach at most a hand's breadth below the ground; the drawn mesh not at all.
    float deepest = 0.0F;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            deepest = std::min(deepest, index.nodePosition(id).y());
    }
    QVERIFY2(deepest > -0.1F, qPrintable(QString::number(deepest)));
    for (const MeshVertex& vertex : meshBranches(tree, index, Widths(tree, index)).vertices)
        QVERIFY2(vertex.position[1] >= 0.0F, qPrintable(QString::number(vertex.position[1])));
    const MeshBuffer<LeafInstance> leaves = placeLeaves(tree, index, Widths(tree, index));
    for (const MeshVertex& vertex : expandLeaves(leaves).vertices)
        QVERIFY2(vertex.position[1] > -1e-5F, qPrintable(QString::number(vertex.position[1])));
    // Few leaves are hidden because of that.
    const auto hidden = std::ranges::count_if(leaves, [](const LeafInstance& l) { return l.length <= 0.0F; });
    QVERIFY2(50 * hidden <= static_cast<std::ptrdiff_t>(leaves.size()), qPrintable(QString::number(hidden)));
}

void SampleRecipesTest::historyOfAPlayedRecipe_isARecipeOfTheSameTree_data()
{
    undoingAndRedoingAll_restoresTheDocument_data();
}

void SampleRecipesTest::historyOfAPlayedRecipe_isARecipeOfTheSameTree()
{
    QFETCH(const QString, fileName);
    const Result<Recipe> recipe = readRecipe(fileName);
    QVERIFY2(recipe, qPrintable(recipe ? QString() : recipe.error().message));
    TreeDocument document;
    RecipePlayer(document, *recipe).playAll();
    QCOMPARE(replayFault(document), QString());
}

const TestClass<SampleRecipesTest> sampleRecipesTest;

} // namespace espalier::test

#include "SampleRecipesTest.moc"
