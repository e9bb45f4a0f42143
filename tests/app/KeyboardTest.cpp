// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/GrowPopOut.h"
#include "panels/ParameterNumber.h"
#include "panels/ParameterRow.h"
#include "panels/ParameterSlider.h"
#include "panels/architecture/ArchitecturePanel.h"
#include "panels/architecture/Diagram.h"
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QPoint>
#include <QPushButton>
#include <QSpinBox>
#include <QTest>
#include <QUndoView>

using namespace espalier;

/// Keys mean the same whatever the user touched before, because the tree gets the keyboard back.
class KeyboardTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void enterInANumber_givesTheKeysBack();
    void escapeInANumber_restoresItAndGivesTheKeysBack();
    void undoInANumber_undoesTheTree();
    void undoWhileANumberIsTyped_undoesTheTyping();
    void pressBesideANumber_givesTheKeysBack();
    void arrowsAfterADrag_turnTheView();
    void arrowsAfterAChoice_turnTheView();
    void arrowsAfterAHandle_turnTheView();
    void arrowsAfterTheHistory_turnTheView();
    void arrowsAfterTab_moveTheSlider();
    void closedSheet_givesTheKeysBack();

private:
    bool hasTreeKeys() { return QApplication::focusWidget() == &viewport(); }
    void click(const QWidget& widget) { click(widget, widget.rect().center()); }
    void click(const QWidget& widget, const QPoint& place)
    {
        QTest::mouseClick(handle(), Qt::LeftButton, {}, widget.mapTo(m_window.get(), place));
        QCoreApplication::processEvents();
    }
    /// Clicks the number and types over it.
    void type(const QWidget& number, const char* text)
    {
        click(number);
        QTRY_COMPARE(QApplication::focusWidget(), &number);
        QTest::keyClick(handle(), Qt::Key_A, Qt::ControlModifier);
        for (const char* letter = text; *letter != '\0'; ++letter)
            QTest::keyClick(handle(), *letter);
    }
    /// Whether an arrow key turns the view.
    bool doArrowsTurn()
    {
        const float before = viewport().mainCamera().azimuth();
        QTest::keyClick(handle(), Qt::Key_Right);
        return viewport().mainCamera().azimuth() != before;
    }
    ParameterRow& row(const char* key)
    {
        action(ActionId::LeafSheet)->setChecked(false);
        action(ActionId::LeafSheet)->trigger();
        for (auto* row : workspace().sheet(2).findChildren<ParameterRow*>()) {
            if (QByteArray(row->key()) == key)
                return *row;
        }
        qFatal("no such row");
    }
};

void KeyboardTest::enterInANumber_givesTheKeysBack()
{
    action(ActionId::Grow)->trigger();
    auto* count = workspace().growPopOut().findChild<QSpinBox*>();
    type(*count, "7");
    QTest::keyClick(handle(), Qt::Key_Return);
    QVERIFY(hasTreeKeys());
    QCOMPARE(count->value(), 7);
    QTest::keyClick(handle(), Qt::Key_P);
    QVERIFY(action(ActionId::Prune)->isChecked());
}

void KeyboardTest::escapeInANumber_restoresItAndGivesTheKeysBack()
{
    ParameterRow& breadth = row("leaves.aspect");
    auto* number = breadth.findChild<ParameterNumber*>();
    const double before = number->value();
    type(*number, "9");
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(hasTreeKeys());
    QCOMPARE(number->value(), before);
    QVERIFY(number->isVisible());
    QCOMPARE(m_window->document().undoStack().count(), 0);
    // The next one closes the sheet.
    QTest::keyClick(handle(), Qt::Key_Escape);
    QVERIFY(!number->isVisible());
}

void KeyboardTest::undoInANumber_undoesTheTree()
{
    makeTree();
    const int done = m_window->document().undoStack().index();
    ParameterRow& breadth = row("leaves.aspect");
    auto* number = breadth.findChild<ParameterNumber*>();
    click(*number);
    QCOMPARE(QApplication::focusWidget(), number);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(m_window->document().undoStack().index(), done - 1);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QTRY_COMPARE(m_window->document().undoStack().index(), done);
}

void KeyboardTest::undoWhileANumberIsTyped_undoesTheTyping()
{
    makeTree();
    const int done = m_window->document().undoStack().index();
    ParameterRow& breadth = row("leaves.aspect");
    auto* number = breadth.findChild<ParameterNumber*>();
    const QString shown = number->text();
    type(*number, "9");
    QVERIFY(number->text() != shown);
    QTest::keyClick(handle(), Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_window->document().undoStack().index(), done);
    QVERIFY(number->text() != QStringLiteral("9"));
}

void KeyboardTest::pressBesideANumber_givesTheKeysBack()
{
    makeTree();
    action(ActionId::Grow)->trigger();
    auto* count = workspace().growPopOut().findChild<QSpinBox*>();
    auto* steps = workspace().growPopOut().findChild<QPushButton*>(QStringLiteral("growSteps"));
    const Step before = m_window->document().tree().step();
    type(*count, "3");
    click(*steps);
    QVERIFY(hasTreeKeys());
    QTRY_COMPARE(m_window->document().tree().step(), before + 3);
    QVERIFY(doArrowsTurn());
}

void KeyboardTest::arrowsAfterADrag_turnTheView()
{
    ParameterRow& breadth = row("leaves.aspect");
    auto* slider = breadth.findChild<ParameterSlider*>();
    click(*slider, {slider->width() / 4, slider->height() / 2});
    const double moved = breadth.value();
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(doArrowsTurn());
    QCOMPARE(breadth.value(), moved);
}

void KeyboardTest::arrowsAfterAChoice_turnTheView()
{
    action(ActionId::Background)->setChecked(false);
    action(ActionId::Background)->trigger();
    auto* choice = workspace().sheet(4).findChild<QComboBox*>();
    click(*choice);
    QTRY_VERIFY(QApplication::activePopupWidget());
    QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_Escape);
    QTRY_VERIFY(!QApplication::activePopupWidget());
    QTRY_VERIFY(hasTreeKeys());
    const int chosen = choice->currentIndex();
    QVERIFY(doArrowsTurn());
    QCOMPARE(choice->currentIndex(), chosen);
}

void KeyboardTest::arrowsAfterAHandle_turnTheView()
{
    action(ActionId::Architecture)->setChecked(false);
    action(ActionId::Architecture)->trigger();
    Diagram* tropism = workspace().architecture().diagrams().front();
    const QPoint from = tropism->handlePlace(0).toPoint();
    QTest::mousePress(handle(), Qt::LeftButton, {}, tropism->mapTo(m_window.get(), from));
    QTest::mouseMove(handle(), tropism->mapTo(m_window.get(), from + QPoint(0, 40)));
    QTest::mouseRelease(handle(), Qt::LeftButton, {}, tropism->mapTo(m_window.get(), from + QPoint(0, 40)));
    QCoreApplication::processEvents();
    QCOMPARE(m_window->document().undoStack().count(), 1);
    QVERIFY(doArrowsTurn());
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void KeyboardTest::arrowsAfterTheHistory_turnTheView()
{
    makeTree();
    action(ActionId::History)->trigger();
    auto* list = m_window->findChild<QUndoView*>(QStringLiteral("history"));
    click(*list->viewport(), list->visualRect(list->model()->index(list->currentIndex().row(), 0)).center());
    const int index = m_window->document().undoStack().index();
    QVERIFY(doArrowsTurn());
    QTest::keyClick(handle(), Qt::Key_Up);
    QCOMPARE(m_window->document().undoStack().index(), index);
    action(ActionId::History)->trigger();
}

void KeyboardTest::arrowsAfterTab_moveTheSlider()
{
    const auto* slider = row("leaves.aspect").findChild<ParameterSlider*>();
    QTest::keyClick(handle(), Qt::Key_F6);
    for (int i = 0; i < 30 && QApplication::focusWidget() != slider; ++i)
        QTest::keyClick(handle(), Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), slider);
    const int before = slider->value();
    QVERIFY(!doArrowsTurn());
    QVERIFY(slider->value() != before);
    // A click there changes nothing of that; Enter gives the keyboard back.
    click(*slider, {slider->width() / 2, slider->height() / 2});
    QCOMPARE(QApplication::focusWidget(), slider);
    QTest::keyClick(handle(), Qt::Key_Return);
    QVERIFY(hasTreeKeys());
}

void KeyboardTest::closedSheet_givesTheKeysBack()
{
    row("leaves.aspect");
    QTest::keyClick(handle(), Qt::Key_F6);
    QTRY_VERIFY(workspace().sheet(2).isAncestorOf(QApplication::focusWidget()));
    QTest::keyClick(handle(), Qt::Key_3, Qt::ControlModifier);
    QTRY_VERIFY(hasTreeKeys());
}

static const test::TestClass<KeyboardTest> keyboardTest;

#include "KeyboardTest.moc"
