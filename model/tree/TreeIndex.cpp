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
    linkAll(tree);
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
    changeLengths(tree, delta);
    findGreatestLength(tree);
    const auto forEachTouched = [&](auto&& visit) {
        if (isReverted)
            delta.forEachTouchedRow(visit);
        else
            delta.forEachTouched(visit);
    };
    std::vector<Relink> relinks;
    forEachTouched([&](InternodeId id) {
        const bool linked = (m_own[id] & kOwnAlive) != 0;
        if (tree.isAlive(id) == linked)
            return;
        if (!tree.isRoot(id))
            relinks.push_back({tree.parent(id), id});
        m_own[id] ^= kOwnAlive;
        m_sweep.add(id, {.internodes = linked ? ~0U : 1U});
    });
    relink(tree, relinks);
    // A birth or a death can change whether the internode or its parent is a tip.
    forEachTouched([&](InternodeId id) {
        refreshOwn(tree, id);
        if (!tree.isRoot(id))
            refreshOwn(tree, tree.parent(id));
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
        addLength(c.length[id]);
    }
}

/// Removes the rows that @p delta added. All descendants of a removed row are removed rows, too.
void TreeIndex::removeRows(const Tree& tree, const TreeDelta& delta)
{
    const std::uint32_t end = tree.size();
    const InternodeColumns& rows = delta.rows->internodes;
    std::vector<InternodeId> stems; // remaining parents of removed rows
    for (InternodeId id = size(); id-- > end;) {
        const InternodeId parent = rows.parent[id - end];
        dropLength(rows.length[id - end]);
        if ((m_own[id] & kOwnAlive) != 0)
            m_removed.extend(m_position[id]);
        if ((m_own[id] & kOwnAlive) == 0 || parent == kNoInternode || parent >= end)
            continue;
        m_sweep.add(parent, {.internodes = 0U - m_sums[id].internodes, .tips = 0U - m_sums[id].tips});
        stems.push_back(parent);
    }
    std::ranges::sort(stems);
    const auto repeated = std::ranges::unique(stems);
    stems.erase(repeated.begin(), repeated.end());
    for (const InternodeId stem : stems) {
        // Removed rows have the highest ids, so they end the list.
        InternodeId* place = &m_firstChild[stem];
        while (*place < end)
            place = &m_nextSibling[*place];
        *place = kNoInternode;
        if (m_mainChild[stem] >= end)
            m_mainChild[stem] = kNoInternode;
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

std::uint32_t TreeIndex::greatestTipCount() const
{
    std::uint32_t greatest = 0;
    for (const InternodeId root : m_roots)
        greatest = std::max(greatest, m_sums[root].tips);
    return greatest;
}

InternodeId TreeIndex::rootOf(const Tree& tree, InternodeId id) const
{
    while (!tree.isRoot(m_axis[id]))
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
        if (!tree.isRoot(id))
            m_moves[id] |= m_moves[tree.parent(id)];
        if (m_moves[id] == 0)
            continue;
        place(tree, id);
        m_moved.push_back(id);
    }
}

/// Links all living internodes to their parents, which have no children yet.
void TreeIndex::linkAll(const Tree& tree)
{
    // From the last to the first, so that each one becomes the first of its list.
    for (InternodeId id = tree.size(); id-- > 0;) {
        if (!tree.isAlive(id) || tree.isRoot(id))
            continue;
        const InternodeId parent = tree.parent(id);
        m_nextSibling[id] = std::exchange(m_firstChild[parent], id);
        if (tree.continuesAxis(id))
            m_mainChild[parent] = id;
    }
}

/// Takes each internode of @p changes out of its parent's list of children, or puts it in if it is not there.
/// Walks each list once, whatever the number of changes in it. Sorts @p changes.
void TreeIndex::relink(const Tree& tree, std::vector<Relink>& changes)
{
    std::ranges::sort(changes);
    InternodeId* place = nullptr;
    InternodeId walked = kNoInternode; // the parent whose list is being walked
    for (const auto& [parent, id] : changes) {
        if (parent != walked)
            place = &m_firstChild[parent];
        walked = parent;
        while (*place < id) // kNoInternode is larger than any id
            place = &m_nextSibling[*place];
        if (*place == id) {
            *place = std::exchange(m_nextSibling[id], kNoInternode);
            if (m_mainChild[parent] == id)
                m_mainChild[parent] = kNoInternode;
            continue;
        }
        m_nextSibling[id] = std::exchange(*place, id);
        if (tree.continuesAxis(id))
            m_mainChild[parent] = id;
    }
}

void TreeIndex::addLength(float length)
{
    if (length > m_greatestLength) {
        m_greatestLength = length;
        m_longest = 0;
    }
    if (length == m_greatestLength)
        ++m_longest;
}

void TreeIndex::dropLength(float length)
{
    if (length == m_greatestLength)
        --m_longest;
}

void TreeIndex::changeLengths(const Tree& tree, const TreeDelta& delta)
{
    bool isBornChanged = false;
    for (const auto& change : delta.internodes.length) {
        if (delta.born.contains(change.row)) {
            isBornChanged = true;
            continue;
        }
        const float now = tree.length(change.row);
        // The delta was applied or reverted; it does not say which.
        dropLength(now == change.after ? change.before : change.after);
        addLength(now);
    }
    // The delta keeps new rows as they were born; removed ones may have been counted with another length.
    if (isBornChanged)
        m_longest = 0;
}

/// Looks for the longest internodes if those that were are gone.
void TreeIndex::findGreatestLength(const Tree& tree)
{
    if (m_longest > 0)
        return;
    m_greatestLength = 0.0F;
    for (const float length : tree.columns().length)
        addLength(length);
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
