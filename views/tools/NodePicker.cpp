// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tools/NodePicker.h"

#include <cmath>

namespace espalier {

std::optional<PickedNode> pickNode(const Tree& tree, const TreeIndex& index, const Camera& camera,
                                   const QPointF& screen, double reach)
{
    constexpr float kNoDifference = 3.0F; // px
    const Vec3 eye = camera.position();
    const Vec3 right = camera.right();
    const Vec3 up = camera.up();
    const Vec3 forward = camera.forward();
    const float scale = camera.pixelsPerMetre(1.0F);
    const QSizeF& size = camera.viewSize();
    const auto x = static_cast<float>(screen.x() - size.width() / 2.0);
    const auto y = static_cast<float>(size.height() / 2.0 - screen.y());
    const auto farthest = static_cast<float>(reach);

    std::optional<PickedNode> best;
    float bestRank = 0.0F;
    float bestDepth = 0.0F;
    const auto consider = [&](InternodeId id, const Vec3& position) {
        const Vec3 offset = position - eye;
        const float depth = offset.dot(forward);
        if (depth < Camera::kMinDistance / 2.0F)
            return;
        const float distance =
            std::hypot(offset.dot(right) * scale / depth - x, offset.dot(up) * scale / depth - y);
        if (distance > farthest)
            return;
        const float rank = std::floor(distance / kNoDifference);
        if (!best || rank < bestRank || (rank == bestRank && depth < bestDepth)) {
            best = PickedNode{id, position};
            bestRank = rank;
            bestDepth = depth;
        }
    };
    consider(0, Vec3::Zero());
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            consider(id, index.nodePosition(id));
    }
    return best;
}

} // namespace espalier
