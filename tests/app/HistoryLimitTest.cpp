// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/HistoryLimit.h"

#include "app/files/FileController.h"
#include "tests/support/Documents.h"
#include "tests/support/Growing.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// A person whose history takes more memory than it may.
class HistoryLimitTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void oldSteps_goWithANotice();
    void shortening_waitsForTheHand();
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
    QVERIFY(!QDir(Autosave::folder()).entryList({QStringLiteral("*.espalier")}).isEmpty());
}

static const test::TestClass<HistoryLimitTest> historyLimitTest;

#include "HistoryLimitTest.moc"
