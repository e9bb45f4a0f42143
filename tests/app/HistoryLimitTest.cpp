// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HistoryLimit.h"

#include "app/ProfileController.h"
#include "app/files/FileController.h"
#include "commands/Prune.h"
#include "commands/WidthGesture.h"
#include "panels/Notice.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QPushButton>
#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// A person whose history takes more memory than it may.
class HistoryLimitTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void oldSteps_goWithANotice();
    void shortening_waitsForTheHand();
    void noticeOfIt_waitsForAQuestion();
    void chosenSection_staysChosen();
    void strands_stayInSight();
    void safetyCopy_hasTheShortenedTree();

private:
    TreeDocument& document() { return m_window->document(); }
    void work()
    {
        for (int i = 0; i < 25; ++i)
            QVERIFY(test::grow(document(), 1) > 0);
    }
};

void HistoryLimitTest::oldSteps_goWithANotice()
{
    work();
    const std::uint32_t living = document().index().livingCount();
    const Vec3 target = viewport().mainCamera().target();
    m_window->historyLimit().setMost(2);
    QTRY_VERIFY(document().undoStack().count() < 25);
    QVERIFY2(notice().contains(QStringLiteral("oldest steps")), qPrintable(notice()));
    QCOMPARE(document().index().livingCount(), living);
    QCOMPARE(test::indexFault(document()), QString());
    QVERIFY(viewport().mainCamera().target() == target);
    QVERIFY(m_window->isWindowModified());
    // The window goes on with the tree.
    action(ActionId::Undo)->trigger();
    QTRY_VERIFY(document().index().livingCount() < living);
    brush();
    QCOMPARE(test::indexFault(document()), QString());
}

void HistoryLimitTest::shortening_waitsForTheHand()
{
    work();
    QTest::mousePress(handle(), Qt::LeftButton, {}, at(0.0F, 0.2F));
    QTest::mouseMove(handle(), at(0.0F, 0.6F));
    QTRY_VERIFY(viewport().isGestureActive());
    const int steps = document().undoStack().count();
    m_window->historyLimit().setMost(3);
    QTest::qWait(400);
    QCOMPARE(document().undoStack().count(), steps);
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, at(0.0F, 0.6F));
    QTRY_VERIFY(document().undoStack().count() < steps);
}

void HistoryLimitTest::noticeOfIt_waitsForAQuestion()
{
    work();
    int chosen = -1;
    workspace().notice().ask(QStringLiteral("Well?"), {QStringLiteral("Yes"), QStringLiteral("No")},
                             [&chosen](int answer) { chosen = answer; });
    m_window->historyLimit().setMost(4);
    QTRY_VERIFY(document().undoStack().count() < 25);
    QCOMPARE(notice(), QStringLiteral("Well?"));
    const auto buttons = workspace().notice().findChildren<QPushButton*>();
    QTest::mouseClick(buttons.front(), Qt::LeftButton);
    QCOMPARE(chosen, 0);
    QTRY_VERIFY(notice().contains(QStringLiteral("oldest steps")));
}

void HistoryLimitTest::chosenSection_staysChosen()
{
    // The first branch dies, so that all that comes later gets other ids.
    makeTree();
    pruneBranches(document(), {{document().tree().size() - 1}});
    work();
    const Tree& tree = document().tree();
    const InternodeId old = tree.size() - 1;
    QVERIFY(tree.isAlive(old));
    const InternodeKey key = tree.key(old);
    action(ActionId::Profile)->trigger();
    m_window->profiles().choose(old);
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    m_window->historyLimit().setMost(5);
    QTRY_VERIFY(document().undoStack().count() < 25);
    QVERIFY(m_window->profiles().chosen());
    QVERIFY(*m_window->profiles().chosen() < old);
    QCOMPARE(tree.key(*m_window->profiles().chosen()), key);
    QTRY_VERIFY(m_window->profiles().isUpToDate());
    QVERIFY(m_window->profiles().section());
}

void HistoryLimitTest::strands_stayInSight()
{
    TreeParameters parameters = document().parameters();
    parameters.wood.mesher = WoodMesherKind::Strands;
    document().reset(3, parameters);
    test::grow(document(), 6);
    pruneBranches(document(), {{document().tree().size() - 1}});
    for (int i = 0; i < 25; ++i)
        setWidth(document(), 1, 0.02 + 0.001 * i);
    QTRY_VERIFY_WITH_TIMEOUT(viewport().shownStrands() && !m_window->strandRunner().isRunning(), 20'000);
    std::shared_ptr<const StrandWood> before;
    bool areThere = false;
    const QObject whileHere;
    connect(&m_window->historyLimit(), &HistoryLimit::scenePrepared, &whileHere,
            [&] { before = viewport().shownStrands()->wood; });
    connect(&document(), &TreeDocument::changed, &whileHere, [&](const TreeChange& change) {
        if (change.internodes)
            areThere = viewport().shownStrands() && viewport().shownStrands()->wood == before;
    });
    m_window->historyLimit().setMost(6);
    QTRY_VERIFY(document().undoStack().count() < 25);
    QVERIFY(areThere);
}

void HistoryLimitTest::safetyCopy_hasTheShortenedTree()
{
    work();
    QSignalSpy written(&m_window->files().autosave(), &Autosave::written);
    m_window->historyLimit().setMost(4);
    QTRY_VERIFY(document().undoStack().count() < 25);
    QVERIFY(test::grow(document(), 1) > 0);
    written.clear();
    QTRY_VERIFY(!written.isEmpty());
    QVERIFY(m_window->files().autosave().leave());
    const QDir folder(Autosave::folder());
    const QStringList names = folder.entryList({QStringLiteral("*.espalier")}, QDir::Files, QDir::Time);
    QVERIFY(!names.isEmpty());
    const Result<Project> copy = SafetyCopy::ofProject(folder.filePath(names.front())).read();
    QVERIFY2(copy, copy ? "" : qPrintable(copy.error().message));
    QVERIFY(copy->tree == document().tree());
    QCOMPARE(copy->journal.size(), document().journal().size());
}

static const test::TestClass<HistoryLimitTest> historyLimitTest;

#include "HistoryLimitTest.moc"
