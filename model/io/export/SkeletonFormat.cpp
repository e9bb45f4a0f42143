// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/SkeletonFormat.h"

#include "model/io/export/TextBlocks.h"

#include <QCoreApplication>

namespace espalier {

namespace {

void append(TextBlock& block, const Vec3& point)
{
    // 0 − z, because −z would be written as "-0" for 0.
    block << ',' << point.x() << ',' << 0.0F - point.z() << ',' << point.y();
}

bool writeSkeleton(QIODevice& device, const std::vector<ExportBone>& bones)
{
    const QByteArray names = "id,parent,x0,y0,z0,x1,y1,z1,radius\n";
    if (device.write(names) != names.size())
        return false;
    return writeBlocks(device, bones.size(), [&](TextBlock& block, std::size_t row) {
        const ExportBone& bone = bones[row];
        block << std::uint64_t{bone.id} << ',';
        if (bone.parent == kNoInternode)
            block << "-1";
        else
            block << std::uint64_t{bone.parent};
        append(block, bone.base);
        append(block, bone.tip);
        block << ',' << bone.radius << '\n';
    });
}

} // namespace

QString SkeletonFormat::name() const
{
    return QCoreApplication::translate("ExportFormat", "Skeleton as a table");
}

Result<void> SkeletonFormat::write(const ExportScene& scene, ExportFiles& files) const
{
    return files.addMain([&](QIODevice& device) { return writeSkeleton(device, scene.skeleton); });
}

} // namespace espalier
