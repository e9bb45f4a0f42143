// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/picking/PickIndex.h"

#include "model/base/Headroom.h"

#include <algorithm>
#include <cmath>

namespace espalier {

namespace {

/// Initial edge of a cell, in internodes of mean length.
constexpr float kInternodesPerEdge = 8.0F;
constexpr float kLeastCellEdge = 1e-4F; ///< m
/// Cells that hold more nodes than this on average are too large; fewer, too small.
constexpr std::uint32_t kMostNodes = 320;
constexpr std::uint32_t kFewestNodes = 5;
/// Trees with fewer nodes keep their cells: searching all of them is fast.
constexpr std::uint32_t kSmallTree = 2'000;
/// Cells are numbered from -kFarthestPoint to kFarthestPoint along each axis; what lies farther out is in the
/// outermost.
constexpr float kFarthestPoint = 1'000'000.0F;
/// Least room for further nodes in a cell that has to grow; most cells hold some dozens.
constexpr std::size_t kCellHeadroom = 4;

} // namespace

void PickIndex::clear()
{
    *this = {};
}

void PickIndex::follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    // Before the first query, or if all will be read again, there is nothing to note.
    if (m_edge == 0.0F)
        return;
    const auto note = [this](InternodeId id) {
        if (id >= m_isNoted.size())
            m_isNoted.resize(id + std::size_t{1}, false);
        if (!m_isNoted[id]) {
            m_isNoted[id] = true;
            m_noted.push_back(id);
        }
    };
    delta.forEachTouched(note);
    for (const InternodeId id : index.recentlyMoved())
        note(id);
    if (m_noted.size() > kSmallTree && m_noted.size() > tree.size())
        clear();
}

void PickIndex::settle(const Tree& tree, const TreeIndex& index)
{
    m_lastCost = 0;
    if (m_edge == 0.0F) {
        readAll(tree, index);
        return;
    }
    // Rows at the tree's end may have been removed.
    for (std::size_t id = tree.size(); id < m_place.size(); ++id) {
        ++m_lastCost;
        remove(static_cast<InternodeId>(id));
    }
    resizeColumn(m_place, tree.size(), kNowhere);
    for (const InternodeId id : m_noted) {
        m_isNoted[id] = false;
        if (id < tree.size())
            update(tree, index, id);
    }
    m_lastCost += m_noted.size();
    clearScratch(m_noted);
    while (suitDensity())
        fill(tree, index);
}

void PickIndex::readAll(const Tree& tree, const TreeIndex& index)
{
    double length = 0.0;
    std::uint32_t count = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        length += static_cast<double>(tree.length(id));
        ++count;
    }
    const double mean = length / std::max(count, 1U);
    m_edge = std::max(kInternodesPerEdge * static_cast<float>(mean), kLeastCellEdge);
    do
        fill(tree, index);
    while (suitDensity());
}

void PickIndex::fill(const Tree& tree, const TreeIndex& index)
{
    m_lastCost += tree.size();
    m_cells.clear();
    m_cellOf.clear();
    m_place.assign(tree.size(), kNowhere);
    m_nodeCount = 0;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id))
            insert(id, index.nodePosition(id));
    }
}

/// Changes the edge if cells hold far too many nodes, or too few; then all cells must be filled again.
bool PickIndex::suitDensity()
{
    const std::size_t cells = std::max<std::size_t>(m_cells.size(), 1);
    // Nodes at one and the same place cannot be parted.
    if (m_nodeCount > kSmallTree && m_nodeCount > kMostNodes * cells && m_edge > kLeastCellEdge) {
        m_edge = std::max(0.5F * m_edge, kLeastCellEdge);
        return true;
    }
    if (m_cells.size() > kSmallTree && m_nodeCount < kFewestNodes * cells && m_edge < kFarthestPoint) {
        // Where cells have become empty, it is enough to drop these.
        const auto empty = static_cast<std::size_t>(
            std::ranges::count_if(m_cells, [](const Cell& cell) { return cell.nodes.empty(); }));
        if (2 * empty < m_cells.size())
            m_edge *= 2.0F;
        return true;
    }
    return false;
}

void PickIndex::update(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    const std::uint32_t place = m_place[id];
    if (!tree.isAlive(id)) {
        remove(id);
        return;
    }
    const Vec3& position = index.nodePosition(id);
    if (place != kNowhere && cellAt(position) == place) {
        Cell& cell = m_cells[place];
        *std::ranges::find(cell.nodes, id, &Node::id) = {position.x(), position.y(), position.z(), id};
        cell.lower = cell.lower.cwiseMin(position);
        cell.upper = cell.upper.cwiseMax(position);
        return;
    }
    remove(id);
    insert(id, position);
}

std::uint64_t PickIndex::keyOf(const Vec3& position) const
{
    const auto along = [this](float coordinate) {
        const float cell = std::clamp(std::floor(coordinate / m_edge), -kFarthestPoint, kFarthestPoint);
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell) + std::int64_t{1'000'000});
    };
    return along(position.x()) | along(position.y()) << 21 | along(position.z()) << 42;
}

std::uint32_t PickIndex::cellAt(const Vec3& position)
{
    const auto [found, isNew] =
        m_cellOf.try_emplace(keyOf(position), static_cast<std::uint32_t>(m_cells.size()));
    if (isNew) {
        makeRoom(m_cells, m_cells.size() + 1);
        m_cells.emplace_back();
    }
    return found->second;
}

void PickIndex::insert(InternodeId id, const Vec3& position)
{
    const std::uint32_t place = cellAt(position);
    Cell& cell = m_cells[place];
    cell.lower = cell.nodes.empty() ? position : Vec3(cell.lower.cwiseMin(position));
    cell.upper = cell.nodes.empty() ? position : Vec3(cell.upper.cwiseMax(position));
    makeRoom(cell.nodes, cell.nodes.size() + 1, kCellHeadroom);
    cell.nodes.push_back({position.x(), position.y(), position.z(), id});
    m_place[id] = place;
    ++m_nodeCount;
}

void PickIndex::remove(InternodeId id)
{
    if (m_place[id] == kNowhere)
        return;
    std::vector<Node>& nodes = m_cells[m_place[id]].nodes;
    // Searches from the end, because undo removes the latest nodes first.
    const auto found = std::ranges::find(nodes.rbegin(), nodes.rend(), id, &Node::id);
    *found = nodes.back();
    nodes.pop_back();
    if (nodes.capacity() > withHeadroom(nodes.size(), kCellHeadroom))
        nodes.shrink_to_fit();
    m_place[id] = kNowhere;
    --m_nodeCount;
}

std::size_t PickIndex::bytes() const
{
    // A hash map has a bucket and a linked entry for each key.
    constexpr std::size_t kEntry = sizeof(std::uint64_t) + sizeof(std::uint32_t) + 3 * sizeof(void*);
    std::size_t bytes = m_cells.capacity() * sizeof(Cell) + m_cellOf.size() * kEntry +
                        m_place.capacity() * sizeof(std::uint32_t) + m_isNoted.capacity() / 8 +
                        m_noted.capacity() * sizeof(InternodeId);
    for (const Cell& cell : m_cells)
        bytes += cell.nodes.capacity() * sizeof(Node);
    return bytes;
}

} // namespace espalier
