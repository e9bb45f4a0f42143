// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/ExportFormats.h"

#include "model/io/export/FbxFormat.h"
#include "model/io/export/GlbFormat.h"
#include "model/io/export/ObjFormat.h"
#include "model/io/export/SkeletonFormat.h"

#include <QFileInfo>

#include <algorithm>

namespace espalier {

std::span<const ExportFormat* const> exportFormats()
{
    static const GlbFormat glb;
    static const FbxFormat fbx;
    static const ObjFormat obj;
    static const SkeletonFormat skeleton;
    static constexpr std::array<const ExportFormat*, 4> formats{&glb, &fbx, &obj, &skeleton};
    return formats;
}

const ExportFormat* exportFormatOf(const QString& fileName)
{
    const QString suffix = QFileInfo(fileName).suffix().toLower();
    const auto formats = exportFormats();
    const auto found =
        std::ranges::find_if(formats, [&](const ExportFormat* format) { return format->suffix() == suffix; });
    return found == formats.end() ? nullptr : *found;
}

QStringList exportSuffixes()
{
    QStringList suffixes;
    for (const ExportFormat* format : exportFormats())
        suffixes.append(format->suffix());
    return suffixes;
}

} // namespace espalier
