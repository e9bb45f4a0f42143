// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/RecipePlayer.h"

#include "commands/BendGesture.h"
#include "commands/Prune.h"
#include "commands/SetParameters.h"
#include "commands/WidthGesture.h"
#include "tests/support/AllOperations.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <tbb/global_control.h>

namespace espalier::test {

class RecipePlayerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void sameRecipe_givesTheSameTree();
    void threads_doNotChangeTheTree();
    void slices_giveTheSameTreeAsOneGo();
    void hand_givesTheSameTreeAsTheRecipe();
    void eachOperation_isOneUndoStep();
    void undoAndRedo_arePlayedToo();
    void playingOn_startsFromTheTreeThatStands();
    void droppedMidway_leavesTheFinishedOperations();
    void demonstration_takesTheHandsTime();
};

namespace {

/// A recipe with an operation of each kind, its strokes as sparse as a slow device sends them.
Recipe recipe(std::uint64_t seed)
{
    Random random(seed, 0, 0, Purpose::ShootLength);
    Recipe recipe;
    recipe.seed = seed;
    recipe.parameters = randomParameters(random);
    const auto stroke = [&](double seconds, int every) {
        BrushStrokeOperation operation;
        const auto dense = randomStroke(random, recipe.parameters.growth, seconds);
        for (std::size_t i = 0; i < dense.size(); i += static_cast<std::size_t>(every))
            operation.samples.push_back(dense[i]);
        return operation;
    };
    recipe.operations.emplace_back(stroke(1.2, 1));
    recipe.operations.emplace_back(GrowOperation{3});
    recipe.operations.emplace_back(stroke(1.0, 23));
    TreeParameters changed = randomParameters(random);
    changed.growth.internodeLength = recipe.parameters.growth.internodeLength;
    recipe.operations.emplace_back(SetParametersOperation{changed});
    recipe.operations.emplace_back(stroke(0.8, 4));
    recipe.operations.emplace_back(UndoOperation{2});
    recipe.operations.emplace_back(RedoOperation{1});
    recipe.operations.emplace_back(
        BendOperation{.base = 0, .handles = {{9, 0.5, Vec3(0.3F, 0.4F, -0.2F)}, {1, 1.0, Vec3::Zero()}}});
    recipe.operations.emplace_back(SetWidthOperation{3, 0.06});
    recipe.operations.emplace_back(stroke(0.8, 9));
    recipe.operations.emplace_back(PruneOperation{{30, 41}});
    recipe.operations.emplace_back(GrowOperation{2, {1, 0}});
    return recipe;
}

std::vector<InternodeId> numbersOf(const std::vector<InternodeReference>& internodes)
{
    std::vector<InternodeId> numbers;
    for (const InternodeReference& internode : internodes)
        numbers.push_back(internode.number());
    return numbers;
}

void play(TreeDocument& document, const Recipe& recipe)
{
    RecipePlayer player(document, recipe);
    player.playAll();
    QVERIFY(player.isDone());
}

} // namespace

void RecipePlayerTest::sameRecipe_givesTheSameTree()
{
    std::uint32_t internodes = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TreeDocument first;
        play(first, recipe(seed));
        TreeDocument second;
        growAtRandom(second, 99); // another tree is replaced
        play(second, recipe(seed));
        QVERIFY(second.tree() == first.tree());
        QCOMPARE(indexFault(first), QString());
        internodes += first.index().livingCount();
    }
    QVERIFY(internodes > 300);
}

void RecipePlayerTest::threads_doNotChangeTheTree()
{
    for (std::uint64_t seed = 10; seed < 14; ++seed) {
        Recipe many = recipe(seed);
        // So many markers that threads share the work.
        for (RecipeOperation& operation : many.operations) {
            if (const auto* set = operation.as<SetParametersOperation>()) {
                SetParametersOperation changed = *set;
                changed.parameters.growth.markersPerBud = 32;
                operation = changed;
            }
        }
        many.parameters.growth.markerDensity = 4.0;
        many.parameters.growth.markersPerBud = 32;
        TreeDocument one;
        {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
            play(one, many);
        }
        TreeDocument two;
        {
            const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 2);
            play(two, many);
        }
        QVERIFY(two.tree() == one.tree());
        QVERIFY(one.tree().size() > 20);
    }
}

void RecipePlayerTest::slices_giveTheSameTreeAsOneGo()
{
    for (std::uint64_t seed = 20; seed < 26; ++seed) {
        TreeDocument atOnce;
        play(atOnce, recipe(seed));
        for (const double slice : {0.016, 0.007, 0.5}) {
            TreeDocument sliced;
            RecipePlayer player(sliced, recipe(seed));
            int calls = 0;
            for (; !player.isDone() && calls < 100000; ++calls)
                player.advance(slice);
            QVERIFY(player.isDone());
            QVERIFY(sliced.tree() == atOnce.tree());
            QCOMPARE(sliced.undoStack().count(), atOnce.undoStack().count());
        }
    }
}

void RecipePlayerTest::hand_givesTheSameTreeAsTheRecipe()
{
    for (std::uint64_t seed = 30; seed < 40; ++seed) {
        const Recipe played = recipe(seed);
        TreeDocument byRecipe;
        play(byRecipe, played);
        TreeDocument byHand;
        byHand.reset(played.seed, played.parameters);
        for (const RecipeOperation& operation : played.operations) {
            if (const auto* stroke = operation.as<BrushStrokeOperation>())
                brush(byHand, stroke->samples);
            else if (const auto* growth = operation.as<GrowOperation>())
                grow(byHand, growth->steps, growth->only.resolve(byHand).competitors);
            else if (const auto* cut = operation.as<PruneOperation>())
                pruneBranches(byHand, numbersOf(cut->internodes));
            else if (const auto* set = operation.as<SetParametersOperation>())
                setParameters(byHand, set->parameters);
            else if (const auto* undo = operation.as<UndoOperation>()) {
                for (int i = 0; i < undo->count; ++i)
                    byHand.undoStack().undo();
            } else if (const auto* redo = operation.as<RedoOperation>()) {
                for (int i = 0; i < redo->count; ++i)
                    byHand.undoStack().redo();
            } else if (const auto* bend = operation.as<BendOperation>()) {
                std::vector<BranchBend::Handle> handles;
                std::vector<Vec3> targets;
                for (const BendOperation::Handle& handle : bend->handles) {
                    handles.push_back({handle.internode.number(), handle.along});
                    targets.push_back(handle.target);
                }
                BendGesture gesture(byHand, bend->base.number(), std::move(handles));
                while (!gesture.moveTo(targets)) {
                }
                gesture.finish();
            } else if (const auto* width = operation.as<SetWidthOperation>()) {
                setWidth(byHand, width->internode.number(), width->diameter);
            }
        }
        QVERIFY2(byHand.tree() == byRecipe.tree(), qPrintable(QStringLiteral("seed %1").arg(seed)));
    }
}

void RecipePlayerTest::eachOperation_isOneUndoStep()
{
    TreeDocument document;
    RecipePlayer player(document, recipe(41));
    int commands = 0;
    for (int i = 0; i < 4; ++i) {
        const std::size_t journal = document.journal().size();
        player.playOperation();
        commands += document.journal().size() > journal ? 1 : 0;
        QCOMPARE(document.undoStack().count(), commands);
    }
    QVERIFY(commands > 2);
}

void RecipePlayerTest::undoAndRedo_arePlayedToo()
{
    Recipe undone;
    undone.operations = {GrowOperation{3}, GrowOperation{4}, UndoOperation{1}};
    TreeDocument document;
    play(document, undone);
    QCOMPARE(document.tree().step(), 3U);
    undone.operations.emplace_back(RedoOperation{1});
    play(document, undone);
    QCOMPARE(document.tree().step(), 7U);
    // More than there is to undo is no fault.
    undone.operations.emplace_back(UndoOperation{100});
    play(document, undone);
    QCOMPARE(document.index().livingCount(), 1U);
}

void RecipePlayerTest::playingOn_startsFromTheTreeThatStands()
{
    TreeDocument document;
    grow(document, 5);
    const std::uint32_t before = document.index().livingCount();
    Recipe more;
    more.parameters.growth.shedding = 0.0;
    more.operations = {GrowOperation{3}};
    RecipePlayer player(document, more, RecipePlayer::Start::GoOn);
    player.playAll();
    QVERIFY(document.index().livingCount() > before);
    QCOMPARE(document.parameters().growth.shedding, 0.0);
    QCOMPARE(document.undoStack().count(), 3); // growth, parameters, growth
}

void RecipePlayerTest::droppedMidway_leavesTheFinishedOperations()
{
    Recipe two;
    two.operations = {GrowOperation{3}, GrowOperation{20}};
    TreeDocument document;
    {
        RecipePlayer player(document, two);
        player.playOperation();
        player.advance(0.5); // six steps of twenty
        QCOMPARE(document.tree().step(), 9U);
    }
    QCOMPARE(document.tree().step(), 3U);
    QCOMPARE(document.undoStack().count(), 1);
    QCOMPARE(indexFault(document), QString());
}

void RecipePlayerTest::demonstration_takesTheHandsTime()
{
    Recipe stroke;
    const std::vector<Vec3> path{Vec3(0.0F, 0.5F, 0.0F), Vec3(0.0F, 1.5F, 0.0F)};
    const auto dense = strokeAlong(path, 0.4F, 2.0);
    stroke.operations = {BrushStrokeOperation{{dense.front(), dense.back()}}};
    TreeDocument document;
    RecipePlayer player(document, stroke);
    QVERIFY(!player.brush());
    double time = 0.0;
    while (time < 1.95) {
        player.advance(0.05);
        time += 0.05;
        if (time < 1.95) {
            // Also between samples far apart the brush moves evenly.
            QVERIFY(player.brush().has_value());
            QVERIFY(std::abs(static_cast<double>(player.brush()->position.y()) - (0.5 + time / 2.0)) < 0.06);
        }
    }
    player.advance(0.1);
    QVERIFY(player.isDone());
    QVERIFY(!player.brush());
    QCOMPARE(player.stroke(), nullptr);
}

const TestClass<RecipePlayerTest> recipePlayerTest;

} // namespace espalier::test

#include "RecipePlayerTest.moc"
