// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFormat.h"

namespace espalier {

/// Binary glTF 2.0 with the textures inside and no extension. This class writes the file without Assimp,
/// which leaves out tangents and declares extensions that it does not use.
class GlbFormat final : public ExportFormat {
public:
    QString suffix() const override { return QStringLiteral("glb"); }
    QString name() const override;
    ExportParts parts() const override { return {.surface = true}; }
    Result<void> write(const ExportScene& scene, ExportFiles& files) const override;
};

} // namespace espalier
