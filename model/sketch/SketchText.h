// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates the messages about branches that are copied, and about trees that get another figure.
struct SketchText {
    Q_DECLARE_TR_FUNCTIONS(Sketch)
};

} // namespace espalier
