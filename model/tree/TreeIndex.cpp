// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/tree/TreeIndex.h"

namespace espalier {

namespace {

constexpr std::uint8_t kOwnAlive = 1;
constexpr std::uint8_t kOwnTip = 2;

} // namespace

Placement placeOn(const Vec3& base, const Rotation& parentRotation, const Rotation& local, float length)
{
    // Normalised at each internode, so that rounding does not build up along an axis.
    const Rotation rotation = (parentRotation * local).normalized();
    return {base + length * (rotation * Vec3(Vec3::UnitY())), rotation};
}

void TreeIndex::rebuild(const Tree& tree)
{
    *this = {};
    appendRows(tree);
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            link(tree, id);
    }
    for (InternodeId id = 0; id < tree.size(); ++id)
        refreshOwn(tree, id);
    sweep(tree);
    freeList(m_changed);
}

void TreeIndex::update(const Tree& tree, const TreeDelta& delta)
{
    const bool isReverted = size() > tree.size();
    m_removed.setEmpty();
    if (isReverted)
        removeRows(tree, delta);
    else
        appendRows(tree);
    moveAll(tree, delta);
    const auto forEachTouched = [&](auto&& visit) {
        if (isReverted)
            delta.forEachTouchedRow(visit);
        else
            delta.forEachTouched(visit);
    };
    forEachTouched([&](InternodeId id) {
        const bool linked = (m_own[id] & kOwnAlive) != 0;
        if (tree.isAlive(id) == linked)
            return;
        if (linked)
            unlink(tree, id);
        else
            link(tree, id);
        m_own[id] ^= kOwnAlive;
        m_sweep.add(id, {.internodes = linked ? ~0U : 1U});
    });
    // A birth or a death can change whether the internode or its parent is a tip.
    forEachTouched([&](InternodeId id) {
        refreshOwn(tree, id);
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
            refreshOwn(tree, parent);
    });

    sweep(tree);
}

void TreeIndex::sweep(const Tree& tree)
{
    clearScratch(m_changed);
    m_sweep.run(tree.columns().parent, [&](InternodeId id, const Sums& difference) {
        m_sums[id] += difference;
        m_changed.push_back(id);
    });
}

std::size_t TreeIndex::bytes() const
{
    const auto bytesOf = [](const auto&... lists) {
        return ((lists.capacity() * sizeof(lists.front())) + ...);
    };
    return bytesOf(m_firstChild, m_nextSibling, m_mainChild, m_axis, m_roots, m_position, m_rotation, m_sums,
                   m_own, m_changed, m_moved, m_moves) +
           m_sweep.bytes();
}

void TreeIndex::appendRows(const Tree& tree)
{
    const InternodeColumns& c = tree.columns();
    const std::uint32_t begin = size();
    const std::uint32_t end = tree.size();
    if (begin == end)
        return;
    resizeColumn(m_firstChild, end, kNoInternode);
    resizeColumn(m_nextSibling, end, kNoInternode);
    resizeColumn(m_mainChild, end, kNoInternode);
    resizeColumn(m_axis, end);
    resizeColumn(m_position, end);
    resizeColumn(m_rotation, end);
    resizeColumn(m_sums, end);
    resizeColumn(m_own, end, std::uint8_t{0});
    for (InternodeId id = begin; id < end; ++id) {
        const InternodeId parent = c.parent[id];
        const bool isBase = parent == kNoInternode;
        m_axis[id] = isBase || c.slot[id] != kTerminalSlot ? id : m_axis[parent];
        if (isBase)
            m_roots.push_back(id);
        place(tree, id);
    }
}

/// Removes the rows that @p delta added. All descendants of a removed row are removed rows, too.
void TreeIndex::removeRows(const Tree& tree, const TreeDelta& delta)
{
    const std::uint32_t end = tree.size();
    const QList<InternodeId>& parents = delta.rows->internodes.parent;
    std::vector<InternodeId> stems; // remaining parents of removed rows
    for (InternodeId id = size(); id-- > end;) {
        const InternodeId parent = parents[id - end];
        if ((m_own[id] & kOwnAlive) != 0)
            m_removed.extend(m_position[id]);
        if ((m_own[id] & kOwnAlive) == 0 || parent == kNoInternode || parent >= end)
            continue;
        unlinkFrom(parent, id);
        m_sweep.add(parent, {.internodes = 0U - m_sums[id].internodes, .tips = 0U - m_sums[id].tips});
        stems.push_back(parent);
    }
    m_firstChild.resize(end);
    m_nextSibling.resize(end);
    m_mainChild.resize(end);
    m_axis.resize(end);
    while (!m_roots.empty() && m_roots.back() >= end)
        m_roots.pop_back();
    m_position.resize(end);
    m_rotation.resize(end);
    m_sums.resize(end);
    m_own.resize(end);
    for (const InternodeId id : stems)
        refreshOwn(tree, id);
}

Vec3 TreeIndex::basePosition(const Tree& tree, InternodeId id) const
{
    const InternodeId parent = tree.parent(id);
    if (parent == kNoInternode)
        return tree.rootPosition(id);
    const float along = tree.columns().along[id];
    if (along == 1.0F)
        return m_position[parent];
    return m_position[parent] - (1.0F - along) * tree.length(parent) * heading(parent);
}

std::uint32_t TreeIndex::livingCount() const
{
    std::uint32_t count = 0;
    for (const InternodeId root : m_roots)
        count += m_sums[root].internodes;
    return count;
}

InternodeId TreeIndex::rootOf(const Tree& tree, InternodeId id) const
{
    while (tree.parent(m_axis[id]) != kNoInternode)
        id = tree.parent(m_axis[id]);
    return m_axis[id];
}

void TreeIndex::place(const Tree& tree, InternodeId id)
{
    const InternodeColumns& c = tree.columns();
    const InternodeId parent = c.parent[id];
    const bool isBase = parent == kNoInternode;
    const Placement placement =
        placeOn(basePosition(tree, id), isBase ? Rotation(Rotation::Identity()) : m_rotation[parent],
                c.rotation[id], c.length[id]);
    m_position[id] = placement.node;
    m_rotation[id] = placement.rotation;
    m_greatestLength = std::max(m_greatestLength, c.length[id]);
}

/// Places changed internodes and all their descendants again; dead ones as well, since undo can revive them.
void TreeIndex::moveAll(const Tree& tree, const TreeDelta& delta)
{
    if (!delta.reframes()) {
        clearScratch(m_moved);
        clearScratch(m_moves);
        return;
    }
    m_moved.clear();
    m_moves.assign(tree.size(), 0);
    InternodeId first = tree.size();
    delta.forEachReframed([&](InternodeId id) {
        m_moves[id] = 1;
        first = std::min(first, id);
    });
    // Parents come before their children.
    for (InternodeId id = first; id < tree.size(); ++id) {
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
            m_moves[id] |= m_moves[parent];
        if (m_moves[id] == 0)
            continue;
        place(tree, id);
        m_moved.push_back(id);
    }
}

void TreeIndex::link(const Tree& tree, InternodeId id)
{
    const InternodeId parent = tree.parent(id);
    if (parent == kNoInternode)
        return;
    if (tree.continuesAxis(id))
        m_mainChild[parent] = id;
    InternodeId* place = &m_firstChild[parent];
    while (*place < id) // kNoInternode is larger than any id
        place = &m_nextSibling[*place];
    m_nextSibling[id] = *place;
    *place = id;
}

void TreeIndex::unlink(const Tree& tree, InternodeId id)
{
    if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
        unlinkFrom(parent, id);
}

void TreeIndex::unlinkFrom(InternodeId parent, InternodeId id)
{
    if (m_mainChild[parent] == id)
        m_mainChild[parent] = kNoInternode;
    InternodeId* place = &m_firstChild[parent];
    while (*place != id)
        place = &m_nextSibling[*place];
    *place = std::exchange(m_nextSibling[id], kNoInternode);
}

void TreeIndex::refreshOwn(const Tree& tree, InternodeId id)
{
    const bool alive = tree.isAlive(id);
    const bool tip = alive && m_firstChild[id] == kNoInternode;
    const auto own = static_cast<std::uint8_t>((alive ? kOwnAlive : 0) | (tip ? kOwnTip : 0));
    const std::uint8_t before = std::exchange(m_own[id], own);
    if (own == before)
        return;
    const auto change = [&](std::uint8_t flag) {
        return static_cast<std::uint32_t>((own & flag) != 0) -
               static_cast<std::uint32_t>((before & flag) != 0);
    };
    m_sweep.add(id, {.internodes = change(kOwnAlive), .tips = change(kOwnTip)});
}

} // namespace espalier
