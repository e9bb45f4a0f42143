// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates what is wrong with drawings, with branches that are copied, and with figures.
struct SketchText {
    Q_DECLARE_TR_FUNCTIONS(Sketch)
};

} // namespace espalier
