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
    m_changed.clear();
    m_sweep.run(tree.columns().parent, [&](InternodeId id, InternodeId parent) {
        const Sums pending = std::exchange(m_pending[id], {});
        m_sums[id].internodes += pending.internodes;
        m_sums[id].tips += pending.tips;
        if (parent != kNoInternode) {
            m_pending[parent].internodes += pending.internodes;
            m_pending[parent].tips += pending.tips;
        }
    });
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
        const std::uint32_t one = linked ? ~0U : 1U;
        m_pending[id].internodes += one;
        m_sweep.mark(id);
    });
    // A birth or a death can change whether the internode or its parent is a tip.
    forEachTouched([&](InternodeId id) {
        refreshOwn(tree, id);
        if (const InternodeId parent = tree.parent(id); parent != kNoInternode)
            refreshOwn(tree, parent);
    });

    m_changed.clear();
    m_sweep.run(tree.columns().parent, [&](InternodeId id, InternodeId parent) {
        const Sums pending = std::exchange(m_pending[id], {});
        if (pending == Sums{})
            return;
        m_sums[id].internodes += pending.internodes;
        m_sums[id].tips += pending.tips;
        m_changed.push_back(id);
        if (parent != kNoInternode) {
            m_pending[parent].internodes += pending.internodes;
            m_pending[parent].tips += pending.tips;
        }
    });
}

std::size_t TreeIndex::bytes() const
{
    constexpr std::size_t row =
        4 * sizeof(InternodeId) + sizeof(Vec3) + sizeof(Rotation) + 2 * sizeof(Sums) + 1;
    return m_sums.capacity() * row;
}

void TreeIndex::appendRows(const Tree& tree)
{
    const InternodeColumns& c = tree.columns();
    const std::uint32_t begin = size();
    const std::uint32_t end = tree.size();
    if (begin == end)
        return;
    m_firstChild.resize(end, kNoInternode);
    m_nextSibling.resize(end, kNoInternode);
    m_mainChild.resize(end, kNoInternode);
    m_axis.resize(end);
    m_position.resize(end);
    m_rotation.resize(end);
    m_sums.resize(end);
    m_own.resize(end, 0);
    m_pending.resize(end);
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
        m_pending[parent].internodes -= m_sums[id].internodes;
        m_pending[parent].tips -= m_sums[id].tips;
        m_sweep.mark(parent);
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
    m_pending.resize(end);
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
    m_moved.clear();
    if (!delta.reframes())
        return;
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
    m_pending[id].internodes += static_cast<std::uint32_t>(own & kOwnAlive) - (before & kOwnAlive);
    m_pending[id].tips += static_cast<std::uint32_t>((own & kOwnTip) >> 1) - ((before & kOwnTip) >> 1);
    m_sweep.mark(id);
}

} // namespace espalier
