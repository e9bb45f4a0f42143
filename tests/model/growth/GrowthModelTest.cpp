// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthModel.h"

#include "commands/GrowGesture.h"
#include "commands/GrowthReplica.h"
#include "commands/SetParameters.h"
#include "commands/performances/RecipeReplica.h"
#include "commands/recipe/Recipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/document/EditFollower.h"
#include "model/document/PreparedTree.h"
#include "model/growth/SelfOrganisingModel.h"
#include "model/growth/VigourModel.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

/// A document grows by the model that its parameters in force name.
class GrowthModelTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void document_growsByTheModelThatItsParametersName();
    void switchedModels_growOnFromEachOthersTree();
    void switchedModels_areUndone();
    void travels_bringTheModelBack();
    void readDocument_growsByTheModelOfItsFile();
    void growthReplica_growsByTheModelOfItsTree();
    void recipe_changesTheModelInTheMiddle();
};

namespace {

void setModel(TreeDocument& document, GrowthModelKind kind)
{
    TreeParameters parameters = document.parameters();
    parameters.growth.model = kind;
    parameters.vigour.growthRate = 0.8;
    parameters.vigour.internodeLength = 0.1;
    setParameters(document, parameters);
}

/// The step that @p model makes of the document's tree.
TreeDelta stepOf(const TreeDocument& document, std::unique_ptr<GrowthModel> model)
{
    model->rebuild(document.tree(), document.index());
    model->settle(document.tree(), document.index());
    GrowthWorkspace workspace;
    return model->growFreely(document.tree(), document.index(),
                             GrowthStepOptions::of(document.parameters().growth), workspace);
}

/// The model that makes the same next step of the tree as the document does.
GrowthModelKind modelOf(const TreeDocument& document)
{
    GrowthWorkspace workspace;
    const TreeDelta delta = document.growthModel().growFreely(
        document.tree(), document.index(), GrowthStepOptions::of(document.parameters().growth), workspace);
    const bool isVigour = delta == stepOf(document, std::make_unique<VigourModel>());
    const bool isTreeSketch = delta == stepOf(document, std::make_unique<SelfOrganisingModel>());
    if (isVigour == isTreeSketch)
        qFatal("the step is that of both models, or of none");
    return isVigour ? GrowthModelKind::Vigour : GrowthModelKind::TreeSketch;
}

} // namespace

void GrowthModelTest::document_growsByTheModelThatItsParametersName()
{
    TreeDocument document;
    growAtRandom(document, 4, 30, 80);
    QCOMPARE(modelOf(document), GrowthModelKind::TreeSketch);
    setModel(document, GrowthModelKind::Vigour);
    QCOMPARE(modelOf(document), GrowthModelKind::Vigour);
    document.undo();
    QCOMPARE(modelOf(document), GrowthModelKind::TreeSketch);
    document.redo();
    QCOMPARE(modelOf(document), GrowthModelKind::Vigour);
    document.reset(4);
    QCOMPARE(modelOf(document), GrowthModelKind::TreeSketch);
}

void GrowthModelTest::switchedModels_growOnFromEachOthersTree()
{
    TreeDocument document;
    growAtRandom(document, 5, 30, 80);
    for (const GrowthModelKind kind :
         {GrowthModelKind::Vigour, GrowthModelKind::TreeSketch, GrowthModelKind::Vigour}) {
        setModel(document, kind);
        const std::uint32_t before = document.tree().size();
        QVERIFY(grow(document, 8) > 0);
        QVERIFY(document.tree().size() > before);
        QCOMPARE(indexFault(document), QString());
    }
    QCOMPARE(replayFault(document), QString());
}

void GrowthModelTest::switchedModels_areUndone()
{
    TreeDocument document;
    growAtRandom(document, 6, 30, 80);
    const DocumentState start(document);
    const int commands = document.undoStack().count();
    grow(document, 1);
    setModel(document, GrowthModelKind::Vigour);
    grow(document, 5);
    setModel(document, GrowthModelKind::TreeSketch);
    grow(document, 2);
    const DocumentState done(document);
    while (document.undoStack().index() > commands)
        document.undo();
    QCOMPARE(differenceFrom(start, document), QString());
    while (document.undoStack().canRedo())
        document.redo();
    QVERIFY(DocumentState(document) == done);
}

void GrowthModelTest::travels_bringTheModelBack()
{
    TreeDocument document;
    growAtRandom(document, 7, 30, 80);
    const std::size_t before = document.journal().size();
    setModel(document, GrowthModelKind::Vigour);
    grow(document, 5);
    const std::size_t after = document.journal().size();
    travel(document, before);
    QCOMPARE(modelOf(document), GrowthModelKind::TreeSketch);
    travel(document, after);
    QCOMPARE(modelOf(document), GrowthModelKind::Vigour);
}

void GrowthModelTest::readDocument_growsByTheModelOfItsFile()
{
    TreeDocument document;
    growAtRandom(document, 8, 30, 80);
    setModel(document, GrowthModelKind::Vigour);
    grow(document, 3);
    TreeDocument other;
    other.reset(PreparedTree(document.tree(), document.journal()));
    QCOMPARE(modelOf(other), GrowthModelKind::Vigour);
    grow(document, 4);
    grow(other, 4);
    QVERIFY(other.tree() == document.tree());
}

void GrowthModelTest::growthReplica_growsByTheModelOfItsTree()
{
    for (const GrowthModelKind kind : {GrowthModelKind::Vigour, GrowthModelKind::TreeSketch}) {
        TreeDocument document;
        growAtRandom(document, 9, 20, 50);
        setModel(document, kind);
        const Tree before = document.tree();
        GrowGesture gesture(document);
        GrowthReplica replica(before, document.freshGrowthModel(), gesture.takeProcess());
        GrownStep step = replica.grow();
        QVERIFY(step.delta == (kind == GrowthModelKind::Vigour
                                   ? stepOf(document, std::make_unique<VigourModel>())
                                   : stepOf(document, std::make_unique<SelfOrganisingModel>())));
    }
}

void GrowthModelTest::recipe_changesTheModelInTheMiddle()
{
    const Result<Recipe> recipe = parseRecipe(R"({"espalier-recipe": 1, "operations": [
        {"op": "grow", "steps": 6},
        {"op": "setParameters", "parameters": {"growth": {"model": "vigour"},
                                               "vigour": {"growthRate": 0.8, "internodeLength": 0.1}}},
        {"op": "grow", "steps": 20},
        {"op": "setParameters", "parameters": {"growth": {"model": "treesketch"}}},
        {"op": "grow", "steps": 2}]})");
    QVERIFY(recipe);
    TreeDocument document;
    RecipePlayer player(document, *recipe);
    while (!player.isDone())
        player.advance(std::numeric_limits<double>::infinity());
    QCOMPARE(player.warnings(), QStringList());
    bool hasLengthened = false;
    for (const auto& delta : document.journal())
        hasLengthened = hasLengthened || !delta->internodes.length.empty();
    QVERIFY(hasLengthened);

    // The same on another thread, as the window plays it.
    TreeDocument follower;
    follower.reset(recipe->seed, recipe->parameters);
    RecipeReplica replica(*recipe);
    EditFollower following(follower);
    for (bool isDone = false; !isDone;) {
        RecipePart part = replica.advance(1.0, std::chrono::milliseconds(0));
        isDone = part.moment.isDone;
        following.add(std::move(part.events));
        while (following.advance(std::chrono::milliseconds(5))) {
        }
    }
    QVERIFY(follower.tree() == document.tree());
    QCOMPARE(modelOf(follower), GrowthModelKind::TreeSketch);
    follower.undo();
    follower.undo();
    QCOMPARE(modelOf(follower), GrowthModelKind::Vigour);
}

const TestClass<GrowthModelTest> growthModelTest;

} // namespace espalier::test

#include "GrowthModelTest.moc"
