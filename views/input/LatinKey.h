// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <cstdint>

class QKeyEvent;

namespace espalier {

/// Numbering of the places of keys on a platform.
enum class KeyCodes {
    Xkb,      ///< X11 and Wayland: nativeScanCode() is the kernel's code of the key plus 8
    ScanCode, ///< Windows: nativeScanCode() is the scan code of set 1
    Mac,      ///< macOS: nativeVirtualKey() is the code of the key
};

/// @param platform QGuiApplication::platformName()
KeyCodes keyCodesOf(const QString& platform);

/// Kind of the text that a keyboard layout gives for a key.
enum class KeyScript {
    Latin,   ///< A letter of the Latin alphabet
    Foreign, ///< A letter of another alphabet, such as Cyrillic or Greek
    None,    ///< No letter: a digit, a sign, a function key
};
KeyScript scriptOf(const QKeyEvent& event);

/// The Qt::Key that a US keyboard has at the place of the event's key; 0 if that is not known. For a foreign
/// letter without a key code, as from a remote or virtual keyboard, the place on the usual Russian, Ukrainian
/// and Greek layouts is used.
int keyOfUsLayout(const QKeyEvent& event, KeyCodes codes);

} // namespace espalier
