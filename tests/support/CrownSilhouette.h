// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/document/TreeDocument.h"
#include "model/envelope/EnvelopeSet.h"

#include <cmath>
#include <vector>

namespace espalier::test {

/// How the crown of a tree fills the silhouette of an envelope in the XY plane, from the front.
struct CrownSilhouette {
    double covered = 0.0; ///< Share of the envelope's silhouette that the crown covers
    double outside = 0.0; ///< Share of the crown's silhouette that is not in the envelope's
};

/// The crown is the set of nodes with leaves: each node that carries few enough tips counts as a disc with
/// the length of a leaf as radius, which is as far as its leaves reach.
inline CrownSilhouette crownSilhouette(const TreeDocument& document, const Envelope& envelope)
{
    constexpr int kCells = 400;
    const Tree& tree = document.tree();
    const LeafParameters& leaves = document.parameters().leaves;
    const auto reach = static_cast<float>(leaves.length);
    const auto bearsLeaves = [&](InternodeId id) {
        return id > 0 && tree.isAlive(id) &&
               document.index().tipCount(id) <= static_cast<std::uint32_t>(leaves.maxTips);
    };
    Box3 box = envelope.bounds();
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (bearsLeaves(id))
            box.extend(document.index().nodePosition(id));
    }
    const float cell = (box.sizes().head<2>().maxCoeff() + 2.0F * reach) / kCells;
    const Vec2 corner = box.min().head<2>().array() - reach;
    Mask crown(kCells, kCells);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!bearsLeaves(id))
            continue;
        const Vec2 centre = (document.index().nodePosition(id).head<2>() - corner) / cell;
        const float radius = reach / cell;
        for (int y = static_cast<int>(centre.y() - radius); y <= static_cast<int>(centre.y() + radius); ++y) {
            for (int x = static_cast<int>(centre.x() - radius); x <= static_cast<int>(centre.x() + radius);
                 ++x) {
                const Vec2 middle(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
                if (crown.contains(x, y) && (middle - centre).norm() <= radius)
                    crown(x, y) = 1;
            }
        }
    }
    double inBoth = 0.0;
    double inEnvelope = 0.0;
    double inCrown = 0.0;
    const float depth = envelope.toWorld(0.0, 0.0, 0.0).z();
    for (int y = 0; y < kCells; ++y) {
        for (int x = 0; x < kCells; ++x) {
            const Vec2 place =
                corner + cell * Vec2(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
            const bool isInside = envelope.contains({place.x(), place.y(), depth});
            inEnvelope += isInside ? 1.0 : 0.0;
            inCrown += crown(x, y) != 0 ? 1.0 : 0.0;
            inBoth += isInside && crown(x, y) != 0 ? 1.0 : 0.0;
        }
    }
    return {inBoth / inEnvelope, inCrown > 0.0 ? 1.0 - inBoth / inCrown : 0.0};
}

} // namespace espalier::test
