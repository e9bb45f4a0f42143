// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/PlacedLeafIndex.h"

#include <algorithm>

namespace espalier {

void PlacedLeafIndex::rebuild(const Tree& tree)
{
    *this = {};
    const LeafColumns& leaves = tree.placedLeaves();
    m_next.assign(leaves.size(), kNoLeaf);
    m_internode.assign(leaves.internode.begin(), leaves.internode.end());
    // From the last to the first, so that each leaf becomes the first of its list.
    for (LeafId leaf = leaves.size(); leaf-- > 0;) {
        const auto [place, isNew] = m_first.try_emplace(m_internode[leaf], leaf);
        if (!isNew)
            m_next[leaf] = std::exchange(place->second, leaf);
    }
}

void PlacedLeafIndex::update(const Tree& tree, const TreeDelta& delta)
{
    m_changed.clear();
    const LeafColumns& leaves = tree.placedLeaves();
    const std::uint32_t count = leaves.size();
    while (m_next.size() > count) {
        const auto leaf = static_cast<LeafId>(m_next.size() - 1);
        m_changed.push_back(m_internode[leaf]);
        unlink(leaf);
        m_next.pop_back();
        m_internode.pop_back();
    }
    for (auto leaf = static_cast<LeafId>(m_next.size()); leaf < count; ++leaf) {
        m_next.push_back(kNoLeaf);
        m_internode.push_back(leaves.internode[leaf]);
        link(leaf, m_internode[leaf]);
        m_changed.push_back(m_internode[leaf]);
    }
    // After a revert, the rows that the delta added are gone.
    const auto forEachRow = [count](const auto& changes, auto&& visit) {
        for (const auto& change : changes) {
            if (change.row < count)
                visit(change.row);
        }
    };
    forEachRow(delta.leaves.internode, [&](LeafId leaf) {
        if (m_internode[leaf] == leaves.internode[leaf])
            return;
        m_changed.push_back(m_internode[leaf]);
        unlink(leaf);
        m_internode[leaf] = leaves.internode[leaf];
        link(leaf, m_internode[leaf]);
        m_changed.push_back(m_internode[leaf]);
    });
    const auto note = [&](LeafId leaf) { m_changed.push_back(m_internode[leaf]); };
    forEachRow(delta.leaves.along, note);
    forEachRow(delta.leaves.rotation, note);
    forEachRow(delta.leaves.length, note);
    forEachRow(delta.leaves.kind, note);
    forEachRow(delta.leaves.death, note);
    std::ranges::sort(m_changed);
    const auto repeated = std::ranges::unique(m_changed);
    m_changed.erase(repeated.begin(), repeated.end());
}

std::size_t PlacedLeafIndex::bytes() const
{
    constexpr std::size_t node = sizeof(std::pair<InternodeId, LeafId>) + 2 * sizeof(void*);
    return m_first.size() * node + m_first.bucket_count() * sizeof(void*) +
           m_next.capacity() * sizeof(LeafId) +
           (m_internode.capacity() + m_changed.capacity()) * sizeof(InternodeId);
}

void PlacedLeafIndex::link(LeafId leaf, InternodeId internode)
{
    LeafId* place = &m_first.try_emplace(internode, kNoLeaf).first->second;
    while (*place < leaf) // kNoLeaf is larger than any id
        place = &m_next[*place];
    m_next[leaf] = std::exchange(*place, leaf);
}

void PlacedLeafIndex::unlink(LeafId leaf)
{
    const auto first = m_first.find(m_internode[leaf]);
    LeafId* place = &first->second;
    while (*place != leaf)
        place = &m_next[*place];
    *place = std::exchange(m_next[leaf], kNoLeaf);
    if (first->second == kNoLeaf)
        m_first.erase(first);
}

bool isPlacedLeafShown(const Tree& tree, LeafId leaf)
{
    const LeafColumns& leaves = tree.placedLeaves();
    return leaves.death[leaf] == kNever && tree.isAlive(leaves.internode[leaf]) &&
           tree.parameters().leaves.visible;
}

std::uint64_t placedLeafCount(const Tree& tree)
{
    std::uint64_t count = 0;
    for (LeafId leaf = 0; leaf < tree.placedLeaves().size(); ++leaf)
        count += isPlacedLeafShown(tree, leaf) ? 1 : 0;
    return count;
}

Vec3 placedLeafBase(const Tree& tree, const TreeIndex& index, LeafId leaf)
{
    const InternodeId id = tree.placedLeaves().internode[leaf];
    const float down = (1.0F - tree.placedLeaves().along[leaf]) * tree.length(id);
    return index.nodePosition(id) - down * index.heading(id);
}

Rotation placedLeafFrame(const Tree& tree, const TreeIndex& index, LeafId leaf)
{
    const LeafColumns& leaves = tree.placedLeaves();
    return (index.rotation(leaves.internode[leaf]) * leaves.rotation[leaf]).normalized();
}

void extendByPlacedLeaves(Box3& bounds, const Tree& tree, const TreeIndex& index)
{
    const LeafColumns& leaves = tree.placedLeaves();
    const auto halfAspect = static_cast<float>(0.5 * tree.parameters().leaves.aspect);
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        if (!isPlacedLeafShown(tree, leaf))
            continue;
        const Vec3 base = placedLeafBase(tree, index, leaf);
        const Rotation frame = placedLeafFrame(tree, index, leaf);
        const Vec3 midrib = leaves.length[leaf] * (frame * Vec3(Vec3::UnitY()));
        const Vec3 side = halfAspect * leaves.length[leaf] * (frame * Vec3(Vec3::UnitX()));
        for (const Vec3& end : {base, Vec3(base + midrib)}) {
            bounds.extend(Vec3(end + side));
            bounds.extend(Vec3(end - side));
        }
    }
}

} // namespace espalier
