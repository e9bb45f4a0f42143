// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFormat.h"

namespace espalier {

/// Binary FBX with the textures beside it. Assimp writes the document, with a triangle in the place of each
/// mesh; repairFbx() corrects what Assimp gets wrong, and setFbxTriangles() puts the meshes in.
class FbxFormat final : public ExportFormat {
public:
    QString suffix() const override { return QStringLiteral("fbx"); }
    QString name() const override;
    ExportParts parts() const override { return {.surface = true}; }
    Result<void> write(const ExportScene& scene, ExportFiles& files) const override;
};

} // namespace espalier
