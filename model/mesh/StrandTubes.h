// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/WorkProgress.h"
#include "model/mesh/StrandReuse.h"
#include "model/mesh/WoodMesher.h"
#include "model/strands/NodeSection.h"

#include <cstdint>
#include <vector>

namespace espalier {

/// The outline of a bundle: loops of strands, or a ring around so few strands that they have no outline.
struct BundleOutline {
    std::vector<SectionLoop> loops; ///< Empty for a ring
    bool isRing() const { return loops.empty(); }
};

/// Strands that run side by side from one node to the next: the surface around them is a tube.
struct StrandTube {
    /// Their numbers at the upper node; empty for all strands of that node.
    std::vector<std::uint32_t> strands;
    BundleOutline below; ///< In the section of the lower node, by numbers at the upper node
    BundleOutline above; ///< In that of the upper node
    int sides = 0;       ///< Of its rings
};

/// How the strands of a tree form tubes (Strands 2024 §5.5): between two nodes one tube for each set of
/// strands that are together in a connected part of the lower section, in one branch, and in a connected part
/// of the upper section. At a node, tubes join or divide where its parts do.
struct StrandTubes {
    struct Node {
        std::vector<StrandTube> tubes; ///< From the node below to this one
        BundleOutline whole;           ///< The outline of all strands of the node
        int ringSides = 0;             ///< Of the outline, if it is a ring
        int steps = 1;                 ///< Cross-sections from the node below to this one
        /// Cross-sections above the node in which its branches are still one.
        int joined = 0;
        /// Whether the outline of the node is that of its one tube, or of the one tube above it: then no part
        /// joins or divides.
        bool continuesBelow = true;
        bool continuesAbove = true;
    };
    std::vector<Node> nodes; ///< As those of the layouts
};

/// Nodes that @p reuse has come from @p last. If @p progress is cancelled meanwhile, the result is of no use.
StrandTubes strandTubes(const StrandLayouts& layouts, const WoodParameters& wood,
                        const WoodMeshOptions& options, const StrandReuse& reuse, const StrandTubes* last,
                        WorkProgress& progress);

} // namespace espalier
