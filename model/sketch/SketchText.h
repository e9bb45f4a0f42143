// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates what is wrong with a drawing.
struct SketchText {
    Q_DECLARE_TR_FUNCTIONS(Sketch)
};

} // namespace espalier
