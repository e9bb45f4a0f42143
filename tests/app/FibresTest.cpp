// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/Notice.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QAction>
#include <QTest>

using namespace espalier;

/// The user at the real window looks at the strands as fibres.
class FibresTest : public test::WindowFixture {
    Q_OBJECT

public:
    FibresTest() : WindowFixture({1000, 800}) {}

private Q_SLOTS:
    void key_showsTheStrandsInPlaceOfTheBark();
    void fibres_followTheTree();
    void progressOfAnotherTask_isLeftAlone();

private:
    void waitForRest()
    {
        QTRY_VERIFY_WITH_TIMEOUT(
            !m_window->isBusy() && !m_window->strandRunner().isRunning() && viewport().isAtRest(), 30'000);
    }
    /// Pixels of strong colours that no bark has: blue, or magenta.
    int colouredPixels()
    {
        const QImage picture = viewport().grabPicture().convertToFormat(QImage::Format_RGB32);
        int count = 0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                const QColor colour(picture.pixel(x, y));
                const bool isVivid = colour.saturation() > 110 && colour.value() > 70;
                count += isVivid && colour.hue() > 180 && colour.hue() < 340 ? 1 : 0;
            }
        }
        return count;
    }
    void grow()
    {
        makeTree();
        m_window->viewSettings().set(&ViewValues::leavesShown, false);
        waitForRest();
    }
};

void FibresTest::key_showsTheStrandsInPlaceOfTheBark()
{
    grow();
    const int before = colouredPixels();
    QTest::keyClick(handle(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(action(ActionId::Fibres)->isChecked());
    waitForRest();
    const int shown = colouredPixels();
    QVERIFY2(shown > before + 150, qPrintable(QStringLiteral("%1, %2").arg(before).arg(shown)));
    QTest::keyClick(handle(), Qt::Key_F, Qt::ShiftModifier);
    QVERIFY(!action(ActionId::Fibres)->isChecked());
    waitForRest();
    QCOMPARE(colouredPixels(), before);
}

void FibresTest::fibres_followTheTree()
{
    m_window->viewSettings().set(&ViewValues::fibresShown, true);
    grow();
    const int shown = colouredPixels();
    QVERIFY2(shown > 150, qPrintable(QString::number(shown)));
    while (m_window->document().undoStack().canUndo())
        action(ActionId::Undo)->trigger();
    waitForRest();
    QVERIFY(colouredPixels() < shown / 3);
    m_window->viewSettings().set(&ViewValues::fibresShown, false);
    m_window->viewSettings().set(&ViewValues::leavesShown, true);
}

void FibresTest::progressOfAnotherTask_isLeftAlone()
{
    Notice& shown = workspace().notice();
    StrandRunner& runner = m_window->strandRunner();
    Q_EMIT runner.progressed(0.3);
    QVERIFY(shown.showsProgressOf(runner));
    const QString words = shown.text();
    Q_EMIT runner.ended();
    QVERIFY(shown.isHidden());
    // Another task that happens to say the same.
    shown.showProgress(*this, words, 0.5);
    Q_EMIT runner.progressed(0.4);
    Q_EMIT runner.ended();
    QVERIFY(shown.showsProgressOf(*this));
    shown.finishProgress(*this);
    QVERIFY(shown.isHidden());
    // A message stays as well.
    shown.showWarning(words);
    Q_EMIT runner.progressed(0.4);
    Q_EMIT runner.ended();
    QVERIFY(shown.isVisible() && shown.isWarning());
    shown.finish();
}

namespace {
const test::TestClass<FibresTest> fibresTest;
}

#include "FibresTest.moc"
