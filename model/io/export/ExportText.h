// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>

namespace espalier {

/// Translates the messages of the export.
struct ExportText {
    Q_DECLARE_TR_FUNCTIONS(Exporter)
};

} // namespace espalier
