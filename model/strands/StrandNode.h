// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/tree/TreeIndex.h"

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace espalier {

inline constexpr std::uint32_t kNoNode = std::numeric_limits<std::uint32_t>::max();

/// A place on the tree at which strands have a cross-section.
struct StrandNode {
    InternodeId internode = kNoInternode;
    float along = 1.0F;           ///< On that internode: 0 at its lower end, 1 at its node
    std::uint32_t parent = 0;     ///< Index of the node below; its own index for the base of a root
    std::uint32_t firstChild = 0; ///< Into StrandSkeleton::children
    std::uint32_t childCount = 0;
    /// Number of the strands that pass it, and the place of the first of them among those of the parent.
    std::uint32_t strands = 0;
    std::uint32_t offset = 0;
    float radius = 0.0F;          ///< m, of the wood
    Vec3 position = Vec3::Zero(); ///< m
    Rotation frame =
        Rotation::Identity(); ///< World frame of the section: +Y along the branch, X and Z in its plane
};

/// The nodes that strands run through, parents before children: the base of each root, the node of each
/// living internode, and the places between at which branches are attached. Frames are transported from the
/// base upward in parallel, so that they add no twist (Strands 2024 §5.1); those that the user has given turn
/// the frames of their nodes and all above (§5.4), and profiles with them.
///
/// Strands are numbered within each node: those of its first child come first, and so on; a node without
/// children begins as many as the parameters say.
struct StrandSkeleton {
    std::vector<StrandNode> nodes;
    std::vector<std::uint32_t> children; ///< Of all nodes, each node's one after another
    std::vector<std::uint32_t> bases;    ///< Nodes at the bases of the living roots

    std::span<const std::uint32_t> childrenOf(std::uint32_t node) const
    {
        return std::span(children).subspan(nodes[node].firstChild, nodes[node].childCount);
    }
    bool isBase(std::uint32_t node) const { return nodes[node].parent == node; }
};

} // namespace espalier
