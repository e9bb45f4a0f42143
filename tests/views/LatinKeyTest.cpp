// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/LatinKey.h"

#include "tests/support/TestClasses.h"

#include <QKeyEvent>
#include <QTest>

using namespace espalier;

/// Finds the key of a US keyboard at the place of a key.
class LatinKeyTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void codes_nameTheKeysOfAUsKeyboard_data();
    void codes_nameTheKeysOfAUsKeyboard();
    void lettersWithoutACode_areFoundOnUsualLayouts();
    void unknownPlaces_haveNoKey();
    void scripts_areToldApart();

private:
    static QKeyEvent event(int key, quint32 scanCode, quint32 virtualKey = 0, const QString& text = {})
    {
        return {QEvent::KeyPress, key, Qt::NoModifier, scanCode, virtualKey, 0, text};
    }
};

void LatinKeyTest::codes_nameTheKeysOfAUsKeyboard_data()
{
    QTest::addColumn<char>("us");
    QTest::addColumn<quint32>("scanCode"); ///< Set 1
    QTest::addColumn<quint32>("macCode");
    const std::tuple<char, quint32, quint32> keys[] = {
        {'Q', 0x10, 12}, {'P', 0x19, 35}, {'[', 0x1A, 33},  {']', 0x1B, 30}, {'A', 0x1E, 0},
        {'L', 0x26, 37}, {'`', 0x29, 50}, {'\\', 0x2B, 42}, {'Z', 0x2C, 6},  {'B', 0x30, 11},
        {'M', 0x32, 46}, {',', 0x33, 43}, {'1', 0x02, 18},  {'=', 0x0D, 24}};
    for (const auto& [us, scanCode, macCode] : keys)
        QTest::addRow("%c", us) << us << scanCode << macCode;
}

void LatinKeyTest::codes_nameTheKeysOfAUsKeyboard()
{
    QFETCH(char, us);
    QFETCH(quint32, scanCode);
    QFETCH(quint32, macCode);
    QCOMPARE(keyOfUsLayout(event(u'Ю', scanCode), keyCodesOf(QStringLiteral("windows"))), int(us));
    QCOMPARE(keyOfUsLayout(event(u'Ю', scanCode + 8), keyCodesOf(QStringLiteral("xcb"))), int(us));
    QCOMPARE(keyOfUsLayout(event(u'Ю', scanCode + 8), keyCodesOf(QStringLiteral("wayland"))), int(us));
    QCOMPARE(keyOfUsLayout(event(u'Ю', 1, macCode), keyCodesOf(QStringLiteral("cocoa"))), int(us));
}

void LatinKeyTest::lettersWithoutACode_areFoundOnUsualLayouts()
{
    QCOMPARE(keyOfUsLayout(event(u'Я', 0), KeyCodes::Xkb), int(Qt::Key_Z));
    QCOMPARE(keyOfUsLayout(event(u'Ф', 0), KeyCodes::ScanCode), int(Qt::Key_A));
    QCOMPARE(keyOfUsLayout(event(u'І', 0), KeyCodes::Xkb), int(Qt::Key_S));
    QCOMPARE(keyOfUsLayout(event(u'Ω', 0), KeyCodes::Xkb), int(Qt::Key_V));
    QCOMPARE(keyOfUsLayout(event(0, 0, 0, QStringLiteral("й")), KeyCodes::Xkb), int(Qt::Key_Q));
}

void LatinKeyTest::unknownPlaces_haveNoKey()
{
    for (const KeyCodes codes : {KeyCodes::Xkb, KeyCodes::ScanCode, KeyCodes::Mac}) {
        QCOMPARE(keyOfUsLayout(event(u'Ю', 7, 200), codes == KeyCodes::ScanCode ? KeyCodes::Xkb : codes), 0);
        QCOMPARE(keyOfUsLayout(event(u'あ', 0, 200), codes), 0);
        QCOMPARE(keyOfUsLayout(event(u'Ю', 70'000, 70'000), codes), 0);
    }
}

void LatinKeyTest::scripts_areToldApart()
{
    for (const char16_t letter : {u'Я', u'Ω', u'ש', u'ზ', u'Ա', u'ก', u'ㅂ', u'ش'})
        QCOMPARE(scriptOf(event(letter, 30)), KeyScript::Foreign);
    for (const char16_t letter : {u'A', u'Z', u'Ö', u'Ě', u'Ł'})
        QCOMPARE(scriptOf(event(letter, 30)), KeyScript::Latin);
    for (const int key : {int(Qt::Key_Escape), int(Qt::Key_F1), int(Qt::Key_1), int(Qt::Key_BracketLeft),
                          int(Qt::Key_Control), 0x2116 /* № */})
        QCOMPARE(scriptOf(event(key, 30)), KeyScript::None);
    QCOMPARE(scriptOf(event(Qt::Key_unknown, 30, 0, QStringLiteral("я"))), KeyScript::Foreign);
}

static const test::TestClass<LatinKeyTest> latinKeyTest;

#include "LatinKeyTest.moc"
