// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/input/LatinKey.h"

#include <QChar>
#include <QKeyEvent>

#include <array>
#include <string_view>

namespace espalier {

namespace {

/// The difference between codes of XKB and those of the kernel.
constexpr quint32 kXkbOffset = 8;

/// A row of neighbouring keys: the scan code (set 1) of the first, and the characters of a US keyboard there.
struct Row {
    quint32 first;
    std::string_view keys;
};
constexpr std::array kRows{Row{0x02, "1234567890-="}, Row{0x10, "QWERTYUIOP[]"}, Row{0x1E, "ASDFGHJKL;'`"},
                           Row{0x2B, "\\ZXCVBNM,./"}};

/// By the key code of macOS; a blank for keys that are not needed.
constexpr std::string_view kMacKeys = "ASDFHGZXCV BQWERYT123465=97-80]OU[IP LJ'K;\\,/NM.  `";

/// Places of letters on common layouts.
struct Letters {
    std::u16string_view there;
    std::string_view us;
};
constexpr std::array kLayouts{
    Letters{u"ЙЦУКЕНГШЩЗХЪФЫВАПРОЛДЖЭЯЧСМИТЬБЮЁ", "QWERTYUIOP[]ASDFGHJKL;'ZXCVBNM,.`"},
    Letters{u"ІЇЄЎ", "S]'O"}, Letters{u"ΕΡΤΥΘΙΟΠΑΣΔΦΓΗΞΚΛΖΧΨΩΒΝΜ", "ERTYUIOPASDFGHJKLZXCVBNM"}};

/// The character of the event's key, in upper case; 0 if it has none.
char32_t characterOf(const QKeyEvent& event)
{
    const auto key = static_cast<char32_t>(event.key());
    if (key != 0 && key < static_cast<char32_t>(Qt::Key_Escape))
        return QChar::toUpper(key);
    if ((key == 0 || event.key() == Qt::Key_unknown) && !event.text().isEmpty())
        return QChar::toUpper(event.text().toUcs4().constFirst());
    return 0;
}

int keyOfScanCode(quint32 code)
{
    for (const Row& row : kRows) {
        if (code >= row.first && code - row.first < row.keys.size())
            return row.keys[code - row.first];
    }
    return 0;
}

} // namespace

KeyCodes keyCodesOf(const QString& platform)
{
    if (platform == QStringLiteral("windows"))
        return KeyCodes::ScanCode;
    return platform == QStringLiteral("cocoa") ? KeyCodes::Mac : KeyCodes::Xkb;
}

KeyScript scriptOf(const QKeyEvent& event)
{
    const char32_t character = characterOf(event);
    if (character == 0 || !QChar::isLetter(character))
        return KeyScript::None;
    const QChar::Script script = QChar::script(character);
    return script == QChar::Script_Latin || script == QChar::Script_Common ? KeyScript::Latin
                                                                           : KeyScript::Foreign;
}

int keyOfUsLayout(const QKeyEvent& event, KeyCodes codes)
{
    if (codes == KeyCodes::Mac) {
        const quint32 code = event.nativeVirtualKey();
        return code < kMacKeys.size() && kMacKeys[code] != ' ' ? kMacKeys[code] : 0;
    }
    if (const quint32 code = event.nativeScanCode(); code != 0) {
        if (codes == KeyCodes::ScanCode)
            return keyOfScanCode(code);
        return code > kXkbOffset ? keyOfScanCode(code - kXkbOffset) : 0;
    }
    for (const Letters& layout : kLayouts) {
        const std::size_t at = layout.there.find(static_cast<char16_t>(characterOf(event)));
        if (at != std::u16string_view::npos)
            return layout.us[at];
    }
    return 0;
}

} // namespace espalier
