// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFormat.h"

#include <QStringList>

#include <span>

namespace espalier {

/// All formats, in the order in which they are offered. The list lives as long as the program.
std::span<const ExportFormat* const> exportFormats();
/// The format whose suffix the file name ends in, in upper or lower case; null if there is none.
const ExportFormat* exportFormatOf(const QString& fileName);
/// The suffixes of all formats, in the same order.
QStringList exportSuffixes();

} // namespace espalier
