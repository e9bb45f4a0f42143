// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/sketch/LeafPlacement.h"
#include "tests/support/TreeBuilder.h"

namespace espalier::test {

/// The row of a leaf.
inline LeafRow leafAt(InternodeId internode, float along, const Rotation& rotation, float length,
                      LeafKind kind = LeafKind::Leaf)
{
    LeafRow row;
    row.internode = internode;
    row.along = along;
    row.rotation = rotation;
    row.length = length;
    row.kind = kind;
    return row;
}

/// The row of a leaf that stands off its internode at 90° at an azimuth, rad, from +X toward +Z.
inline LeafRow leafAround(InternodeId internode, float along, double azimuth, float length = 0.1F)
{
    const auto about = [](double angle, const Vec3& axis) {
        return Rotation(Eigen::AngleAxisf(static_cast<float>(angle), axis));
    };
    return leafAt(
        internode, along,
        (about(-azimuth, Vec3::UnitY()) * about(-0.5 * std::numbers::pi, Vec3::UnitZ())).normalized(),
        length);
}

/// A random internode of a tree, the dead included.
inline InternodeId anyInternode(const Tree& tree, Random& random)
{
    return static_cast<InternodeId>(random.bits() % tree.size());
}

/// An edit that places one to four leaves, or moves, changes or removes one.
inline TreeDelta randomLeafEdit(const Tree& tree, Random& random)
{
    TreeDelta delta = deltaStartingAt(tree);
    const auto anyLeaf = [&](InternodeId id) {
        return leafAt(
            id, static_cast<float>(random.uniform()),
            Rotation(Eigen::AngleAxisf(static_cast<float>(random.uniform(0.0, 6.0)), random.direction())),
            static_cast<float>(random.uniform(0.02, 0.3)));
    };
    const std::uint32_t leaves = tree.placedLeaves().size();
    const std::uint64_t choice = random.bits() % 6;
    const auto leaf = static_cast<LeafId>(leaves > 0 ? random.bits() % leaves : 0);
    if (leaves == 0 || choice < 2) {
        const std::uint64_t count = 1 + random.bits() % 4;
        for (std::uint64_t i = 0; i < count; ++i)
            addLeaf(delta, anyLeaf(anyInternode(tree, random)));
    } else if (choice == 2) {
        moveLeaf(delta, tree, leaf, anyLeaf(anyInternode(tree, random)));
    } else if (choice == 3) {
        moveLeaf(delta, tree, leaf, anyLeaf(tree.placedLeaves().internode[leaf]));
    } else if (choice == 4) {
        LeafRow row = leafRow(tree, leaf);
        row.kind = row.kind == LeafKind::Fruit ? LeafKind::Leaf : LeafKind::Fruit;
        row.length *= 0.9F;
        moveLeaf(delta, tree, leaf, row);
    } else if (tree.placedLeaves().death[leaf] == kNever) {
        removeLeaf(delta, tree, leaf);
    } else {
        addLeaf(delta, anyLeaf(anyInternode(tree, random)));
    }
    return delta;
}

} // namespace espalier::test
