// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/AnotherController.h"
#include "commands/DocumentProject.h"
#include "commands/recipe/JournalRecipe.h"
#include "commands/recipe/RecipePlayer.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QCoreApplication>
#include <QIcon>
#include <QImage>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <set>

using namespace espalier;

/// The user asks for other trees like the one that was drawn, at the real window.
class AnotherTest : public test::WindowFixture {
    Q_OBJECT

public:
    AnotherTest() : WindowFixture({1200, 800}) {}

private Q_SLOTS:
    void cleanup();
    void key_showsSixTreesOfWhichOneIsTaken();
    void undo_bringsTheOwnTreeBackWithItsHistory();
    void sameTree_hasTheSameOthers();
    void takenTree_isWhatItsRecipeMakes();
    void escapeOrAChange_endsTheWork();
    void blankPage_saysWhatToDoFirst();

private:
    AnotherController& another() { return m_window->another(); }
    AnotherPanel& panel() { return workspace().another(); }
    TreeDocument& document() { return m_window->document(); }
    QToolButton& button(int number)
    {
        return *panel().findChild<QToolButton*>(QStringLiteral("another%1").arg(number));
    }
    /// Brushes a tree and cuts it, asks for others, and waits for the first @p count of them.
    void drawTree();
    void ask(int count = AnotherPanel::kCount);
    void take(int number);
};

void AnotherTest::cleanup()
{
    another().close();
    WindowFixture::cleanup();
}

void AnotherTest::drawTree()
{
    brush(0.0F, 1.2F);
    brush(0.8F, 1.4F, 0.3F);
    QTRY_COMPARE(document().undoStack().count(), 2);
}

void AnotherTest::ask(int count)
{
    QTest::keyClick(handle(), Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(panel().isVisible());
    QTRY_VERIFY_WITH_TIMEOUT(another().grownCount() >= count, 60'000);
}

void AnotherTest::take(int number)
{
    QToolButton& picture = button(number);
    QVERIFY(picture.isVisible() && picture.isEnabled());
    QTest::mouseClick(handle(), Qt::LeftButton, {}, picture.mapTo(m_window.get(), picture.rect().center()));
    QCoreApplication::processEvents();
}

void AnotherTest::key_showsSixTreesOfWhichOneIsTaken()
{
    drawTree();
    const Tree before = document().tree();
    const Camera camera = viewport().mainCamera();
    ask();
    // All of them are there, and no two are the same.
    std::set<QByteArray> pictures;
    for (int i = 0; i < AnotherPanel::kCount; ++i) {
        const QImage picture = button(i).icon().pixmap(button(i).iconSize()).toImage();
        QVERIFY(!picture.isNull());
        pictures.insert(
            QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
    }
    QCOMPARE(pictures.size(), std::size_t{AnotherPanel::kCount});
    QVERIFY(document().tree() == before);
    take(2);
    QVERIFY(!panel().isVisible());
    QCOMPARE(document().undoStack().count(), 3);
    QVERIFY(document().tree().seed() != before.seed());
    QVERIFY(document().index().livingCount() > 20);
    QVERIFY(m_window->isWindowModified());
    // The view stays, so that the two can be compared.
    QCOMPARE(viewport().mainCamera(), camera);
}

void AnotherTest::undo_bringsTheOwnTreeBackWithItsHistory()
{
    drawTree();
    const Project before = projectOf(document(), {});
    ask(3);
    take(1);
    const Project after = projectOf(document(), {});
    const auto isSame = [&](const Project& project) {
        const Project now = projectOf(document(), {});
        return now.tree == project.tree && now.journal.size() == project.journal.size() &&
               std::ranges::equal(now.journal, project.journal,
                                  [](const auto& a, const auto& b) { return *a == *b; });
    };
    // The tree that was taken is drawn on.
    brush(0.9F, 1.4F, -0.3F);
    QTRY_COMPARE(document().undoStack().count(), 4);
    const Project further = projectOf(document(), {});
    const auto undo = [&](Qt::KeyboardModifiers modifiers) {
        const int index = document().undoStack().index();
        QTest::keyClick(handle(), Qt::Key_Z, modifiers);
        QTRY_VERIFY(document().undoStack().index() != index && document().edit() == nullptr);
    };
    undo(Qt::ControlModifier);
    QVERIFY(isSame(after));
    undo(Qt::ControlModifier);
    QVERIFY(isSame(before));
    undo(Qt::ControlModifier);
    undo(Qt::ControlModifier);
    QCOMPARE(document().index().livingCount(), 1U);
    for (int i = 0; i < 2; ++i)
        undo(Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(isSame(before));
    undo(Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(isSame(after));
    undo(Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(isSame(further));
}

void AnotherTest::sameTree_hasTheSameOthers()
{
    drawTree();
    ask(1);
    take(0);
    const Tree first = document().tree();
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(document().tree() != first);
    ask(1);
    take(0);
    QVERIFY(document().tree() == first);
}

void AnotherTest::takenTree_isWhatItsRecipeMakes()
{
    drawTree();
    ask(1);
    take(0);
    const Result<Recipe> recipe = recipeOf(projectOf(document(), {}));
    QVERIFY(recipe);
    QCOMPARE(recipe->operations.size(), std::size_t{2});
    TreeDocument replayed;
    RecipePlayer(replayed, *recipe).playAll();
    QVERIFY(replayed.tree() == document().tree());
}

void AnotherTest::escapeOrAChange_endsTheWork()
{
    drawTree();
    const Tree before = document().tree();
    ask(0);
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(!panel().isVisible() && !another().isOpen());
    QTest::qWait(300);
    QVERIFY(document().tree() == before && !panel().isVisible());
    QCOMPARE(document().undoStack().count(), 2);

    ask(0);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_VERIFY(!another().isOpen());
    QVERIFY(!panel().isVisible());
    // The same key closes it, too.
    ask(0);
    QTest::keyClick(handle(), Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(!panel().isVisible());
}

void AnotherTest::blankPage_saysWhatToDoFirst()
{
    QTest::keyClick(handle(), Qt::Key_A, Qt::ShiftModifier);
    QVERIFY(!panel().isVisible());
    QVERIFY(!notice().isEmpty());
}

static const test::TestClass<AnotherTest> anotherTest;

#include "AnotherTest.moc"
