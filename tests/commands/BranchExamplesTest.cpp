// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/DrawSketch.h"
#include "commands/MultiplyBranch.h"
#include "commands/PropagateBranch.h"
#include "commands/Prune.h"
#include "commands/ReproduceTree.h"
#include "commands/SketchStroke.h"
#include "commands/VaryTree.h"
#include "commands/recipe/RecipeFile.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/model/sketch/DrawnTrees.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/Replaying.h"
#include "tests/support/TestClasses.h"

#include <QFile>
#include <QTest>

#include <cmath>
#include <functional>

namespace espalier::test {

/// The commands that make more of a tree by example, on trees of all kinds.
class BranchExamplesTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void eachCommand_isOneUndoStepAndARecipe();
    void manyBranches_areOneUndoStep();
    void copiesOfCopies_haveALimit();
    void refusedCommands_changeNothing();
    void copies_goOnGrowing();
    void outsideBranches_areCounted();
    void documentedExamples_findWhatTheyName();
};

namespace {

/// A document of each kind: brushed and grown, and drawn.
void plantKind(TreeDocument& document, int kind)
{
    if (kind != 0) {
        growAtRandom(document, static_cast<std::uint64_t>(kind), 80, 300);
        return;
    }
    TreeSketch sketch;
    for (const SketchStroke& stroke : drawnTree(3, 16)) {
        std::vector<Vec2>& points = sketch.strokes.emplace_back();
        for (const Eigen::Vector2d& point : stroke.line)
            points.emplace_back(point.cast<float>());
    }
    QVERIFY(drawSketch(document, sketch));
}

/// The first living internode whose axis is not the trunk and carries a branch, or the trunk's.
InternodeId bearerOf(const TreeDocument& document)
{
    const Tree& tree = document.tree();
    for (InternodeId id = 1; id < tree.size(); ++id) {
        const bool isBranch = tree.isAlive(id) && !tree.continuesAxis(id) && !tree.isRoot(id);
        if (isBranch && document.index().axis(tree.parent(id)) != 0)
            return tree.parent(id);
    }
    return 0;
}

TreeFigure figure()
{
    return {.trunk = {{0.0F, -0.0F}, {0.2F, 1.0F}, {0.1F, 2.4F}},
            .silhouette = {{-1.0F, 0.0F}, {1.3F, -0.1F}, {0.9F, 2.0F}, {0.1F, 2.6F}, {-0.8F, 2.1F}},
            .azimuth = -33.3};
}

struct NamedCommand {
    QString text;
    std::function<bool(TreeDocument&)> run;
};

std::vector<NamedCommand> exampleCommands()
{
    return {
        {QStringLiteral("Multiply Branch"),
         [](TreeDocument& document) { return bool(multiplyBranch(document, bearerOf(document), 3, 2)); }},
        {QStringLiteral("Pass On Branch"),
         [](TreeDocument& document) {
             return bool(propagateBranch(
                 document,
                 {.reference = bearerOf(document), .targets = Propagation::Targets::SameOrder, .axes = {}}));
         }},
        {QStringLiteral("Pass On Branch"),
         [](TreeDocument& document) {
             return bool(propagateBranch(document, {.reference = bearerOf(document),
                                                    .targets = Propagation::Targets::Listed,
                                                    .axes = {0},
                                                    .scaling = false,
                                                    .replaces = true}));
         }},
        {QStringLiteral("Reshape Tree"),
         [](TreeDocument& document) { return bool(reproduceTree(document, figure())); }},
        {QStringLiteral("Vary Tree"),
         [](TreeDocument& document) { return bool(varyTree(document, 12, 0.4)); }},
    };
}

} // namespace

void BranchExamplesTest::eachCommand_isOneUndoStepAndARecipe()
{
    int done = 0;
    for (int kind = 0; kind < 5; ++kind) {
        for (const NamedCommand& command : exampleCommands()) {
            TreeDocument document;
            plantKind(document, kind);
            const DocumentState before(document);
            const bool isDone = command.run(document);
            if (!isDone) {
                QCOMPARE(differenceFrom(before, document), QString());
                continue;
            }
            ++done;
            QVERIFY(!(before.tree == document.tree()));
            QCOMPARE(document.undoStack().index(), before.undoIndex + 1);
            QCOMPARE(document.undoStack().undoText(), command.text);
            QCOMPARE(treeFault(document.tree().content()), QString());
            QCOMPARE(indexFault(document), QString());
            const QString fault = replayFault(document);
            QVERIFY2(fault.isEmpty(), qPrintable(command.text + QStringLiteral(": ") + fault));
            const DocumentState after(document);
            document.undo();
            QCOMPARE(differenceFrom(before, document), QString());
            document.redo();
            QCOMPARE(differenceFrom(after, document), QString());
        }
    }
    QVERIFY(done >= 20);
}

void BranchExamplesTest::manyBranches_areOneUndoStep()
{
    TreeDocument document;
    plantKind(document, 0);
    const DocumentState before(document);
    const std::uint32_t size = document.tree().size();
    QVERIFY(multiplyBranch(document, 0, 7, 20));
    QVERIFY(document.tree().size() >= size + 20);
    QCOMPARE(document.undoStack().count(), before.undoIndex + 1);
    QCOMPARE(replayFault(document), QString());
    document.undo();
    QCOMPARE(differenceFrom(before, document), QString());
}

void BranchExamplesTest::copiesOfCopies_haveALimit()
{
    TreeDocument document;
    const auto draw = [&document](std::vector<Vec2> points) {
        return *sketchBranch(
            document,
            {.stroke = {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), std::move(points)}, .base = {}});
    };
    draw({{0.0F, 0.0F}, {0.0F, 2.0F}});
    const InternodeId limb = draw({{0.0F, 0.8F}, {0.9F, 1.4F}});
    draw({{0.5F, 1.13F}, {0.8F, 1.0F}});
    QVERIFY(multiplyBranch(document, limb, 1, 1000));
    const DocumentState before(document);
    const Result<void> done = multiplyBranch(document, 0, 1, 1000);
    QVERIFY(!done && done.error().message.contains(QLatin1String("1000000")));
    QCOMPARE(differenceFrom(before, document), QString());
}

void BranchExamplesTest::refusedCommands_changeNothing()
{
    TreeDocument document;
    grow(document, 3);
    document.undoStack().clear();
    const DocumentState before(document);
    QVERIFY(!multiplyBranch(document, 4000, 1));
    QVERIFY(!propagateBranch(document, {.reference = 4000, .axes = {}}));
    QVERIFY(!reproduceTree(document,
                           {.trunk = {{0.0F, 1.0F}}, .silhouette = figure().silhouette, .azimuth = 0.0}));
    QVERIFY(!reproduceTree(document, {.trunk = figure().trunk, .silhouette = {}, .azimuth = 0.0}));
    QVERIFY(varyTree(document, 3, 0.0));
    QVERIFY(varyTree(document, 3, std::nan("")));
    QCOMPARE(differenceFrom(before, document), QString());
    QCOMPARE(document.undoStack().count(), 0);
}

void BranchExamplesTest::copies_goOnGrowing()
{
    TreeDocument document;
    plantKind(document, 0);
    QVERIFY(multiplyBranch(document, 0, 2, 3));
    const std::uint32_t size = document.tree().size();
    QVERIFY(grow(document, 4) > 0);
    QVERIFY(document.tree().size() > size);
    QCOMPARE(treeFault(document.tree().content()), QString());
    QCOMPARE(indexFault(document), QString());
    QCOMPARE(replayFault(document), QString());
}

void BranchExamplesTest::outsideBranches_areCounted()
{
    TreeDocument document;
    plantKind(document, 0);
    const Result<std::uint32_t> none = reproduceTree(document, figure());
    QVERIFY(none);
    QCOMPARE(*none, 0U);
    TreeFigure high = figure();
    for (Vec2& point : high.silhouette)
        point.y() += 2.0F;
    const Result<std::uint32_t> some = reproduceTree(document, high);
    QVERIFY(some);
    QVERIFY(*some > 2);
}

void BranchExamplesTest::documentedExamples_findWhatTheyName()
{
    QFile file(QStringLiteral(SOURCE_DIR "/docs/recipes.md"));
    QVERIFY(file.open(QIODevice::ReadOnly));
    const QString text = QString::fromUtf8(file.readAll());
    for (const char* name : {"multiply", "propagate", "reproduce", "vary"}) {
        const auto section = text.indexOf(QStringLiteral("\n### %1\n").arg(QLatin1String(name)));
        QVERIFY2(section >= 0, name);
        const auto begin = text.indexOf(QStringLiteral("```json\n"), section) + 8;
        const Result<Recipe> recipe =
            parseRecipe(text.mid(begin, text.indexOf(QStringLiteral("```"), begin) - begin).toUtf8());
        QVERIFY2(recipe, name);
        TreeDocument document;
        RecipePlayer player(document, *recipe);
        player.playAll();
        QCOMPARE(player.warnings().join(QLatin1Char('\n')), QString());
        QCOMPARE(document.undoStack().count(), static_cast<int>(recipe->operations.size()));
    }
}

static const TestClass<BranchExamplesTest> branchExamplesTest;

} // namespace espalier::test

#include "BranchExamplesTest.moc"
