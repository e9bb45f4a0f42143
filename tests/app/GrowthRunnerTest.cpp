// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/runners/GrowRunner.h"
#include "app/runners/LassoRunner.h"
#include "app/runners/TimeRunner.h"
#include "commands/GrowGesture.h"
#include "model/shape/Pruning.h"
#include "panels/ParameterEditor.h"
#include "tests/support/TestClasses.h"

#include <QSignalSpy>
#include <QTest>

#include <array>

using namespace espalier;

namespace {

constexpr int kPatience = 20'000; ///< ms

LassoStroke circle()
{
    LassoStroke stroke;
    for (int i = 0; i <= 40; ++i) {
        const double angle = radians(9.0 * i);
        stroke.points.emplace_back(static_cast<float>(0.5 * std::sin(angle)),
                                   static_cast<float>(1.0 - 0.5 * std::cos(angle)));
    }
    return stroke;
}

TreeParameters drooping(TreeParameters parameters)
{
    parameters.growth.setPointAngle = radians(120);
    return parameters;
}

} // namespace

/// Growth that another thread computes.
class GrowthRunnerTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void growth_isWhatTheGestureMakes();
    void filling_isWhatTheGestureMakes();
    void tap_isOneStep();
    void runsAskedForMeanwhile_areUndoStepsOfTheirOwn();
    void end_keepsWhatIsShown();
    void cancel_leavesNoTrace();
    void runnerThatGoes_takesBackWhatItBegan();
    void parametersChangedMeanwhile_affectWhatGrowsAfterwards();
    void parametersHeld_growthWaits();
    void waitingGrowth_endsWithAnotherEdit_data();
    void waitingGrowth_endsWithAnotherEdit();
    void parametersChangedWhileALassoIsFilled_areTakenUp();
};

void GrowthRunnerTest::growth_isWhatTheGestureMakes()
{
    TreeDocument expected;
    GrowGesture gesture(expected);
    for (int step = 0; step < 14; ++step)
        QVERIFY(gesture.step());
    gesture.finish();

    TreeDocument document;
    GrowRunner runner(document);
    runner.run(14);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kPatience);
    QVERIFY(document.tree() == expected.tree());
    QCOMPARE(document.undoStack().count(), 1);

    // Growth continues after an undo and a redo; the copy of the tree must contain its history.
    document.undoStack().undo();
    document.undoStack().redo();
    runner.run(3);
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kPatience);
    GrowGesture more(expected);
    for (int step = 0; step < 3; ++step)
        QVERIFY(more.step());
    QVERIFY(document.tree() == expected.tree());
    more.finish();
}

void GrowthRunnerTest::filling_isWhatTheGestureMakes()
{
    TreeDocument expected;
    const LassoGesture::Begun gesture = LassoGesture::fill(expected, circle());
    QVERIFY(gesture);
    while ((*gesture)->step()) {
    }
    (*gesture)->finish();
    QVERIFY(expected.index().livingCount() > 50);

    TreeDocument document;
    LassoRunner runner(document);
    runner.fill(circle());
    QVERIFY(!runner.gesture()->markers().empty());
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kPatience);
    QVERIFY(document.tree() == expected.tree());
    QCOMPARE(document.undoStack().count(), 1);
    document.undoStack().undo();
    QVERIFY(document.tree().lassoIndicesInForce().empty());
    QCOMPARE(document.index().livingCount(), 1U);
}

void GrowthRunnerTest::tap_isOneStep()
{
    TreeDocument document;
    GrowRunner runner(document);
    runner.begin();
    runner.release();
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kPatience);
    QCOMPARE(document.tree().step(), Step{1});
    QCOMPARE(document.undoStack().count(), 1);
}

void GrowthRunnerTest::runsAskedForMeanwhile_areUndoStepsOfTheirOwn()
{
    TreeDocument document;
    GrowRunner runner(document);
    for (int i = 0; i < 4; ++i)
        runner.run(1);
    QTRY_COMPARE_WITH_TIMEOUT(document.tree().step(), Step{4}, kPatience);
    QCOMPARE(document.undoStack().count(), 4);
    QVERIFY(!runner.isRunning());
}

void GrowthRunnerTest::end_keepsWhatIsShown()
{
    TreeDocument document;
    GrowRunner runner(document);
    runner.run(GrowthRunner::kEndless);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 5, kPatience);
    runner.end();
    const Tree shown = document.tree();
    // A step that was being computed is dropped.
    QTest::qWait(100);
    QVERIFY(document.tree() == shown);
    QCOMPARE(document.undoStack().count(), 1);
    document.undoStack().undo();
    document.undoStack().redo();
    QVERIFY(document.tree() == shown);
}

void GrowthRunnerTest::cancel_leavesNoTrace()
{
    TreeDocument document;
    GrowRunner runner(document);
    runner.run(GrowthRunner::kEndless);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 5, kPatience);
    runner.cancel();
    QTest::qWait(100);
    QCOMPARE(document.tree().step(), Step{0});
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(document.journal().empty());
    // Growth can begin again on the present tree.
    runner.run(2);
    QTRY_COMPARE_WITH_TIMEOUT(document.tree().step(), Step{2}, kPatience);
}

void GrowthRunnerTest::runnerThatGoes_takesBackWhatItBegan()
{
    TreeDocument document;
    {
        GrowRunner runner(document);
        runner.run(GrowthRunner::kEndless);
        QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 3, kPatience);
    }
    QTest::qWait(50);
    QCOMPARE(document.tree().step(), Step{0});
}

void GrowthRunnerTest::parametersChangedMeanwhile_affectWhatGrowsAfterwards()
{
    TreeParameters parameters;
    parameters.growth.straightening = 0.0; // It turns what stands already
    TreeDocument document;
    document.reset(1, parameters);
    GrowRunner runner(document);
    ParameterEditor editor(document);
    runner.run(GrowthRunner::kEndless);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 5, kPatience);
    const Tree before = document.tree();
    const TreeParameters wanted = drooping(document.parameters());
    editor.begin();
    editor.show(wanted);
    editor.finish(QStringLiteral("Set-point angle"));
    QVERIFY(runner.isRunning());
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= before.step() + 3, kPatience);
    runner.end();

    // In the journal, the change stands between what grew before and after it.
    const Tree& tree = document.tree();
    bool hasChanged = false;
    int births = 0;
    for (const auto& delta : document.journal()) {
        hasChanged = hasChanged || delta->parametersBefore != delta->parametersAfter;
        for (InternodeId id = delta->born.first; id != delta->born.end(); ++id, ++births)
            QCOMPARE(tree.parametersOf(id) == wanted, hasChanged);
    }
    QVERIFY(hasChanged);
    QCOMPARE(static_cast<std::uint32_t>(births) + 1, tree.size());
    for (InternodeId id = 0; id < before.size(); ++id) {
        QVERIFY(tree.columns().rotation[id].coeffs() == before.columns().rotation[id].coeffs());
        QCOMPARE(tree.length(id), before.length(id));
    }
    // Three undo steps: growth, the change, growth.
    QUndoStack& stack = document.undoStack();
    QCOMPARE(stack.count(), 3);
    QCOMPARE(stack.text(1), QStringLiteral("Set-point angle"));
    stack.undo();
    QVERIFY(document.parameters() == wanted);
    stack.undo();
    QVERIFY(document.tree().step() == before.step() && document.parameters() != wanted);
    stack.undo();
    QCOMPARE(document.index().livingCount(), 1U);
}

void GrowthRunnerTest::parametersHeld_growthWaits()
{
    TreeDocument document;
    GrowRunner runner(document);
    ParameterEditor editor(document);
    runner.run(GrowthRunner::kEndless);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 3, kPatience);
    editor.begin();
    const Step held = document.tree().step();
    for (const double angle : {60.0, 80.0, 100.0}) {
        editor.show("growth.setPointAngle", angle);
        editor.putInForce(QStringLiteral("Set-point angle"));
        QTest::qWait(60);
        QCOMPARE(document.tree().step(), held);
    }
    // The whole drag is one step, after the growth before it.
    QCOMPARE(document.undoStack().count(), 2);
    editor.finish(QStringLiteral("Set-point angle"));
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() > held, kPatience);
    QCOMPARE(document.parameters().growth.setPointAngle, radians(100.0));

    // After a cancelled drag growth continues, too.
    editor.begin();
    editor.show("growth.setPointAngle", 20.0);
    editor.putInForce(QStringLiteral("Set-point angle"));
    editor.cancel();
    QCOMPARE(document.parameters().growth.setPointAngle, radians(100.0));
    const Step again = document.tree().step();
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() > again, kPatience);
    runner.cancel();
    QVERIFY(!document.areParametersHeld());
}

void GrowthRunnerTest::waitingGrowth_endsWithAnotherEdit_data()
{
    using Act = std::function<void(TreeDocument&, TimeRunner&)>;
    QTest::addColumn<Act>("act");
    QTest::newRow("travel") << Act([](TreeDocument&, TimeRunner& time) {
        time.moveTo(1);
        time.moveTo(2);
        time.release();
    });
    QTest::newRow("film") << Act([](TreeDocument&, TimeRunner& time) {
        time.play();
        time.release();
    });
    QTest::newRow("undo") << Act([](TreeDocument& document, TimeRunner&) { document.undo(); });
    QTest::newRow("prune") << Act([](TreeDocument& document, TimeRunner&) {
        Edit edit(document);
        const std::array<InternodeId, 1> cuts{2};
        edit.apply(prune(document.tree(), document.index(), cuts));
        edit.commit(QStringLiteral("Prune"));
    });
    QTest::newRow("interruption") << Act(
        [](TreeDocument& document, TimeRunner&) { document.interruptEdit(); });
}

void GrowthRunnerTest::waitingGrowth_endsWithAnotherEdit()
{
    QFETCH(std::function<void(TreeDocument&, TimeRunner&)>, act);
    TreeDocument document;
    GrowRunner runner(document);
    TimeRunner time(document);
    ParameterEditor editor(document);
    const QSignalSpy ended(&runner, &GrowthRunner::runningChanged);
    runner.run(GrowthRunner::kEndless);
    QTRY_VERIFY_WITH_TIMEOUT(document.tree().step() >= 5, kPatience);
    editor.nudge(this, "growth.setPointAngle", 60.0, QStringLiteral("Set-point angle"));
    QVERIFY(document.areParametersHeld());

    act(document, time);
    QVERIFY(!runner.isRunning() && !document.edit());
    QCOMPARE(ended.count(), 2); // began, ended
    const std::uint64_t revision = document.revision();
    QTRY_VERIFY_WITH_TIMEOUT(!document.areParametersHeld(), kPatience);
    QTest::qWait(100);
    QCOMPARE(document.revision(), revision);
    while (document.undoStack().canUndo())
        document.undo();
    QCOMPARE(document.index().livingCount(), 1U);
    QVERIFY(document.future().empty());
}

void GrowthRunnerTest::parametersChangedWhileALassoIsFilled_areTakenUp()
{
    TreeDocument document;
    LassoRunner runner(document);
    ParameterEditor editor(document);
    runner.fill(circle());
    QTRY_VERIFY_WITH_TIMEOUT(document.journal().size() >= 5, kPatience);
    TreeParameters wanted = document.parameters();
    wanted.growth.branchingAngle = radians(25);
    editor.begin();
    editor.show(wanted);
    editor.finish(QStringLiteral("Branching angle"));
    QTRY_VERIFY_WITH_TIMEOUT(!runner.isRunning(), kPatience);
    const Tree& tree = document.tree();
    std::uint32_t with = 0;
    for (InternodeId id = 0; id < tree.size(); ++id)
        with += tree.parametersOf(id) == wanted ? 1 : 0;
    QVERIFY(with > 20 && with < tree.size());
    QCOMPARE(document.undoStack().count(), 3);
    while (document.undoStack().canUndo())
        document.undoStack().undo();
    QVERIFY(document.tree().lassoIndicesInForce().empty());
    QCOMPARE(document.index().livingCount(), 1U);
}

static const test::TestClass<GrowthRunnerTest> growthRunnerTest;

#include "GrowthRunnerTest.moc"
