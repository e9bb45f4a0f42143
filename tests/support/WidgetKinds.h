// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/support/WindowHand.h"

namespace espalier::test {

/// A kind of widget that the user works with, and how a test works with it.
struct WidgetKind {
    const char* name;
    bool (*isOne)(const QWidget& widget);
    /// Works with the widget in that way, so that something changes.
    void (*drive)(WindowHand& hand, QWidget& widget, Way way);
};

/// The kind of @p widget, or null if it is none: the table of all kinds is in the .cpp.
const WidgetKind* kindOf(const QWidget& widget);

/// The widgets in @p pane that the user works with and that can be seen or scrolled to, in the order of the
/// tree of widgets. Parts of other widgets (the field of a spin box, scroll bars) are not listed.
QList<QWidget*> widgetsToWorkWith(QWidget& pane);

/// Whether @p widget only holds or shows others.
bool isPassive(const QWidget& widget);

/// The size of the area in which a finger hits @p widget: the widget's, or that of its row.
QSize targetOf(const QWidget& widget);

} // namespace espalier::test
