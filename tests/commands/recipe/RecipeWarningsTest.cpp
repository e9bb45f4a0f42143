// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"
#include "model/strands/ProfileShapes.h"
#include "tests/support/AllOperations.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

namespace espalier::test {

/// Operations that find nothing to do in the tree, or not all that they name, give a warning with their
/// place.
class RecipeWarningsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsNotThere_isNamed_data();
    void whatIsNotThere_isNamed();
    void whatCanBeDone_bringsNoWarning();
    void everyKind_isTried();
    void restOfTheOperation_isDone();
    void manyFaults_areCounted();
    void places_areThoseInTheRecipe();
    void bendBeyondTheBranch_namesTheHandle();
    void budThatHasGrown_isStillThere();
    void parametersThatFindNoRoom_areNamed();
};

namespace {

constexpr InternodeId kMissing = 700;

/// A recipe for the operations: an upright axis of internodes 0, 1, 2, … in a document with two undo steps.
Recipe axisRecipe()
{
    Recipe recipe;
    recipe.parameters.growth.shedding = 0.0;
    BrushStrokeOperation stroke;
    stroke.samples = {{0.0, Vec3::Zero(), 0.0F}, {1.5, Vec3(0.0F, 1.5F, 0.0F), 0.0F}};
    recipe.operations = {stroke, SetWidthOperation{1U, 0.05}};
    return recipe;
}

struct Case {
    const char* name;
    RecipeOperation operation;
    QString warning; ///< After the place; empty if the operation can be done
};

BrushStrokeOperation strokeOf(BudReference only)
{
    return {{{0.0, Vec3(0.0F, 1.0F, 0.0F), 0.4F}, {1.0, Vec3(0.5F, 1.5F, 0.0F), 0.4F}}, only};
}

LassoOperation lassoOf(BudReference only)
{
    return {{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{-0.5F, 1.0F}, {0.5F, 1.0F}, {0.0F, 2.0F}}}, only};
}

SketchStrokeOperation branchOn(std::optional<InternodeReference> on)
{
    return {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0, 1}, {1, 2}}}, .on = std::move(on)};
}

/// A brush of @p radius, m, beside the tree.
SweptTwigs sweptFromTheFront(float radius)
{
    return {.sweeps = {{Vec3(0.0F, 1.0F, 10.0F), {{Vec3(5.0F, 1.0F, 0.0F), radius}}}}, .thickest = 1.0};
}

std::vector<Case> cases()
{
    const QString missing = QStringLiteral("there is no internode 700");
    const QString none = QStringLiteral("there is no internode 4294967294");
    const BudReference missingNode{kMissing, 0};
    const BudReference missingBud{3U, 5};
    const QString noBud = QStringLiteral("internode 3 has no bud 5");
    const BendOperation bend{.base = 0, .handles = {{4, 1.0, Vec3(0.2F, 0.3F, 0.0F)}}};
    BendOperation baseMissing = bend;
    baseMissing.base = kMissing;
    BendOperation handleMissing = bend;
    handleMissing.handles[0].internode = kMissing;
    BendOperation handleBelow = bend;
    handleBelow.base = 6;
    TreeParameters other;
    other.growth.apicalDominance = 0.3;
    return {
        {"setParameters", SetParametersOperation{other}, {}},
        {"setParameters that are in force", SetParametersOperation{axisRecipe().parameters}, {}},
        {"brushStroke", strokeOf({}), {}},
        {"brushStroke of a missing internode", strokeOf(missingNode), missing},
        {"brushStroke of a missing bud", strokeOf(missingBud), noBud},
        {"brushStroke that rests for no time", BrushStrokeOperation{{{0.0, Vec3::Zero(), 0.5F}}},
         QStringLiteral("nothing grew")},
        {"grow", GrowOperation{2}, {}},
        {"grow of a missing internode", GrowOperation{2, missingNode}, missing},
        {"grow of a missing bud", GrowOperation{2, missingBud}, noBud},
        {"prune", PruneOperation{{5U}}, {}},
        {"prune of what is not there", PruneOperation{{kMissing}}, missing},
        {"prune of a number that no tree has",
         PruneOperation{{InternodeId(InternodeReference::kGreatestNumber)}}, none},
        {"prune of the seedling", PruneOperation{{0U}},
         QStringLiteral("internode 0 is a root, which cannot be pruned")},
        {"invigorate", InvigorateOperation{5U, 0.4}, {}},
        {"invigorate of what is not there", InvigorateOperation{kMissing, 0.4}, missing},
        {"reduce", ReduceOperation{5U, 0.3}, {}},
        {"reduce of what is not there", ReduceOperation{kMissing, 0.3}, missing},
        {"travel", TravelOperation{-1}, {}},
        {"travel beyond the beginning", TravelOperation{-1'000'000},
         QStringLiteral("the history goes back only by ")},
        {"travel beyond the end", TravelOperation{3},
         QStringLiteral("the history goes on only by 0, not by 3")},
        {"undo", UndoOperation{2}, {}},
        {"undo of more than there is", UndoOperation{7},
         QStringLiteral("there are only 2 commands to undo, not 7")},
        {"redo of more than there is", RedoOperation{1},
         QStringLiteral("there are only 0 commands to redo, not 1")},
        {"bend", bend, {}},
        {"bend from what is not there", baseMissing, missing},
        {"bend of what is not there", handleMissing, missing},
        {"bend of what is not above the base", handleBelow,
         QStringLiteral("internode 4 is not on the branch above internode 6")},
        {"setWidth", SetWidthOperation{2U, 0.04}, {}},
        {"setWidth that takes away", SetWidthOperation{1U, 0.0}, {}},
        {"twist", TwistOperation{2U, 20.0}, {}},
        {"twist of what is not there", TwistOperation{kMissing, 20.0}, missing},
        {"twist that takes nothing away", TwistOperation{2U, 0.0},
         QStringLiteral("internode 2 has no twist to take away")},
        {"addBuds", AddBudsOperation{.internode = 3U}, {}},
        {"addBuds on what is not there", AddBudsOperation{.internode = kMissing}, missing},
        {"keepClear", KeepClearOperation{3U, 0.1F}, {}},
        {"keepClear of what is not there", KeepClearOperation{kMissing, 0.1F}, missing},
        {"keepClear that changes nothing", KeepClearOperation{3U, 0.0F},
         QStringLiteral("the branch of internode 3 is already kept clear that far")},
        {"erase", EraseOperation{sweptFromTheFront(100.0F)}, {}},
        {"erase beside the tree", EraseOperation{sweptFromTheFront(0.0F)},
         QStringLiteral("nothing under the brush could be erased")},
        {"thin where there is a trunk alone", ThinOperation{sweptFromTheFront(100.0F), 1.0},
         QStringLiteral("there were no twigs under the brush to take")},
        {"placeLeaf", PlaceLeafOperation{.internode = 3U}, {}},
        {"placeLeaf on what is not there", PlaceLeafOperation{.internode = kMissing}, missing},
        {"placeLeaf of no length", PlaceLeafOperation{.internode = 3U, .length = 0.0F},
         QStringLiteral("internode 3 cannot bear such a leaf")},
        {"moveBranch of what is not there", MoveBranchOperation{.internode = kMissing, .onto = 2U}, missing},
        {"moveBranch onto what is not there", MoveBranchOperation{.internode = 3U, .onto = kMissing},
         missing},
        {"moveBranch of a trunk", MoveBranchOperation{.internode = 0U, .onto = 2U},
         QStringLiteral("a trunk cannot be moved")},
        {"arrange on what is not there", ArrangeOperation{.internode = kMissing}, missing},
        {"arrange without leaves", ArrangeOperation{.engine = LeafEngine::Alternate, .internode = 3U},
         QStringLiteral("no leaves at internode 3 can be arranged by “alternate”")},
        {"setWidth of what is not there", SetWidthOperation{kMissing, 0.04}, missing},
        {"setWidth that takes nothing away", SetWidthOperation{2U, 0.0},
         QStringLiteral("internode 2 has no width to take away")},
        {"setProfile", SetProfileOperation{{2U, 3U}, profileOf(ProfileShape::Ring)}, {}},
        {"setProfile along a branch",
         SetProfileOperation{{2U}, profileOf(ProfileShape::Ring), 4U, profileOf(ProfileShape::Round)},
         {}},
        {"setProfile of what is not there", SetProfileOperation{{kMissing}, profileOf(ProfileShape::Ring)},
         missing},
        {"setProfile that takes nothing away", SetProfileOperation{{2U}},
         QStringLiteral("internode 2 has no profile to take away")},
        {"lasso", lassoOf({}), {}},
        {"lasso that encloses nothing",
         LassoOperation{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0, 1}, {0, 1}, {0, 1}}}},
         QStringLiteral("The lasso is too small to enclose anything.")},
        {"lasso of a missing bud", lassoOf(missingBud), noBud},
        {"regrow without an envelope", RegrowOperation{}, QStringLiteral("There is no envelope to regrow.")},
        {"filling on without an envelope", FillEnvelopesOperation{},
         QStringLiteral("There is no envelope to fill.")},
        {"filling of what encloses nothing",
         FillEnvelopesOperation{
             std::vector{LassoStroke{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0, 1}, {0, 1}, {0, 1}}}}},
         QStringLiteral("The lasso is too small to enclose anything.")},
        {"import where something has grown",
         ImportOperation{{{kNoInternode, Vec3::Zero(), Vec3::UnitY(), 0.1F}}},
         QStringLiteral("a skeleton can only be imported where nothing has grown")},
        {"sketch where something has grown", SketchOperation{{.strokes = {{{0, 0}, {0, 1}}}}},
         QStringLiteral("a sketch can only become a tree where nothing has grown")},
        {"sketchStroke", branchOn({}), {}},
        {"sketchStroke without a length",
         SketchStrokeOperation{.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), {{0, 0}, {0, 0}}},
                               .on = InternodeReference(1)},
         QStringLiteral("the stroke has no length")},
        {"sketchStroke on a missing branch", branchOn(InternodeReference(kMissing)), missing},
        {"infer of a trunk", InferOperation{},
         QStringLiteral("draw branches first: a trunk alone has no depth to find")},
        {"multiply of what is not there", MultiplyOperation{kMissing}, missing},
        {"multiply of a bare branch", MultiplyOperation{2U},
         QStringLiteral("the branch of internode 2 carries no branch to imitate")},
        {"propagate of what is not there", PropagateOperation{.internode = kMissing, .axes = {}}, missing},
        {"propagate of a bare branch", PropagateOperation{.internode = 2U, .axes = {}},
         QStringLiteral("the branch of internode 2 carries nothing to copy")},
        {"propagate to what is not there",
         PropagateOperation{.internode = 2U,
                            .targets = Propagation::Targets::Listed,
                            .axes = {InternodeReference(kMissing)}},
         missing},
        {"reproduce", ReproduceOperation{{{{0, 0}, {0, 2}}, {{-1, 1}, {1, 1}, {0, 3}}, 0.0}}, {}},
        {"reproduce with a loop for a trunk",
         ReproduceOperation{{{{0, 0}, {1, 1}, {0, 1}, {0, 0}}, {{-1, 1}, {1, 1}, {0, 3}}, 0.0}},
         QStringLiteral("the new trunk must be an open line")},
        {"reproduce with a flat silhouette",
         ReproduceOperation{{{{0, 0}, {0, 2}}, {{-1, 1}, {1, 1}, {0, 1}}, 0.0}},
         QStringLiteral("the silhouette encloses nothing")},
        {"vary", VaryOperation{3, 0.5}, {}},
        {"removeLasso without an envelope", RemoveLassoOperation{}, QStringLiteral("there is no envelope")},
    };
}

QStringList warningsOf(const Recipe& recipe)
{
    TreeDocument document;
    RecipePlayer player(document, recipe);
    player.playAll();
    return player.warnings();
}

} // namespace

void RecipeWarningsTest::whatIsNotThere_isNamed_data()
{
    QTest::addColumn<std::size_t>("number");
    const std::vector<Case> all = cases();
    for (std::size_t i = 0; i < all.size(); ++i)
        QTest::newRow(all[i].name) << i;
}

void RecipeWarningsTest::whatIsNotThere_isNamed()
{
    QFETCH(const std::size_t, number);
    const Case tried = cases()[number];
    Recipe recipe = axisRecipe();
    recipe.operations.push_back(tried.operation);
    const QStringList warnings = warningsOf(recipe);
    if (tried.warning.isEmpty()) {
        QCOMPARE(warnings, QStringList());
        return;
    }
    QCOMPARE(warnings.size(), 1);
    const QString expected =
        QStringLiteral("operations[2]: %1: %2").arg(tried.operation.name(), tried.warning);
    QVERIFY2(warnings.front().startsWith(expected), qPrintable(warnings.front()));
}

void RecipeWarningsTest::whatCanBeDone_bringsNoWarning()
{
    Recipe recipe = axisRecipe();
    recipe.operations.insert(recipe.operations.end(),
                             {TravelOperation{-1}, TravelOperation{1}, UndoOperation{1}, RedoOperation{1},
                              lassoOf({}), RegrowOperation{}, RemoveLassoOperation{}});
    QCOMPARE(warningsOf(recipe), QStringList());
}

void RecipeWarningsTest::everyKind_isTried()
{
    for (const QString& name : operationNames()) {
        const std::vector<Case> all = cases();
        QVERIFY2(std::ranges::any_of(all, [&](const Case& tried) { return name == tried.operation.name(); }),
                 qPrintable(name));
    }
}

void RecipeWarningsTest::restOfTheOperation_isDone()
{
    Recipe recipe = axisRecipe();
    recipe.operations.emplace_back(PruneOperation{{kMissing, 9U}});
    recipe.operations.emplace_back(PruneOperation{{9U}});
    QCOMPARE(warningsOf(recipe),
             (QStringList{QStringLiteral("operations[2]: prune: there is no internode 700"),
                          QStringLiteral("operations[3]: prune: there is no internode 9")}));
}

void RecipeWarningsTest::manyFaults_areCounted()
{
    Recipe recipe = axisRecipe();
    PruneOperation prune;
    for (InternodeId id = kMissing; id < kMissing + 100; ++id)
        prune.internodes.emplace_back(id);
    recipe.operations.emplace_back(prune);
    QCOMPARE(warningsOf(recipe), QStringList{QStringLiteral(
                                     "operations[2]: prune: there is no internode 700; there is no internode "
                                     "701; there is no internode 702; and 97 more")});
}

void RecipeWarningsTest::places_areThoseInTheRecipe()
{
    Recipe recipe = axisRecipe();
    recipe.operations.insert(recipe.operations.begin(), RedoOperation{1});
    recipe.operations.emplace_back(RemoveLassoOperation{});
    QCOMPARE(warningsOf(recipe),
             (QStringList{QStringLiteral("operations[0]: redo: there are only 0 commands to redo, not 1"),
                          QStringLiteral("operations[3]: removeLasso: there is no envelope")}));
}

void RecipeWarningsTest::bendBeyondTheBranch_namesTheHandle()
{
    Recipe recipe = axisRecipe();
    recipe.operations.emplace_back(
        BendOperation{.base = 2, .handles = {{6, 1.0, Vec3(0.3F, 0.6F, 0.0F)}, {2, 0.5, Vec3::Zero()}}});
    QCOMPARE(warningsOf(recipe),
             QStringList{
                 QStringLiteral("operations[2]: bend: internode 2 is not on the branch above internode 2")});
}

void RecipeWarningsTest::budThatHasGrown_isStillThere()
{
    Recipe recipe = axisRecipe();
    recipe.operations.emplace_back(GrowOperation{2, {3U, 0}});
    recipe.operations.emplace_back(GrowOperation{2, {3U, 0}});
    TreeDocument document;
    RecipePlayer player(document, recipe);
    player.playAll();
    QCOMPARE(player.warnings(), QStringList());
    QCOMPARE(document.tree().buds(3) & budBit(0), 0);
}

void RecipeWarningsTest::parametersThatFindNoRoom_areNamed()
{
    TreeDocument document;
    TreeDelta delta = deltaStartingAt(document.tree());
    delta.rows = std::make_shared<TreeRows>();
    TreeParameters parameters;
    for (qsizetype i = 1; i < kMostParameterSets; ++i) {
        parameters.growth.apicalDominance = static_cast<double>(i) / kMostParameterSets;
        delta.rows->kept.parameters.append(parameters);
    }
    delta.kept.parameters = static_cast<std::uint32_t>(delta.rows->kept.parameters.size());
    apply(document, std::move(delta));
    const DocumentState full(document);
    const QString warning = QStringLiteral("there is no room for more parameter sets");
    parameters.growth.apicalDominance = 0.0;
    QCOMPARE(SetParametersOperation{parameters}.perform(document), warning);
    QCOMPARE(differenceFrom(full, document), QString());
    // A set that the tree has needs no room.
    parameters.growth.apicalDominance = 1.0 / kMostParameterSets;
    QCOMPARE(SetParametersOperation{parameters}.perform(document), QString());
    Recipe recipe;
    recipe.parameters.growth.apicalDominance = 0.0;
    const RecipePlayer player(document, recipe, RecipePlayer::Start::GoOn);
    QCOMPARE(player.warnings(), QStringList{QStringLiteral("parameters: ") + warning});
}

const TestClass<RecipeWarningsTest> recipeWarningsTest;

} // namespace espalier::test

#include "RecipeWarningsTest.moc"
