// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowingTree.h"

#include "model/base/Random.h"

namespace espalier {

GrowingTree::GrowingTree(const Tree& tree, const TreeIndex& index, GrowthWorkspace& workspace)
    : m_tree(tree),
      m_index(index),
      m_workspace(workspace),
      m_delta(deltaStartingAt(tree)),
      m_rows(std::make_shared<TreeRows>())
{
    m_workspace.buds.clear(tree.size());
    m_workspace.lengths.clear(tree.size());
    // Only sets that have changed are prepared: a tree with a long history has many, and a step must be fast.
    std::vector<BudAngles>& angles = m_workspace.budAngles;
    std::size_t set = 0;
    for (const TreeParameters& parameters : tree.parameterSets()) {
        if (set == angles.size())
            angles.emplace_back(parameters);
        else if (!angles[set].areOf(parameters))
            angles[set] = BudAngles(parameters);
        ++set;
    }
}

BudStates GrowingTree::budsOfNew(InternodeId parent, int slot, double length) const
{
    BudStates states = BudStates::active(newBuds(m_tree.parameters()));
    if (slot != kTerminalSlot || m_tree.content().sparse.clearLength.cells().empty())
        return states;
    const InternodeId first = axis(parent);
    const auto clear = static_cast<double>(m_tree.clearLength(first));
    for (InternodeId id = parent; length < clear; id = this->parent(id)) {
        length += static_cast<double>(this->length(id));
        if (id == first) {
            if (length < clear)
                states.other = static_cast<BudMask>(states.living & ~kTerminalBud);
            break;
        }
    }
    return states;
}

InternodeId GrowingTree::grow(InternodeId parent, int slot, const Vec3& direction, double roll, double length,
                              double vigour)
{
    const InternodeId id = size();
    BudStates states = budStates(parent);
    states.set(slot, BudState::None);
    if (isNew(parent)) {
        rows().buds[parent - m_tree.size()] = states;
    } else if (m_workspace.buds.setOnce(parent, states)) {
        m_changedBuds.push_back(parent);
    } else {
        m_workspace.buds.set(parent, states);
    }

    const Rotation& parentRotation = rotation(parent);
    const Vec3 heading = parentRotation * Vec3(Vec3::UnitY());
    const Rotation turn(Eigen::Quaternionf::FromTwoVectors(heading, direction));
    const Rotation spin(Eigen::Quaternionf(Eigen::AngleAxisf(static_cast<float>(roll), Vec3::UnitY())));
    const Rotation local = (parentRotation.conjugate() * (turn * parentRotation) * spin).normalized();

    rows().append({.parent = parent,
                   .rotation = local,
                   .length = static_cast<float>(length),
                   .vigour = static_cast<float>(vigour),
                   .slot = static_cast<std::uint8_t>(slot),
                   .buds = budsOfNew(parent, slot, length),
                   .birth = m_tree.step() + 1,
                   .parameterSet = static_cast<std::uint16_t>(m_tree.currentParameterSet()),
                   .key = childKey(key(parent), slot, m_tree.step() + 1)});

    const Placement placement =
        placeOn(stretchedPosition(parent), parentRotation, local, static_cast<float>(length));
    m_axes.push_back(slot == kTerminalSlot ? axis(parent) : id);
    m_positions.push_back(placement.node);
    m_rotations.push_back(placement.rotation);
    return id;
}

void GrowingTree::stretch(InternodeId id, float length)
{
    if (m_workspace.lengths.setOnce(id, length))
        m_stretched.push_back(id);
    else
        m_workspace.lengths.set(id, length);
}

void GrowingTree::turn(InternodeId id, const Rotation& local)
{
    m_delta.internodes.rotation.push_back({id, m_tree.columns().rotation[id], local});
}

void GrowingTree::setAddedVigour(InternodeId id, float years)
{
    const std::optional<float> before = m_tree.content().sparse.addedVigour.at(id);
    const std::optional<float> after = years > 0.0F ? std::optional<float>(years) : std::nullopt;
    if (before != after)
        m_delta.sparse.addedVigour.push_back({id, before, after});
}

void GrowingTree::setDrawnLength(InternodeId axis, float length)
{
    const std::optional<float> before = m_tree.content().sparse.drawnLength.at(axis);
    const float after = std::min(length, kGreatestClearLength);
    if (before != after)
        m_delta.sparse.drawnLength.push_back({axis, before, after});
}

std::vector<Cell> GrowingTree::newCells(const VoxelSpace& space) const
{
    std::vector<Cell> cells;
    cells.reserve(m_positions.size());
    for (const Vec3& position : m_positions)
        cells.push_back(space.cellAt(position));
    std::ranges::sort(cells);
    const auto repeated = std::ranges::unique(cells);
    cells.erase(repeated.begin(), repeated.end());
    return cells;
}

TreeDelta GrowingTree::takeDelta()
{
    if (!m_changedBuds.empty())
        m_delta.internodes.buds.reserve(m_changedBuds.size());
    for (const InternodeId id : m_changedBuds)
        m_delta.internodes.buds.push_back({id, m_tree.budStates(id), m_workspace.buds[id]});
    for (const InternodeId id : m_stretched)
        m_delta.internodes.length.push_back({id, m_tree.length(id), m_workspace.lengths[id]});
    m_delta.born.count = rows().size();
    if (m_delta.born.count > 0)
        m_delta.rows = std::move(m_rows);
    if (!m_delta.isEmpty())
        m_delta.stepAfter = m_delta.stepBefore + 1;
    return std::move(m_delta);
}

} // namespace espalier
