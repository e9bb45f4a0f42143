// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Vector.h"
#include "model/tree/TreeIndex.h"

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace espalier {

/// The places of the living nodes of a tree, for finding nodes along a ray: cubic cells, each with a box
/// around its nodes. Follows the tree's deltas, forwards and backwards, in proportion to what they touch;
/// deltas are noted, and processed before the next query. It does not depend on a growth model. Cells exist
/// only where there are nodes, and their edge depends on the density of the tree.
class PickIndex {
public:
    /// A living node: the upper end of an internode.
    struct Node {
        float x; ///< m
        float y;
        float z;
        InternodeId id;

        Vec3 position() const { return {x, y, z}; }
        bool operator==(const Node&) const = default;
    };
    using Nodes = std::span<const Node>;

    /// Forgets everything because the document has another tree. The next settle() reads all of it.
    void clear();
    /// Notes what @p delta, which @p tree and @p index have just applied or reverted, has changed. Ids of
    /// tree.size() or more are nodes that do not exist any more.
    void follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta);
    /// Processes the noted changes. Call it before a query.
    void settle(const Tree& tree, const TreeIndex& index);

    /// Calls @p visit(centre, radius, nodes) for all living nodes, cell by cell; centre and radius are those
    /// of a ball around the cell's nodes, m.
    template <class Visit>
    void forEachCell(Visit&& visit) const
    {
        for (const Cell& cell : m_cells) {
            if (!cell.nodes.empty())
                visit(Vec3(0.5F * (cell.lower + cell.upper)), 0.5F * (cell.upper - cell.lower).norm(),
                      Nodes(cell.nodes));
        }
    }

    std::uint32_t nodeCount() const { return m_nodeCount; }
    std::size_t cellCount() const { return m_cells.size(); }
    /// Number of nodes that the last settle() has read.
    std::size_t lastCost() const { return m_lastCost; }
    std::size_t bytes() const;

private:
    struct Cell {
        std::vector<Node> nodes;
        Vec3 lower = Vec3::Zero(); ///< Of a box around the nodes, which can be larger after nodes have gone
        Vec3 upper = Vec3::Zero();
    };

    void readAll(const Tree& tree, const TreeIndex& index);
    void fill(const Tree& tree, const TreeIndex& index);
    void update(const Tree& tree, const TreeIndex& index, InternodeId id);
    bool suitDensity();
    std::uint64_t keyOf(const Vec3& position) const;
    std::uint32_t cellAt(const Vec3& position);
    void insert(InternodeId id, const Vec3& position);
    void remove(InternodeId id);

    static constexpr std::uint32_t kNowhere = ~0U;

    float m_edge = 0.0F; ///< Edge of a cell, m; 0 until the tree has been read
    std::vector<Cell> m_cells;
    std::unordered_map<std::uint64_t, std::uint32_t> m_cellOf; ///< By keyOf()
    std::vector<std::uint32_t> m_place; ///< The cell of each node; kNowhere for dead nodes
    std::uint32_t m_nodeCount = 0;
    std::vector<bool> m_isNoted;
    std::vector<InternodeId> m_noted; ///< Nodes that settle() has to process
    std::size_t m_lastCost = 0;
};

} // namespace espalier
