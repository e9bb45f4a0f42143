// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ParameterGesture.h"

#include "commands/GrowGesture.h"
#include "commands/SetParameters.h"
#include "tests/support/TestClasses.h"

#include <QTest>

using namespace espalier;

class ParameterGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void manyTrials_areOneUndoStepAndRememberOneParameterSet();
    void aTrialOfWhatWasBefore_leavesNothing();
    void undoBetweenTrials_isNotUndoneByTheNextTrial();
    void anotherCommandBetweenTrials_stays();
    void finish_beginsAnotherUndoStep();
};

namespace {

TreeParameters withLeaves(double metres)
{
    TreeParameters parameters;
    parameters.leaves.length = metres;
    return parameters;
}

} // namespace

void ParameterGestureTest::manyTrials_areOneUndoStepAndRememberOneParameterSet()
{
    TreeDocument document;
    const Tree before = document.tree();
    ParameterGesture gesture(document);
    for (const double length : {0.1, 0.2, 0.3}) {
        gesture.tryOut(withLeaves(length), QStringLiteral("Length"));
        QCOMPARE(document.parameters().leaves.length, length);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.tree().parameterSets().size(), 2);
        QCOMPARE(document.journal().size(), std::size_t{1});
    }
    QCOMPARE(document.undoStack().undoText(), QStringLiteral("Length"));
    const Tree after = document.tree();

    document.undoStack().undo();
    QCOMPARE(document.parameters(), before.parameters());
    document.undoStack().redo();
    QVERIFY(document.tree() == after);
}

void ParameterGestureTest::aTrialOfWhatWasBefore_leavesNothing()
{
    TreeDocument document;
    const Tree before = document.tree();
    ParameterGesture gesture(document);
    gesture.tryOut(withLeaves(0.2), QStringLiteral("Length"));
    gesture.tryOut(before.parameters(), QStringLiteral("Length"));
    QVERIFY(document.tree() == before);
    QCOMPARE(document.undoStack().count(), 0);
    QVERIFY(document.journal().empty());
}

void ParameterGestureTest::undoBetweenTrials_isNotUndoneByTheNextTrial()
{
    TreeDocument document;
    setParameters(document, withLeaves(0.5));
    ParameterGesture gesture(document);
    gesture.tryOut(withLeaves(0.2), QStringLiteral("Length"));
    document.undoStack().undo();
    gesture.tryOut(withLeaves(0.3), QStringLiteral("Length"));
    QCOMPARE(document.undoStack().index(), 2);
    document.undoStack().undo();
    QCOMPARE(document.parameters().leaves.length, 0.5);
}

void ParameterGestureTest::anotherCommandBetweenTrials_stays()
{
    TreeDocument document;
    ParameterGesture gesture(document);
    gesture.tryOut(withLeaves(0.2), QStringLiteral("Length"));
    GrowGesture growth(document);
    QVERIFY(growth.step());
    growth.finish();
    const Step grown = document.tree().step();
    gesture.tryOut(withLeaves(0.3), QStringLiteral("Length"));
    QCOMPARE(document.undoStack().count(), 3);
    QCOMPARE(document.tree().step(), grown);
}

void ParameterGestureTest::finish_beginsAnotherUndoStep()
{
    TreeDocument document;
    ParameterGesture gesture(document);
    gesture.tryOut(withLeaves(0.2), QStringLiteral("Length"));
    gesture.finish();
    gesture.tryOut(withLeaves(0.3), QStringLiteral("Length"));
    QCOMPARE(document.undoStack().count(), 2);
    document.undoStack().undo();
    QCOMPARE(document.parameters().leaves.length, 0.2);
}

static const test::TestClass<ParameterGestureTest> parameterGestureTest;

#include "ParameterGestureTest.moc"
