// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/settings/Preferences.h"

#include <QColor>

class QApplication;
class QWidget;

/// How the program looks: the colours that its widgets are drawn with, and the style made of them.
namespace espalier::theme {

struct Colours {
    QColor workspace{0x23, 0x27, 0x2e};
    QColor bar{0x2b, 0x30, 0x39, 0xec};
    QColor raised{0x2b, 0x30, 0x39};
    QColor edge{0x3c, 0x43, 0x4e};
    QColor sunken{0x1d, 0x20, 0x26};
    QColor text{0xdd, 0xe0, 0xe5};
    QColor brightText{0xff, 0xff, 0xff};
    QColor dimText{0x9a, 0xa2, 0xae};
    QColor faintText{0x63, 0x6b, 0x77};
    QColor accent{0x7f, 0xb0, 0x69};
    QColor accentFill{0x3c, 0x50, 0x3f};
    QColor accentText{0xa6, 0xd0, 0x93};
    QColor handle{0xe6, 0xa6, 0x5d};
    QColor handleFill{0x8b, 0x65, 0x38};
    QColor keyCap{0x3c, 0x43, 0x4e};
    QColor warning{0xd9, 0x7b, 0x6c};
    QColor knob{0xd5, 0xdb, 0xe4};
    QColor button{0x3a, 0x42, 0x4e};
    QColor buttonHover{0x45, 0x4e, 0x5c};
    QColor buttonDisabled{0x2f, 0x35, 0x3e};
    QColor hover{0xff, 0xff, 0xff, 16};
    QColor pressed{0xff, 0xff, 0xff, 34};
    QColor highlight{0x4f, 0x70, 0x46};
};

/// The colours in force; apply() sets them. Painting code reads them each time that it paints.
inline constinit Colours inForce;

inline constinit const QColor& kWorkspace = inForce.workspace; ///< Behind everything
inline constinit const QColor& kBar = inForce.bar;             ///< Bars and panels over the tree, translucent
inline constinit const QColor& kRaised = inForce.raised;       ///< Menus and cards, opaque
inline constinit const QColor& kEdge = inForce.edge;           ///< Borders of bars, lines between sections
inline constinit const QColor& kSunken = inForce.sunken;       ///< Tracks of sliders, fields
inline constinit const QColor& kText = inForce.text;
inline constinit const QColor& kBrightText = inForce.brightText; ///< Under the pointer, or chosen
inline constinit const QColor& kDimText = inForce.dimText;
inline constinit const QColor& kFaintText = inForce.faintText; ///< For controls that are disabled
/// For controls that are on, and the filled part of a slider.
inline constinit const QColor& kAccent = inForce.accent;
inline constinit const QColor& kAccentFill = inForce.accentFill; ///< Behind the current tool
inline constinit const QColor& kAccentText = inForce.accentText; ///< Icons of controls that are on
/// Handles that can be dragged: the brush and its size.
inline constinit const QColor& kHandle = inForce.handle;
inline constinit const QColor& kHandleFill = inForce.handleFill; ///< The filled part of the brush's slider
inline constinit const QColor& kKeyCap = inForce.keyCap;         ///< Behind the name of a key
inline constinit const QColor& kWarning = inForce.warning;

// Tooltips, and widgets that lie over the tree's picture without a bar, look the same in the dark and the
// light theme.
inline constexpr QColor kOverDark(0x9a, 0xa2, 0xae);
inline constexpr QColor kOverLight(0x4d, 0x55, 0x5e);
inline constexpr QColor kBubble(0x16, 0x18, 0x1c);
inline constexpr QColor kBubbleEdge(0x3c, 0x43, 0x4e);
inline constexpr QColor kBubbleText(0xdd, 0xe0, 0xe5);
inline constexpr QColor kBubbleKey(0xe6, 0xa6, 0x5d);

/// A parameter's symbol beside its name: legible on all of these.
inline constexpr QColor kSymbol(0x79, 0x81, 0x8c);

/// Pixels (device-independent): the least size of a target for a finger.
inline constexpr int kTarget = 44;
inline constexpr int kRadius = 10;

/// Sets the style, palette and style sheet of the whole program; can be called at any time.
void apply(QApplication& application, Look look = Look::Dark);

/// Whether the colours in force are light.
bool isLight();

enum class Tone { Dim, Bright, OverDark, OverLight };
/// Sets the colour of a label's text, also for a disabled label, in the dark and the light theme.
void setTone(QWidget& label, Tone tone);

} // namespace espalier::theme
