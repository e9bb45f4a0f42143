// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/io/export/SkeletonWriter.h"

#include "model/io/export/TextBlocks.h"
#include "model/shape/Widths.h"

namespace espalier {

namespace {

void append(TextBlock& block, const Vec3& point)
{
    // Zero minus z, where minus z would make "-0" of 0.
    block << ',' << point.x() << ',' << 0.0F - point.z() << ',' << point.y();
}

} // namespace

bool writeSkeleton(QIODevice& device, const Tree& tree, const TreeIndex& index)
{
    const QByteArray names = "id,parent,x0,y0,z0,x1,y1,z1,radius\n";
    if (device.write(names) != names.size())
        return false;
    const Widths widths(tree, index);
    return writeBlocks(device, tree.size(), [&](TextBlock& block, std::size_t row) {
        const auto id = static_cast<InternodeId>(row);
        if (!tree.isAlive(id))
            return;
        block << std::uint64_t{id} << ',';
        if (tree.parent(id) == kNoInternode)
            block << "-1";
        else
            block << std::uint64_t{tree.parent(id)};
        append(block, index.basePosition(tree, id));
        append(block, index.nodePosition(id));
        block << ',' << widths.radius(index, id) << '\n';
    });
}

} // namespace espalier
