// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/BudGrid.h"

#include <numeric>

namespace espalier {

namespace {

/// With more cells than these, clearing them takes longer than searching.
constexpr std::size_t kCellsPerNode = 8;
constexpr std::size_t kFewestCells = 512;

/// The result of sorting by keys, 0 ≤ key < count: the indices of the keys in ascending order (stable), and
/// the position at which the indices of each key begin (count + 1 entries).
struct Sorted {
    std::vector<std::uint32_t> order;
    std::vector<std::uint32_t> begin;
};
Sorted sortByKey(std::span<const std::uint32_t> keys, std::size_t count)
{
    Sorted sorted{std::vector<std::uint32_t>(keys.size()), std::vector<std::uint32_t>(count + 1, 0)};
    for (const std::uint32_t key : keys)
        ++sorted.begin[key + 1];
    std::partial_sum(sorted.begin.begin(), sorted.begin.end(), sorted.begin.begin());
    std::vector<std::uint32_t> next(sorted.begin.begin(), sorted.begin.end() - 1);
    for (std::size_t i = 0; i < keys.size(); ++i)
        sorted.order[next[keys[i]]++] = static_cast<std::uint32_t>(i);
    return sorted;
}

Vec3 positionOf(const GridNode& node)
{
    return {node.x, node.y, node.z};
}

} // namespace

BudGrid::BudGrid(std::span<const GridNode> nodes, float edge) : m_edge(edge)
{
    if (nodes.empty())
        return;
    Box3 box;
    for (const GridNode& node : nodes)
        box.extend(positionOf(node));
    const double mostCells = static_cast<double>(std::max(kFewestCells, kCellsPerNode * nodes.size()));
    const auto cells = [&] {
        const Eigen::Array3d counts =
            (box.sizes().cast<double>() / static_cast<double>(m_edge)).array() + 1.0;
        return counts.prod();
    };
    while (cells() > mostCells)
        m_edge *= 1.5F;
    m_origin = box.min();
    m_size = {1 << 30, 1 << 30, 1 << 30}; // no limit yet
    const Cell last = cellAt(box.max());
    m_size = {last.x + 1, last.y + 1, last.z + 1};

    std::vector<std::uint32_t> cellOf;
    cellOf.reserve(nodes.size());
    for (const GridNode& node : nodes)
        cellOf.push_back(static_cast<std::uint32_t>(cellIndex(cellAt(positionOf(node)))));
    Sorted sorted = sortByKey(cellOf, cellIndex(last) + 1);
    m_begin = std::move(sorted.begin);
    m_ids.reserve(nodes.size());
    for (std::vector<float>* const column : {&m_x, &m_y, &m_z})
        column->reserve(nodes.size());
    for (const std::uint32_t i : sorted.order) {
        m_ids.push_back(nodes[i].id);
        m_x.push_back(nodes[i].x);
        m_y.push_back(nodes[i].y);
        m_z.push_back(nodes[i].z);
    }
}

std::vector<std::uint32_t> BudGrid::orderOf(std::span<const Vec3> points) const
{
    std::vector<std::uint32_t> cellOf;
    cellOf.reserve(points.size());
    for (const Vec3& point : points) {
        const Cell cell = cellAt(point);
        cellOf.push_back(static_cast<std::uint32_t>(
            cellIndex({std::clamp(cell.x, 0, m_size.x - 1), std::clamp(cell.y, 0, m_size.y - 1),
                       std::clamp(cell.z, 0, m_size.z - 1)})));
    }
    return sortByKey(cellOf, isEmpty() ? 1 : m_begin.size() - 1).order;
}

Cell BudGrid::cellAt(const Vec3& point) const
{
    const auto along = [&](int axis, int size) {
        const float cells = (point[axis] - m_origin[axis]) / m_edge;
        const float limited = std::clamp(cells, -1.0F, static_cast<float>(size));
        return limited < 0.0F ? -1 : static_cast<int>(limited);
    };
    return {along(0, m_size.x), along(1, m_size.y), along(2, m_size.z)};
}

} // namespace espalier
