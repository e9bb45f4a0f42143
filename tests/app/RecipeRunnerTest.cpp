// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/RecipeRunner.h"

#include "app/runners/Background.h"
#include "commands/Prune.h"
#include "commands/recipe/GrowOperation.h"
#include "tests/support/Documents.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// Recipes that are played while the window lives.
class RecipeRunnerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void recipe_growsTheTreeOfItsPlayer_data();
    void recipe_growsTheTreeOfItsPlayer();
    void recipeWithoutOperations_endsAsASeedling();
    void tree_isSeenInManyStates();
    void stroke_isShownWhileItIsMade();
    void stop_keepsTheOperationsBefore();
    void anotherEdit_stopsTheRecipe_data();
    void anotherEdit_stopsTheRecipe();
    void secondRecipe_takesTheFirstOnesPlace();

private:
    static Recipe sample(const QString& name);
    static bool waitForEnd(const RecipeRunner& runner)
    {
        return QTest::qWaitFor([&runner] { return !runner.isRunning(); }, 60'000);
    }
};

Recipe RecipeRunnerTest::sample(const QString& name)
{
    return readRecipe(QStringLiteral(SOURCE_DIR "/resources/recipes/%1.json").arg(name)).value();
}

void RecipeRunnerTest::recipe_growsTheTreeOfItsPlayer_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"bonsai", "lobed", "candelabra"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void RecipeRunnerTest::recipe_growsTheTreeOfItsPlayer()
{
    QFETCH(const QString, name);
    TreeDocument straight;
    RecipePlayer player(straight, sample(name));
    player.playAll();

    TreeDocument document;
    RecipeRunner runner(document);
    QSignalSpy finished(&runner, &RecipeRunner::finished);
    runner.start(sample(name), RecipeRunner::Pace::Hurried);
    QVERIFY(waitForEnd(runner));
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.front().front().toBool(), true);
    QCOMPARE(test::differenceFrom(test::DocumentState(straight), document), QString());
    QCOMPARE(document.undoStack().count(), straight.undoStack().count());
    QCOMPARE(runner.warnings(), player.warnings());
    QVERIFY(document.edit() == nullptr);
}

void RecipeRunnerTest::recipeWithoutOperations_endsAsASeedling()
{
    TreeDocument document;
    RecipeRunner runner(document);
    Recipe recipe;
    recipe.seed = 77;
    runner.start(recipe, RecipeRunner::Pace::Hurried);
    QVERIFY(waitForEnd(runner));
    QCOMPARE(document.tree().seed(), std::uint64_t{77});
    QCOMPARE(document.tree().size(), 1U);
}

void RecipeRunnerTest::tree_isSeenInManyStates()
{
    TreeDocument document;
    RecipeRunner runner(document);
    QSet<std::uint32_t> seen;
    int beats = 0;
    QTimer beat;
    connect(&beat, &QTimer::timeout, this, [&] {
        ++beats;
        seen.insert(document.index().livingCount());
    });
    beat.start(0);
    Recipe recipe;
    recipe.operations.push_back(GrowOperation{.steps = 34});
    runner.start(recipe, RecipeRunner::Pace::Hurried);
    QVERIFY(waitForEnd(runner));
    QVERIFY2(beats >= 5, qPrintable(QString::number(beats)));
    QVERIFY2(seen.size() >= 5, qPrintable(QString::number(seen.size())));
}

void RecipeRunnerTest::stroke_isShownWhileItIsMade()
{
    TreeDocument document;
    RecipeRunner runner(document);
    runner.start(sample(QStringLiteral("bonsai")), RecipeRunner::Pace::OfTheHand);
    QVERIFY(QTest::qWaitFor([&] { return runner.moment() && runner.moment()->stroke.size() > 5; }, 30'000));
    const float first = runner.moment()->stroke.back().position.y();
    QVERIFY(QTest::qWaitFor(
        [&] {
            return runner.moment() && !runner.moment()->stroke.empty() &&
                   runner.moment()->stroke.back().position.y() != first;
        },
        30'000));
    QVERIFY(document.edit() != nullptr);
    runner.stop();
    QVERIFY(runner.moment() == nullptr);
}

void RecipeRunnerTest::stop_keepsTheOperationsBefore()
{
    const Recipe recipe = sample(QStringLiteral("lobed"));
    TreeDocument document;
    RecipeRunner runner(document);
    QSignalSpy finished(&runner, &RecipeRunner::finished);
    runner.start(recipe, RecipeRunner::Pace::Hurried);
    QVERIFY(QTest::qWaitFor([&] { return document.undoStack().count() >= 2; }, 60'000));
    runner.stop();
    QCOMPARE(finished.size(), 1);
    QCOMPARE(finished.front().front().toBool(), false);
    QVERIFY(document.edit() == nullptr);
    const test::DocumentState stopped(document);

    TreeDocument straight;
    RecipePlayer player(straight, recipe);
    while (straight.undoStack().count() < stopped.undoIndex)
        player.playOperation();
    QCOMPARE(test::differenceFrom(test::DocumentState(straight), document), QString());
    // What the worker still plays changes nothing.
    backgroundThreads().waitForDone();
    QCoreApplication::processEvents();
    QCOMPARE(test::differenceFrom(stopped, document), QString());
}

void RecipeRunnerTest::anotherEdit_stopsTheRecipe_data()
{
    QTest::addColumn<bool>("isBetweenEdits");
    QTest::newRow("during an operation") << false;
    QTest::newRow("between two operations") << true;
}

void RecipeRunnerTest::anotherEdit_stopsTheRecipe()
{
    QFETCH(const bool, isBetweenEdits);
    TreeDocument document;
    RecipeRunner runner(document);
    runner.start(sample(QStringLiteral("bonsai")), RecipeRunner::Pace::OfTheHand);
    QVERIFY(QTest::qWaitFor(
        [&] { return document.undoStack().count() > 0 && (document.edit() == nullptr) == isBetweenEdits; },
        60'000));
    const InternodeId cut = 12; // of the first stroke
    pruneBranches(document, std::span(&cut, 1));
    QVERIFY(!document.tree().isAlive(cut));
    QVERIFY(waitForEnd(runner));
    QVERIFY(!document.tree().isAlive(cut));
    QCOMPARE(test::indexFault(document), QString());
    document.undo();
    QVERIFY(document.tree().isAlive(cut));
}

void RecipeRunnerTest::secondRecipe_takesTheFirstOnesPlace()
{
    TreeDocument document;
    RecipeRunner runner(document);
    runner.start(sample(QStringLiteral("lobed")), RecipeRunner::Pace::Hurried);
    QVERIFY(QTest::qWaitFor([&] { return document.tree().size() > 100; }, 60'000));
    runner.start(sample(QStringLiteral("bonsai")), RecipeRunner::Pace::Hurried);
    QVERIFY(waitForEnd(runner));
    TreeDocument straight;
    RecipePlayer(straight, sample(QStringLiteral("bonsai"))).playAll();
    QCOMPARE(test::differenceFrom(test::DocumentState(straight), document), QString());
}

static const test::TestClass<RecipeRunnerTest> recipeRunnerTest;

#include "RecipeRunnerTest.moc"
