// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/JournalRecipe.h"

#include "commands/AddBuds.h"
#include "commands/BendGesture.h"
#include "commands/BrushGesture.h"
#include "commands/DocumentProject.h"
#include "commands/EraseTwigs.h"
#include "commands/KeepClear.h"
#include "commands/LassoGesture.h"
#include "commands/ParameterGesture.h"
#include "commands/PlaceLeaves.h"
#include "commands/Prune.h"
#include "commands/SetParameters.h"
#include "commands/TimeGesture.h"
#include "commands/TwistGesture.h"
#include "commands/WidthGesture.h"
#include "commands/recipe/RecipeFile.h"
#include "commands/recipe/RecipePlayer.h"
#include "model/document/HistorySnapshot.h"
#include "model/io/ParametersJson.h"
#include "tests/support/AllOperations.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/OwnImages.h"
#include "tests/support/PlacedLeaves.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>
#include <functional>

using namespace espalier;
using namespace espalier::test;

using Action = std::function<void(TreeDocument&)>;
Q_DECLARE_METATYPE(Action)

/// What gestures leave in the journal makes a recipe that does the same again, to the last bit.
class JournalRecipeTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void gesture_isPlayedAgain_data();
    void gesture_isPlayedAgain();
    void recipe_namesWhatWasDone();
    void editCutInItsMiddle_isPlayedAgain();
    void momentInThePast_isPlayedAgain();
    void undone_isNotInTheRecipe();
    void records_areInTheProjectFile();
    void stepsWithoutRecord_areCountedInTheError();
    void cutEditBeforeUnrecordedSteps_doesNotHideThem();
    void shortenedHistory_isNotARecipe();
    void wrongRecord_isNamedWithItsStep();
    void ownImages_lieBesideTheRecipe();
    void anotherFileInAnImagesPlace_isNotReplaced();
};

namespace {

/// A tree with branches, made in ways that are recorded.
void plant(TreeDocument& document)
{
    TreeParameters parameters;
    parameters.growth.internodeLength = 0.1;
    parameters.growth.lateralsPerNode = 2;
    document.reset(3, parameters);
    brush(document,
          strokeAlong(std::vector<Vec3>{Vec3::Zero(), Vec3(0.1F, 1.2F, 0.0F), Vec3(0.5F, 2.0F, 0.3F)}, 0.3F,
                      1.5));
}

/// The living internode that is farthest from the base of the tree.
InternodeId farthest(const TreeDocument& document)
{
    InternodeId best = 0;
    for (InternodeId id = 0; id < document.tree().size(); ++id) {
        if (document.tree().isAlive(id) && document.index().nodePosition(id).squaredNorm() >
                                               document.index().nodePosition(best).squaredNorm())
            best = id;
    }
    return best;
}

LassoStroke lasso(float size, float up = 0.6F)
{
    LassoStroke stroke;
    stroke.origin = Vec3(-0.0F, up, 0.0F);
    stroke.points = {{-size, 0.0F}, {0.0F, 0.05F}, {size, 0.05F}, {size, size}, {-0.0F, size}, {-size, size}};
    return stroke;
}

void fill(LassoGesture::Begun begun, int steps)
{
    QVERIFY(begun);
    for (int i = 0; i < steps && (*begun)->step(); ++i) {
    }
    (*begun)->finish();
}

constexpr int kToTheEnd = 10'000;

Competitors branchOf(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    for (InternodeId id = 1; id < tree.size(); ++id) {
        if (tree.isAlive(id) && !tree.continuesAxis(id))
            return {id, kTerminalSlot};
    }
    return {};
}

QStringList operationsOf(const TreeDocument& document)
{
    QStringList names;
    const Result<Recipe> recipe = recipeOf(projectOf(document, {}));
    if (!recipe)
        return {recipe.error().message};
    for (const RecipeOperation& operation : recipe->operations)
        names.append(operation.name());
    return names;
}

} // namespace

void JournalRecipeTest::gesture_isPlayedAgain_data()
{
    QTest::addColumn<Action>("act");
    const auto row = [](const char* name, const Action& act) { QTest::newRow(name) << act; };
    row("strokes", [](TreeDocument& document) {
        Random random(5, 0, 0, Purpose::ShootLength);
        for (int i = 0; i < 4; ++i)
            brush(document, randomStroke(random, document.parameters().growth, 0.6));
        // A mirrored stroke has negative zeros.
        brush(document,
              strokeAlong(std::vector<Vec3>{Vec3(-0.0F, 1.0F, -0.0F), Vec3(-0.0F, 1.5F, -0.0F)}, 0.2F, 0.5));
    });
    row("stroke of one branch", [](TreeDocument& document) {
        brush(document, strokeAlong(std::vector<Vec3>{Vec3(0.1F, 1, 0), Vec3(0.6F, 1.4F, 0)}, 0.4F, 1.0),
              branchOf(document));
    });
    row("stroke broken off between two samples", [](TreeDocument& document) {
        BrushGesture gesture(document, {0.0, Vec3(0.3F, 1.3F, 0.1F), 0.3F});
        gesture.add({0.21, Vec3(0.35F, 1.5F, 0.12F), 0.31F});
        gesture.moveToward({1.7, Vec3(0.7F, 2.1F, 0.3F), 0.37F}, 0.5);
        gesture.moveToward({1.7, Vec3(0.7F, 2.1F, 0.3F), 0.37F}, 0.9);
        gesture.finish();
    });
    row("stroke that another edit interrupts", [](TreeDocument& document) {
        BrushGesture gesture(document, {0.0, Vec3(0.3F, 1.3F, 0.1F), 0.3F});
        gesture.add({0.7, Vec3(0.35F, 1.5F, 0.12F), 0.31F});
        grow(document, 1);
    });
    row("growth", [](TreeDocument& document) { grow(document, 4); });
    row("growth of one branch", [](TreeDocument& document) { grow(document, 4, branchOf(document)); });
    row("growth beyond the present", [](TreeDocument& document) {
        TimeGesture gesture(document);
        gesture.moveTo(document.journal().size() + 3);
        gesture.moveTo(document.journal().size() - 1);
        gesture.finish();
    });
    row("prune", [](TreeDocument& document) {
        const InternodeId tip = farthest(document);
        pruneBranches(document, std::array{tip, InternodeId{0}, document.tree().parent(tip), tip,
                                           document.tree().size() + 7});
        grow(document, 2);
    });
    row("bend at once", [](TreeDocument& document) {
        const InternodeId end = farthest(document);
        BendGesture gesture(document, 0, {{end, 0.7}}, {.stretching = 3.0, .bending = 0.7});
        gesture.settleAt(std::array{Vec3(-0.8F, 1.1F, -0.0F)});
        gesture.finish();
    });
    row("bend by hands that come and go", [](TreeDocument& document) {
        const InternodeId end = farthest(document);
        const InternodeId middle = pathBetween(document.tree(), 0, end)[5];
        BendGesture gesture(document, 0, {{document.tree().size() + 3, 1.0}, {end, 1.0}});
        const Vec3 from = gesture.gripPoints()[1];
        for (int i = 1; i < 20; ++i)
            gesture.moveTo(std::array{Vec3(Vec3::Ones()),
                                      Vec3(from + 0.02F * static_cast<float>(i) * Vec3(1, -1, 0.3F))});
        gesture.regrip(0, {{end, 1.0}, {middle, 0.25}});
        const std::vector<Vec3> grips = gesture.gripPoints();
        for (int i = 1; i < 9; ++i)
            gesture.moveTo(std::array{Vec3(grips[0] + Vec3(0, 0.03F * static_cast<float>(i), 0)), grips[1]});
        gesture.moveTo(std::array{grips[0], grips[1]});
        gesture.moveTo(std::array{grips[0], grips[1]});
        gesture.regrip(end, {{end, 1.0}}); // holds nothing
        gesture.regrip(middle, {{end, 0.5}});
        gesture.settleAt(std::array{Vec3(0.1F, 0.9F, 0.4F)});
        gesture.finish();
        grow(document, 1);
    });
    row("width", [](TreeDocument& document) {
        const InternodeId end = farthest(document);
        const std::vector<InternodeId> path = pathBetween(document.tree(), 0, end);
        setWidth(document, path[2], 0.0777);
        setWidth(document, path[6], 1e-9);
        WidthGesture moved(document, path[2]);
        moved.set(path[3], 0.05);
        moved.set(path[4], 0.051);
        moved.finish();
        WidthGesture ontoAnother(document, path[4]);
        ontoAnother.set(path[6], 0.03);
        ontoAnother.finish();
        setWidth(document, path[6], 0.0);
    });
    row("twist", [](TreeDocument& document) {
        const std::vector<InternodeId> path = pathBetween(document.tree(), 0, farthest(document));
        TwistGesture gesture(document, path[2], TwistScope::Branch);
        gesture.set(90.0);
        gesture.set(12.3456);
        gesture.finish();
        twistBranch(document, path[3], TwistScope::Subtree, -33.3);
        twistBranch(document, path[5], TwistScope::Branch, 0.0);
        grow(document, 1);
    });
    row("new buds", [](TreeDocument& document) {
        const std::vector<InternodeId> path = pathBetween(document.tree(), 0, farthest(document));
        pruneBranches(document, std::array{path[5]});
        QCOMPARE(addBuds(document,
                         {.internode = path[3], .along = 0.3, .azimuth = 77.7, .count = 6, .spacing = 0.05}),
                 6);
        QCOMPARE(addBuds(document,
                         {.internode = path[3], .along = 0.3, .azimuth = 77.7, .count = 6, .spacing = 0.05}),
                 6);
        grow(document, 3);
        QCOMPARE(addBuds(document, {.internode = 0, .count = 8, .spacing = 1.0}), 8);
        grow(document, 2);
    });
    row("a stroke around the trunk", [](TreeDocument& document) {
        const Vec3 trunk(0.0F, 0.25F, 0.0F);
        const std::vector<Vec3> way{trunk, trunk + Vec3(0.2F, 0.1F, 0.05F)};
        for (const float radius : {0.0F, 0.1F}) {
            const std::vector<BrushSample> samples = strokeAlong(way, radius, 0.6);
            BrushGesture gesture(document, samples.front(), {}, StrokeEnd::Arrives,
                                 {.around = trunk, .copies = 3, .isSpread = true});
            for (const BrushSample& sample : samples)
                gesture.add(sample);
            gesture.finish();
        }
    });
    row("kept clear", [](TreeDocument& document) {
        const InternodeId tip = farthest(document);
        QVERIFY(keepClear(document, tip, 0.21F));
        grow(document, 2);
        QVERIFY(keepClear(document, tip, 0.13F));
        grow(document, 2);
        QVERIFY(keepClear(document, tip, 0.0F));
        grow(document, 1);
    });
    row("erased and thinned", [](TreeDocument& document) {
        const Vec3 tip = document.index().nodePosition(farthest(document));
        SweptTwigs twigs{.sweeps = {{Vec3(0.0F, 0.5F, 4.0F), {{tip, 0.1F}, {0.5F * tip, 0.2F}}}},
                         .thickest = 1.0};
        QVERIFY(thinTwigs(document, {twigs, 0.5}));
        twigs.depth = SweepDepth::NearSide;
        twigs.sweeps.push_back({Vec3(4.0F, 0.123F, 0.0F), {{tip, 0.07F}}});
        eraseTwigs(document, {twigs});
        grow(document, 2);
    });
    row("placed leaves", [](TreeDocument& document) {
        const std::vector<InternodeId> path = pathBetween(document.tree(), 0, farthest(document));
        QVERIFY(placeLeaf(document, leafAround(path[4], 0.25F, 0.3, 0.0777F)));
        QVERIFY(placeLeaf(document, leafAround(path[4], 0.25F, 2.1, 0.1F)));
        QVERIFY(arrangeLeaves(document, LeafEngine::AddToWhorl, {path[4], 0.3F}));
        grow(document, 1);
        QVERIFY(arrangeLeaves(document, LeafEngine::AddToWhorl, {path[4], 0.3F}));
        pruneBranches(document, std::array{path[3]});
    });
    row("parameters", [](TreeDocument& document) {
        TreeParameters parameters = document.parameters();
        parameters.growth.branchingAngle = radians(40.81);
        parameters.leaves.shape = LeafShape::Lobed;
        setParameters(document, parameters);
        ParameterGesture gesture(document);
        for (const double angle : {45.0, 51.3, 62.9}) {
            parameters.growth.branchingAngle = radians(angle);
            gesture.tryOut(parameters, QStringLiteral("Angle"));
        }
        gesture.finish();
        grow(document, 2);
        Random random(8, 0, 0, Purpose::ShootLength);
        parameters = randomParameters(random); // a species
        parameters.growth.phyllotaxis = radians(137.5);
        normaliseDirectionWeights(parameters.growth);
        setParameters(document, parameters);
        grow(document, 1);
    });
    row("lassos", [](TreeDocument& document) {
        fill(LassoGesture::fill(document, lasso(0.5F)), kToTheEnd);
        fill(LassoGesture::fill(document, lasso(0.4F, 1.5F)), 3);
        fill(LassoGesture::fill(document, lasso(0.3F, 0.2F)), 0);
        QVERIFY(removeEnvelopes(document));
        fill(LassoGesture::fill(document, lasso(0.7F), branchOf(document)), 2);
    });
    row("filling goes on", [](TreeDocument& document) {
        fill(LassoGesture::fill(document, lasso(0.6F)), 2);
        TreeParameters parameters = document.parameters();
        parameters.growth.apicalDominance = 0.44;
        setParameters(document, parameters);
        fill(LassoGesture::goOn(document), 2);
        fill(LassoGesture::goOn(document, branchOf(document)), kToTheEnd);
    });
    row("regrow", [](TreeDocument& document) {
        fill(LassoGesture::fill(document, lasso(0.5F)), 3);
        pruneBranches(document, std::array{farthest(document)});
        fill(LassoGesture::fill(document, lasso(0.3F, 1.4F)), 4);
        TreeParameters parameters = document.parameters();
        parameters.growth.apicalDominance = 0.44;
        setParameters(document, parameters);
        fill(LassoGesture::regrow(document), 2);
        grow(document, 1);
        parameters.growth.apicalDominance = 0.47;
        setParameters(document, parameters);
        fill(LassoGesture::regrow(document), kToTheEnd);
    });
    row("the same lasso before and after its removal, regrown", [](TreeDocument& document) {
        fill(LassoGesture::fill(document, lasso(0.4F)), 1);
        QVERIFY(removeEnvelopes(document));
        fill(LassoGesture::fill(document, lasso(0.4F)), 1);
        fill(LassoGesture::fill(document, lasso(0.4F)), 1);
        fill(LassoGesture::regrow(document), 2);
    });
    row("a recipe that is played", [](TreeDocument& document) {
        Recipe recipe;
        recipe.seed = 12;
        recipe.operations = {GrowOperation{6},
                             UndoOperation{1},
                             RedoOperation{1},
                             GrowOperation{2},
                             TravelOperation{-4},
                             PruneOperation{{3U, 9U}},
                             BendOperation{.base = 0, .handles = {{4U, 0.5, Vec3(0.3F, 0.4F, -0.2F)}}}};
        RecipePlayer player(document, recipe);
        player.playAll();
    });
}

void JournalRecipeTest::gesture_isPlayedAgain()
{
    QFETCH(const Action, act);
    TreeDocument document;
    plant(document);
    const std::size_t before = document.journal().size();
    act(document);
    QVERIFY(document.journal().size() != before || document.undoStack().index() != 1);
    QCOMPARE(replayFault(document), QString());
}

void JournalRecipeTest::recipe_namesWhatWasDone()
{
    TreeDocument document;
    plant(document);
    document.setCompetitors(branchOf(document));
    grow(document, 2, document.competitors());
    pruneBranches(document, std::array{farthest(document)});
    const Result<Recipe> recipe = recipeOf(projectOf(document, QStringLiteral("Ash")));
    QVERIFY2(recipe, recipe ? "" : qPrintable(recipe.error().message));
    QCOMPARE(recipe->name, QStringLiteral("Ash"));
    QCOMPARE(recipe->seed, std::uint64_t{3});
    QCOMPARE(recipe->operations.size(), std::size_t{3});
    const auto* stroke = recipe->operations[0].as<BrushStrokeOperation>();
    QVERIFY(stroke);
    QCOMPARE(stroke->samples.size(), std::size_t{91});
    const auto* growth = recipe->operations[1].as<GrowOperation>();
    QVERIFY(growth);
    QCOMPARE(growth->steps, 2);
    QVERIFY(growth->only.internode.has_value());
    const auto* cut = recipe->operations[2].as<PruneOperation>();
    QVERIFY(cut);
    // By key and place: so a change of an earlier step does not lead the recipe astray.
    QVERIFY(!cut->internodes.front().isNumber());
}

void JournalRecipeTest::editCutInItsMiddle_isPlayedAgain()
{
    TreeDocument document;
    plant(document);
    grow(document, 5);
    const std::size_t whole = document.journal().size();
    travel(document, whole - 2);
    setWidth(document, 1, 0.05);
    travel(document, 4); // in the middle of the stroke
    grow(document, 3);
    QCOMPARE(operationsOf(document),
             (QStringList{QStringLiteral("brushStroke"), QStringLiteral("travel"), QStringLiteral("grow")}));
    QCOMPARE(replayFault(document), QString());
}

void JournalRecipeTest::momentInThePast_isPlayedAgain()
{
    TreeDocument document;
    plant(document);
    grow(document, 5);
    TreeParameters parameters = document.parameters();
    parameters.growth.apicalDominance = 0.44;
    setParameters(document, parameters);
    travel(document, document.journal().size() - 3);
    QVERIFY(!document.future().empty());
    QCOMPARE(replayFault(document), QString());
    travel(document, 0);
    QCOMPARE(replayFault(document), QString());
}

void JournalRecipeTest::undone_isNotInTheRecipe()
{
    TreeDocument document;
    plant(document);
    grow(document, 2);
    document.undo();
    QCOMPARE(operationsOf(document), QStringList{QStringLiteral("brushStroke")});
    document.redo();
    QCOMPARE(operationsOf(document), (QStringList{QStringLiteral("brushStroke"), QStringLiteral("grow")}));
    QCOMPARE(replayFault(document), QString());
}

void JournalRecipeTest::records_areInTheProjectFile()
{
    TreeDocument document;
    plant(document);
    grow(document, 2);
    const Result<QByteArray> file = packProject(projectOf(document, QStringLiteral("Tree")));
    QVERIFY(file);
    Result<Project> project = unpackProject(*file);
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    TreeDocument opened;
    showProject(opened, std::move(*project));
    QCOMPARE(differenceFrom(DocumentState(document), opened), QString());
    grow(opened, 1);
    QCOMPARE(replayFault(opened), QString());
}

void JournalRecipeTest::stepsWithoutRecord_areCountedInTheError()
{
    TreeDocument document;
    plant(document);
    Project project = projectOf(document, QStringLiteral("Old"));
    const auto strip = [](Journal& journal) {
        for (auto& delta : journal) {
            delta = std::make_shared<TreeDelta>(*delta);
            delta->record.reset();
        }
    };
    strip(project.journal);
    const std::size_t old = project.journal.size();
    TreeDocument opened;
    showProject(opened, project);
    grow(opened, 2);
    const Result<Recipe> recipe = recipeOf(projectOf(opened, {}));
    QVERIFY(!recipe);
    QVERIFY2(
        recipe.error().message.contains(QStringLiteral("of its %1 steps, %2 (1–%2)").arg(old + 2).arg(old)),
        qPrintable(recipe.error().message));
}

void JournalRecipeTest::cutEditBeforeUnrecordedSteps_doesNotHideThem()
{
    TreeDocument document;
    plant(document);
    travel(document, 4);
    // An edit that no gesture made, and so no record tells of.
    Edit edit(document);
    TreeDelta delta = deltaStartingAt(document.tree());
    delta.sparse.width.push_back({0, {}, 0.1F});
    edit.apply(std::move(delta));
    edit.commit(QStringLiteral("Test"));
    const Result<Recipe> recipe = recipeOf(projectOf(document, {}));
    QVERIFY(!recipe);
    QVERIFY2(recipe.error().message.contains(QStringLiteral("of its 5 steps, 1 (5)")),
             qPrintable(recipe.error().message));
}

void JournalRecipeTest::shortenedHistory_isNotARecipe()
{
    // What is left begins with one internode, but not as it was sown.
    TreeDocument document;
    setWidth(document, 0, 0.05F);
    grow(document, 3);
    std::optional<ShortenedHistory> shortened = HistorySnapshot(document).without(1);
    QVERIFY(shortened);
    QVERIFY(document.shorten(*shortened));
    const Result<Recipe> recipe = recipeOf(projectOf(document, {}));
    QVERIFY(!recipe);
    QVERIFY2(recipe.error().message.contains(QStringLiteral("oldest steps were dropped")),
             qPrintable(recipe.error().message));
}

void JournalRecipeTest::wrongRecord_isNamedWithItsStep()
{
    TreeDocument document;
    plant(document);
    grow(document, 1);
    Project project = projectOf(document, {});
    for (const char* operation :
         {R"({"op":"grow","steps":0})", R"({"op":"dance"})", R"({"op":"grow","steps":1,"more":2})", "{}"}) {
        auto last = std::make_shared<TreeDelta>(*project.journal.back());
        last->record = std::make_shared<const EditRecord>(EditRecord{operation, 1});
        project.journal.back() = last;
        const Result<Recipe> recipe = recipeOf(project);
        QVERIFY(!recipe);
        const QString step = QStringLiteral("step %1 of the history").arg(project.journal.size());
        QVERIFY2(recipe.error().message.contains(step), qPrintable(recipe.error().message));
    }
}

void JournalRecipeTest::ownImages_lieBesideTheRecipe()
{
    const ImageAsset leaf(pngOf(drawnLeaf(Qt::transparent)), QStringLiteral("../My leaf/né?.png"));
    const ImageAsset bark(pngOf(repeatingBark(16, 16)), QStringLiteral("bark.png"));
    TreeDocument document;
    TreeParameters parameters;
    parameters.bark.image = bark;
    document.reset(4, parameters);
    grow(document, 3);
    parameters.leaves.image = leaf;
    parameters.leaves.aspect = 0.77;
    setParameters(document, parameters);

    const QTemporaryDir folder;
    const QString fileName = folder.filePath(QStringLiteral("ash.json"));
    const Result<Recipe> recipe = recipeOf(projectOf(document, QStringLiteral("Ash")));
    QVERIFY(recipe);
    for (int i = 0; i < 2; ++i) { // the second time over the first
        const Result<void> saved = saveRecipe(*recipe, fileName);
        QVERIFY2(saved, saved ? "" : qPrintable(saved.error().message));
        QCOMPARE(QDir(folder.path()).entryList(QDir::Files).size(), 3);
        const Result<Recipe> read = readRecipe(fileName);
        QVERIFY2(read, read ? "" : qPrintable(read.error().message));
        TreeDocument again;
        RecipePlayer(again, *read).playAll();
        QVERIFY(again.tree() == document.tree());
    }
}

void JournalRecipeTest::anotherFileInAnImagesPlace_isNotReplaced()
{
    const ImageAsset bark(pngOf(repeatingBark(16, 16)), QStringLiteral("bark.png"));
    Recipe recipe;
    recipe.parameters.bark.image = bark;
    const QTemporaryDir folder;
    QFile other(folder.filePath(bark.hash().left(8) + QStringLiteral("-bark.png")));
    QVERIFY(other.open(QIODevice::WriteOnly));
    other.write("mine");
    other.close();
    const Result<void> saved = saveRecipe(recipe, folder.filePath(QStringLiteral("ash.json")));
    QVERIFY(!saved);
    QVERIFY2(saved.error().message.contains(QStringLiteral("bark.png")), qPrintable(saved.error().message));
    QVERIFY(!QFile::exists(folder.filePath(QStringLiteral("ash.json"))));
    QCOMPARE(other.size(), 4);
}

static const TestClass<JournalRecipeTest> journalRecipeTest;

#include "JournalRecipeTest.moc"
