// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/TestClasses.h"
#include "tests/support/WindowFixture.h"
#include "views/Viewport.h"

#include <QChar>
#include <QCoreApplication>
#include <QEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>

using namespace espalier;

/// Keyboards without Latin letters: events as X11 gives them with only a Cyrillic, Greek or Hebrew layout,
/// with the letter of that layout and the code of the key.
class LayoutKeysTest : public test::WindowFixture {
    Q_OBJECT

private Q_SLOTS:
    void undoAndRedo_areWhereTheyAlwaysAre_data();
    void undoAndRedo_areWhereTheyAlwaysAre();
    void toolKeys_takeTheirTools_data();
    void toolKeys_takeTheirTools();
    void save_saves();
    void signAtTheLettersPlace_isTheLetter();
    void cameraKeys_turnTheView();
    void latinLayouts_areLeftAlone();
    void textField_takesWhatIsTyped();
    void textField_knowsItsShortcuts();

private:
    /// A key whose letter is @p letter, a capital; @p code is that of X11, 0 for unknown.
    void key(QEvent::Type type, char16_t letter, quint32 code, Qt::KeyboardModifiers modifiers = {});
    void click(char16_t letter, quint32 code, Qt::KeyboardModifiers modifiers = {})
    {
        key(QEvent::KeyPress, letter, code, modifiers);
        key(QEvent::KeyRelease, letter, code, modifiers);
    }
};

void LayoutKeysTest::key(QEvent::Type type, char16_t letter, quint32 code, Qt::KeyboardModifiers modifiers)
{
    QVERIFY2(QGuiApplication::platformName() == QStringLiteral("xcb"),
             "the codes are those of X11: run this test with xvfb-run -a and QT_QPA_PLATFORM=xcb");
    const QChar shown(letter);
    const QString text(modifiers.testFlag(Qt::ShiftModifier) ? shown : shown.toLower());
    // Qt offers a key to the focus and to shortcuts before it sends it to the window.
    if (type == QEvent::KeyPress) {
        QKeyEvent offered(QEvent::ShortcutOverride, letter, modifiers, code, 0, 0, text);
        offered.ignore();
        QCoreApplication::sendEvent(handle(), &offered);
    }
    QKeyEvent event(type, letter, modifiers, code, 0, 0, text);
    QCoreApplication::sendEvent(handle(), &event);
}

void LayoutKeysTest::undoAndRedo_areWhereTheyAlwaysAre_data()
{
    QTest::addColumn<char16_t>("letter");
    QTest::addColumn<quint32>("code");
    QTest::newRow("Russian") << u'Я' << 52U;
    QTest::newRow("Greek") << u'Ζ' << 52U;
    QTest::newRow("Hebrew") << u'ז' << 52U;
    QTest::newRow("Georgian") << u'ზ' << 52U;
    QTest::newRow("Russian without a code") << u'Я' << 0U;
    QTest::newRow("Greek without a code") << u'Ζ' << 0U;
}

void LayoutKeysTest::undoAndRedo_areWhereTheyAlwaysAre()
{
    QFETCH(char16_t, letter);
    QFETCH(quint32, code);
    brush();
    TreeDocument& document = m_window->document();
    const std::uint32_t grown = document.index().livingCount();
    click(letter, code, Qt::ControlModifier);
    QCOMPARE(document.index().livingCount(), 1U);
    click(letter, code, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(document.index().livingCount(), grown);
}

void LayoutKeysTest::toolKeys_takeTheirTools_data()
{
    QTest::addColumn<ActionId>("tool");
    QTest::addColumn<char16_t>("letter");
    QTest::addColumn<quint32>("code");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    const auto add = [](const char* name, ActionId tool, char16_t letter, quint32 code, bool shift = false) {
        QTest::newRow(name) << tool << letter << code
                            << Qt::KeyboardModifiers(shift ? Qt::ShiftModifier : Qt::NoModifier);
    };
    add("Russian P", ActionId::Prune, u'З', 33);
    add("Russian W", ActionId::Width, u'Ц', 25);
    add("Russian O", ActionId::Lasso, u'Щ', 32);
    add("Russian U", ActionId::SelectBud, u'Г', 30);
    add("Russian Shift+B", ActionId::Bend, u'И', 56, true);
    add("Russian Shift+G", ActionId::Grow, u'П', 42, true);
    add("Greek P", ActionId::Prune, u'Π', 33);
    // σ and its final form ς have one capital.
    add("Greek W", ActionId::Width, u'Σ', 25);
    add("Hebrew U", ActionId::SelectBud, u'ו', 30);
}

void LayoutKeysTest::toolKeys_takeTheirTools()
{
    QFETCH(ActionId, tool);
    QFETCH(char16_t, letter);
    QFETCH(quint32, code);
    QFETCH(Qt::KeyboardModifiers, modifiers);
    click(letter, code, modifiers);
    QVERIFY(action(tool)->isChecked());
    // The key at the place of B selects the brush again.
    click(u'И', 56);
    QVERIFY(action(ActionId::Brush)->isChecked());
}

void LayoutKeysTest::save_saves()
{
    save(m_folder->filePath(QStringLiteral("tree.espalier")));
    brush();
    QVERIFY(m_window->isWindowModified());
    QSignalSpy saved(&m_window->files().file(), &DocumentFile::saved);
    click(u'Ы', 39, Qt::ControlModifier);
    QTRY_COMPARE_WITH_TIMEOUT(saved.count(), 1, 30000);
    QVERIFY(!m_window->isWindowModified());
}

void LayoutKeysTest::signAtTheLettersPlace_isTheLetter()
{
    // Hebrew has an apostrophe at the place of W. Only a letter shows the layout.
    click(u'נ', 56);
    click(u'\'', 25);
    QVERIFY(action(ActionId::Width)->isChecked());
    // On a Latin layout a sign keeps its meaning.
    QTest::keyClick(handle(), Qt::Key_B);
    click(u'\'', 25);
    QVERIFY(action(ActionId::Brush)->isChecked());
}

void LayoutKeysTest::cameraKeys_turnTheView()
{
    const float azimuth = viewport().mainCamera().azimuth();
    key(QEvent::KeyPress, u'Й', 24);
    QTest::qWait(100);
    key(QEvent::KeyRelease, u'Й', 24);
    const float turned = viewport().mainCamera().azimuth();
    QVERIFY(turned != azimuth);
    // The key is not held any more.
    QTest::qWait(100);
    QCOMPARE(viewport().mainCamera().azimuth(), turned);
}

void LayoutKeysTest::latinLayouts_areLeftAlone()
{
    // French: the key at the place of W says Z.
    click(u'Z', 25);
    QVERIFY(action(ActionId::Brush)->isChecked());
    click(u'P', 33);
    QVERIFY(action(ActionId::Prune)->isChecked());
    // Czech: ě is a Latin letter, too.
    click(u'Ě', 25);
    QVERIFY(action(ActionId::Prune)->isChecked());
}

void LayoutKeysTest::textField_takesWhatIsTyped()
{
    QLineEdit field(m_window.get());
    field.show();
    field.setFocus();
    click(u'П', 42, Qt::ShiftModifier);
    click(u'И', 56);
    click(u'Ц', 25);
    click(u'З', 33);
    QCOMPARE(field.text(), QStringLiteral("Пицз"));
    QVERIFY(action(ActionId::Brush)->isChecked());
}

void LayoutKeysTest::textField_knowsItsShortcuts()
{
    brush();
    const std::uint32_t grown = m_window->document().index().livingCount();
    QLineEdit field(m_window.get());
    field.show();
    field.setFocus();
    click(u'П', 42);
    click(u'Ф', 38, Qt::ControlModifier);
    QCOMPARE(field.selectedText(), QStringLiteral("п"));
    click(u'Ч', 53, Qt::ControlModifier);
    QCOMPARE(field.text(), QString());
    click(u'М', 55, Qt::ControlModifier);
    QCOMPARE(field.text(), QStringLiteral("п"));
    // Ctrl+Z undoes in the text field, not in the tree.
    click(u'Я', 52, Qt::ControlModifier);
    QCOMPARE(field.text(), QString());
    QCOMPARE(m_window->document().index().livingCount(), grown);
}

static const test::TestClass<LayoutKeysTest> layoutKeysTest;

#include "LayoutKeysTest.moc"
