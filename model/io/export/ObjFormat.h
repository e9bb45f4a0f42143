// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFormat.h"

namespace espalier {

/// Wavefront OBJ, one object for each mesh, with materials (.mtl) and textures beside it. This class writes
/// the file without Assimp, which takes some seven seconds for a million vertices, more than ten times as
/// long.
class ObjFormat final : public ExportFormat {
public:
    QString suffix() const override { return QStringLiteral("obj"); }
    QString name() const override;
    ExportParts parts() const override { return {.surface = true}; }
    Result<void> write(const ExportScene& scene, ExportFiles& files) const override;
};

} // namespace espalier
