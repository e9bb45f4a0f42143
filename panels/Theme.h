// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>

class QApplication;

/// How the program looks: the colours that its widgets are drawn with, and the style made of them.
namespace espalier::theme {

inline constexpr QColor kWorkspace(0x23, 0x27, 0x2e); ///< Behind everything
inline constexpr QColor kBar(0x2b, 0x30, 0x39, 0xec); ///< Bars and panels over the tree, translucent
inline constexpr QColor kEdge(0x3c, 0x43, 0x4e);      ///< Borders of bars, lines between sections
inline constexpr QColor kSunken(0x1d, 0x20, 0x26);    ///< Tracks of sliders, fields
inline constexpr QColor kText(0xdd, 0xe0, 0xe5);
inline constexpr QColor kDimText(0x9a, 0xa2, 0xae);
inline constexpr QColor kFaintText(0x63, 0x6b, 0x77);  ///< What cannot be used now
inline constexpr QColor kAccent(0x7f, 0xb0, 0x69);     ///< What is on, how far a slider is
inline constexpr QColor kAccentFill(0x3c, 0x50, 0x3f); ///< Behind the tool in hand
inline constexpr QColor kHandle(0xe6, 0xa6, 0x5d);     ///< What is to be grasped: the brush and its size
inline constexpr QColor kWarning(0xd9, 0x7b, 0x6c);

/// Pixels (device-independent): whatever is to be hit by a finger is at least this large.
inline constexpr int kTarget = 44;
inline constexpr int kRadius = 10;

/// Gives the whole program its style, palette and style sheet.
void apply(QApplication& application);

} // namespace espalier::theme
