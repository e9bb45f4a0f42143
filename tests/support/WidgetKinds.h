// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/WindowHand.h"

namespace espalier::test {

/// A kind of widget that a person works with, and how it is worked.
struct WidgetKind {
    const char* name;
    bool (*isOne)(const QWidget& widget);
    /// Does to it, in that way, what changes something.
    void (*drive)(WindowHand& hand, QWidget& widget, Way way);
};

/// The kind of @p widget, or null if it is none: the table of all kinds is in the .cpp.
const WidgetKind* kindOf(const QWidget& widget);

/// What a person works with in @p pane, and can be seen or scrolled to, in the order of the tree of widgets;
/// parts of other widgets (the field of a spin box, scroll bars) are no widgets of their own.
QList<QWidget*> widgetsToWorkWith(QWidget& pane);

/// Whether @p widget does nothing by itself but hold or show others.
bool isPassive(const QWidget& widget);

/// The room in which a finger hits @p widget: its own, or its row's.
QSize targetOf(const QWidget& widget);

} // namespace espalier::test
