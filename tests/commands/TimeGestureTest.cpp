// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TimeGesture.h"

#include "commands/DocumentProject.h"
#include "commands/Prune.h"
#include "commands/SetParameters.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"

#include <QTest>

#include <array>

namespace espalier::test {

class TimeGestureTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void backAndForth_passesEveryMomentAgain();
    void cancel_returnsToTheMomentBefore();
    void travels_areOneUndoStep();
    void beyondThePresent_theTreeGrows();
    void editAtAnEarlierMoment_isUndoneWithTheLostFuture();
    void undoAndRedo_throughTravelsAndEdits();
    void projectFile_keepsTheFuture();
    void thousandSteps_thereAndBack();

private:
    void plant(std::uint64_t seed);
    void travel(std::size_t position)
    {
        TimeGesture gesture(*m_document);
        gesture.moveTo(position);
        gesture.finish();
    }
    std::size_t position() const { return m_document->journal().size(); }

    std::unique_ptr<TreeDocument> m_document;
};

/// A tree that was grown, brushed, pruned and given other parameters.
void TimeGestureTest::plant(std::uint64_t seed)
{
    m_document = std::make_unique<TreeDocument>();
    growAtRandom(*m_document, seed, 60, 300);
    pruneBranches(*m_document, std::array{InternodeId{9}});
    grow(*m_document, 3);
}

void TimeGestureTest::backAndForth_passesEveryMomentAgain()
{
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        plant(seed);
        const std::size_t end = position();
        std::vector<Tree> moments(end + 1);
        TimeGesture gesture(*m_document);
        for (std::size_t i = end + 1; i-- > 0;) {
            gesture.moveTo(i);
            moments[i] = m_document->tree();
        }
        QCOMPARE(m_document->index().livingCount(), 1U);
        Random random(seed, 0, 0, Purpose::Direction);
        for (int jump = 0; jump < 40; ++jump) {
            const std::size_t to = random.bits() % (end + 1);
            gesture.moveTo(to);
            QVERIFY(m_document->tree() == moments[to]);
            QCOMPARE(indexFault(*m_document), QString());
        }
        gesture.cancel();
    }
}

void TimeGestureTest::cancel_returnsToTheMomentBefore()
{
    plant(6);
    const DocumentState before(*m_document);
    {
        TimeGesture gesture(*m_document);
        gesture.moveTo(2);
        gesture.moveTo(gesture.historyLength() + 3);
    }
    QCOMPARE(differenceFrom(before, *m_document), QString());
    QCOMPARE(m_document->undoStack().index(), before.undoIndex);
    QVERIFY(m_document->future().empty());
}

void TimeGestureTest::travels_areOneUndoStep()
{
    plant(7);
    const DocumentState before(*m_document);
    const std::size_t end = position();
    travel(end - 3);
    travel(end - 5);
    QCOMPARE(m_document->undoStack().count(), before.undoIndex + 1);
    QCOMPARE(m_document->future().size(), std::size_t{5});
    m_document->undoStack().undo();
    QVERIFY(DocumentState(*m_document) == before);
    m_document->undoStack().redo();
    QCOMPARE(position(), end - 5);
    // Back at the present, there is nothing to undo.
    travel(end);
    QCOMPARE(m_document->undoStack().index(), before.undoIndex);
    QVERIFY(DocumentState(*m_document) == before);
}

void TimeGestureTest::beyondThePresent_theTreeGrows()
{
    plant(8);
    const DocumentState before(*m_document);
    const std::size_t end = position();
    travel(end - 4);
    TimeGesture gesture(*m_document);
    QCOMPARE(gesture.historyLength(), end);
    gesture.moveTo(end + 3);
    QCOMPARE(position(), end + 3);
    gesture.moveTo(end + 1);
    gesture.moveTo(end + 2);
    gesture.finish();
    QCOMPARE(position(), end + 2);
    QVERIFY(m_document->future().empty());
    while (m_document->undoStack().index() > before.undoIndex)
        m_document->undoStack().undo();
    QCOMPARE(differenceFrom(before, *m_document), QString());
}

void TimeGestureTest::editAtAnEarlierMoment_isUndoneWithTheLostFuture()
{
    plant(9);
    const DocumentState before(*m_document);
    const std::size_t end = position();
    travel(end - 4);
    grow(*m_document, 2);
    QVERIFY(m_document->future().empty());
    QCOMPARE(position(), end - 2);
    const Tree other = m_document->tree();
    QCOMPARE(m_document->undoStack().count(), before.undoIndex + 1);
    m_document->undoStack().undo();
    QCOMPARE(differenceFrom(before, *m_document), QString());
    QCOMPARE(position(), end);
    m_document->undoStack().redo();
    QVERIFY(m_document->tree() == other);
    QVERIFY(m_document->future().empty());
}

void TimeGestureTest::undoAndRedo_throughTravelsAndEdits()
{
    for (std::uint64_t seed = 20; seed < 26; ++seed) {
        plant(seed);
        Random random(seed, 1, 0, Purpose::Direction);
        for (int i = 0; i < 12; ++i) {
            travel(random.bits() % (position() + m_document->future().size() + 1));
            if (i % 3 == 0)
                grow(*m_document, 2);
            if (i % 4 == 1)
                pruneBranches(*m_document, std::array{static_cast<InternodeId>(random.bits() % 40)});
        }
        const DocumentState whole(*m_document);
        const std::size_t future = m_document->future().size();
        QUndoStack& stack = m_document->undoStack();
        while (stack.canUndo())
            stack.undo();
        QCOMPARE(m_document->index().livingCount(), 1U);
        QCOMPARE(indexFault(*m_document), QString());
        while (stack.canRedo())
            stack.redo();
        QVERIFY(DocumentState(*m_document) == whole);
        QCOMPARE(m_document->future().size(), future);
        QCOMPARE(indexFault(*m_document), QString());
    }
}

void TimeGestureTest::projectFile_keepsTheFuture()
{
    plant(30);
    const Tree present = m_document->tree();
    const std::size_t end = position();
    travel(end - 6);
    const Tree shown = m_document->tree();
    const Result<QByteArray> packed = packProject(projectOf(*m_document, QStringLiteral("ash")));
    QVERIFY(packed);
    Result<Project> project = unpackProject(*packed);
    QVERIFY2(project, project ? "" : qPrintable(project.error().message));
    QVERIFY(shownTree(*project) == shown);
    TreeDocument opened;
    showProject(opened, std::move(*project));
    QVERIFY(opened.tree() == shown);
    QCOMPARE(opened.future().size(), std::size_t{6});
    TimeGesture gesture(opened);
    gesture.moveTo(end);
    QVERIFY(opened.tree() == present);
    gesture.moveTo(0);
    QCOMPARE(opened.index().livingCount(), 1U);
    gesture.cancel();
    QCOMPARE(opened.future().size(), std::size_t{6});
    // An edit at an earlier moment of an opened file starts another future as well, and is one step with the
    // travel there.
    opened.undoStack().undo();
    const DocumentState before(opened);
    QVERIFY(before.tree == present);
    opened.undoStack().redo();
    grow(opened, 1);
    QVERIFY(opened.future().empty());
    const DocumentState after(opened);
    opened.undoStack().undo();
    QCOMPARE(differenceFrom(before, opened), QString());
    opened.undoStack().redo();
    QCOMPARE(differenceFrom(after, opened), QString());
}

void TimeGestureTest::thousandSteps_thereAndBack()
{
    m_document = std::make_unique<TreeDocument>();
    grow(*m_document, 6);
    TreeParameters parameters = m_document->parameters();
    for (int i = 0; i < 1000; ++i) {
        parameters.widths.exponent = i % 2 == 0 ? 2.5 : 2.0;
        setParameters(*m_document, parameters);
    }
    const Tree present = m_document->tree();
    const std::size_t end = position();
    QVERIFY(end >= 1000);
    TimeGesture gesture(*m_document);
    gesture.moveTo(0);
    QCOMPARE(m_document->index().livingCount(), 1U);
    gesture.moveTo(end);
    QVERIFY(m_document->tree() == present);
    gesture.cancel();
}

const TestClass<TimeGestureTest> timeGestureTest;

} // namespace espalier::test

#include "TimeGestureTest.moc"
