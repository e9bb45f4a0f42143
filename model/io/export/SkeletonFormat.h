// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/io/export/ExportFormat.h"

namespace espalier {

/// The living internodes as comma-separated values, a row each after the row of names
/// id,parent,x0,y0,z0,x1,y1,z1,radius: ids as in the tree, -1 as the parent of the first; lower and upper end
/// and radius in metres, z up (the tree's x, -z, y).
class SkeletonFormat final : public ExportFormat {
public:
    QString suffix() const override { return QStringLiteral("csv"); }
    QString name() const override;
    ExportParts parts() const override { return {.skeleton = true}; }
    Result<void> write(const ExportScene& scene, ExportFiles& files) const override;
};

} // namespace espalier
