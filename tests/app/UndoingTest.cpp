// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/project/ProjectFile.h"
#include "panels/HistoryPanel.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QUndoView>

using namespace espalier;

/// A person who undoes and redoes what takes longer than a frame.
class UndoingTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void largeGrow_isUndoneAndRedoneWhileTheWindowLives();
    void smallCommand_isUndoneInTheSameEvent();
    void keysInQuickSuccession_giveTheRightTree();
    void stroke_beginsOnTheUndoneTree();
    void save_writesTheUndoneTree();
    void history_goesFarInSlices();

private:
    TreeDocument& document() { return m_window->document(); }
    UndoRunner& runner() { return m_window->undoRunner(); }
    /// A command of a few hundred rows.
    void growLittle();
    /// A command of many thousand rows.
    void growMuch();
    void undo() { QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier); }
    void redo() { QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    void waitForRest() { QTRY_VERIFY_WITH_TIMEOUT(!runner().isRunning(), 30'000); }
};

void UndoingTest::growLittle()
{
    QVERIFY(test::grow(document(), 6) > 0);
    QVERIFY(document().index().livingCount() < GradualUndo::kLeastRows);
}

void UndoingTest::growMuch()
{
    GrowGesture growth(document());
    const std::uint32_t wanted = document().index().livingCount() + 12'000;
    while (document().index().livingCount() < wanted)
        QVERIFY(growth.step());
    growth.finish();
    // On a fast machine as well, undoing it takes several slices.
    runner().setSlice(std::chrono::milliseconds(0));
}

void UndoingTest::largeGrow_isUndoneAndRedoneWhileTheWindowLives()
{
    growMuch();
    const test::DocumentState whole(document());
    const std::uint32_t grown = document().index().livingCount();
    for (const bool isUndone : {true, false}) {
        int turns = 0;
        bool isHalfSeen = false;
        QTimer beat;
        connect(&beat, &QTimer::timeout, this, [&] {
            const std::uint32_t count = document().index().livingCount();
            if (runner().isRunning())
                ++turns;
            isHalfSeen = isHalfSeen || (count > 100 && count < grown - 100);
        });
        beat.start(0);
        isUndone ? undo() : redo();
        QVERIFY(runner().isRunning());
        waitForRest();
        beat.stop();
        QVERIFY2(turns >= 3, qPrintable(QString::number(turns)));
        QVERIFY(isHalfSeen);
        QCOMPARE(document().undoStack().index(), isUndone ? 0 : 1);
        if (isUndone)
            QCOMPARE(document().tree().size(), 1U);
    }
    QCOMPARE(test::differenceFrom(whole, document()), QString());
}

void UndoingTest::smallCommand_isUndoneInTheSameEvent()
{
    growLittle();
    undo();
    QVERIFY(!runner().isRunning());
    QCOMPARE(document().tree().size(), 1U);
    redo();
    QVERIFY(!runner().isRunning());
    QVERIFY(document().tree().size() > 1);
}

void UndoingTest::keysInQuickSuccession_giveTheRightTree()
{
    growLittle();
    growMuch();
    const test::DocumentState second(document());
    growMuch();
    undo();
    QVERIFY(runner().isRunning());
    undo();
    QVERIFY(runner().isRunning());
    QCOMPARE(document().undoStack().index(), 2);
    redo();
    QCOMPARE(document().undoStack().index(), 1);
    waitForRest();
    QCOMPARE(test::differenceFrom(second, document()), QString());
}

void UndoingTest::stroke_beginsOnTheUndoneTree()
{
    growLittle();
    const test::DocumentState first(document());
    growMuch();
    viewport().frameAll();
    undo();
    QVERIFY(runner().isRunning());
    brush(0.3F, 1.6F);
    QVERIFY(!runner().isRunning());
    QCOMPARE(document().undoStack().count(), 2);
    QVERIFY(document().undoStack().undoText().startsWith(QStringLiteral("Brush Stroke")));
    undo();
    waitForRest();
    QCOMPARE(test::differenceFrom(first, document()), QString());
}

void UndoingTest::save_writesTheUndoneTree()
{
    const QString file = m_folder->filePath(QStringLiteral("undone.espalier"));
    growLittle();
    const Tree first = document().tree();
    growMuch();
    save(file);
    undo();
    QVERIFY(runner().isRunning());
    QSignalSpy saved(&m_window->files().file(), &DocumentFile::saved);
    QTest::keyClick(handle(), Qt::Key_S, Qt::ControlModifier);
    QVERIFY(saved.count() == 1 || saved.wait(30'000));
    const Result<Project> project = loadProject(file);
    QVERIFY(project);
    QVERIFY(project->tree == first);
    QVERIFY(!m_window->files().file().isModified());
}

void UndoingTest::history_goesFarInSlices()
{
    growLittle();
    const test::DocumentState first(document());
    growMuch();
    growMuch();
    action(ActionId::History)->trigger();
    auto* list = m_window->findChild<QUndoView*>(QStringLiteral("history"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, {},
                      list->visualRect(list->model()->index(1, 0)).center());
    QVERIFY(runner().isRunning());
    waitForRest();
    action(ActionId::History)->trigger();
    QCOMPARE(test::differenceFrom(first, document()), QString());
    QCOMPARE(list->currentIndex().row(), 1);
}

static const test::TestClass<UndoingTest> undoingTest;

#include "UndoingTest.moc"
