// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

class QKeyEvent;

namespace espalier {

/// How a platform numbers the places of keys.
enum class KeyCodes {
    Xkb,      ///< X11 and Wayland: nativeScanCode() is the kernel's code of the key plus 8
    ScanCode, ///< Windows: nativeScanCode() is the scan code of set 1
    Mac,      ///< macOS: nativeVirtualKey() is the code of the key
};

/// @param platform QGuiApplication::platformName()
KeyCodes keyCodesOf(const QString& platform);

/// What a keyboard layout gave for a key.
enum class KeyScript {
    Latin,   ///< A letter of the Latin alphabet
    Foreign, ///< A letter of another one, such as Cyrillic or Greek
    None,    ///< No letter: a digit, a sign, a function key
};
KeyScript scriptOf(const QKeyEvent& event);

/// The Qt::Key that a US keyboard has at the place of the event's key; 0 if that is not known. A foreign
/// letter that comes without a code, as from a remote or virtual keyboard, is looked for on the usual
/// Russian, Ukrainian and Greek layouts.
int keyOfUsLayout(const QKeyEvent& event, KeyCodes codes);

} // namespace espalier
