// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthIndex.h"

#include "model/growth/Buds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace espalier {

namespace {

/// The smallest voxel edge, m; doubled kMostDoublings times, it exceeds any tree.
constexpr float kLeastEdge = 1e-6F;
constexpr int kMostDoublings = 64;

} // namespace

GrowthIndex::Settings GrowthIndex::settingsOf(const GrowthParameters& p)
{
    return {static_cast<float>(p.occupancyRadius * p.internodeLength),
            {p.shadowIntensity, p.shadowFalloff, p.shadowDepth},
            p.lightSensitivity,
            {p.ellipseVertical, p.ellipseParallel, p.ellipseOffset}};
}

void GrowthIndex::rebuild(const Tree& tree, const TreeIndex& index)
{
    m_settings = settingsOf(tree.parameters().growth);
    // The voxel size follows from the parameters in force. A tree that grew with other proportions may be too
    // sparse for voxels of that size, so they are enlarged until they are few enough.
    float edge = std::max(m_settings.edge, kLeastEdge);
    for (int i = 0; i < kMostDoublings && !fill(tree, index, edge); ++i)
        edge *= 2.0F;
}

bool GrowthIndex::fill(const Tree& tree, const TreeIndex& index, float edge)
{
    m_space = VoxelSpace(edge, m_settings.pyramid);
    m_isNoted.assign(tree.size(), false);
    clearScratch(m_noted);
    m_hasRemovedRows = false;
    resize(0);
    resize(tree.size());
    m_sweep = {};
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        if (m_space.isOverfull())
            return false;
        m_place[id] = m_space.insert(id, index.nodePosition(id));
    }
    castAndSweep(tree, index);
    return !m_space.isOverfull();
}

void GrowthIndex::follow(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    const bool isReverted = m_isNoted.size() > tree.size();
    if (isReverted)
        removeRows(tree, delta);
    m_isNoted.resize(tree.size(), false);
    const auto note = [&](InternodeId id) {
        if (!m_isNoted[id]) {
            m_isNoted[id] = true;
            m_noted.push_back(id);
        }
    };
    if (isReverted)
        delta.forEachTouchedRow(note);
    else
        delta.forEachTouched(note);
    for (const InternodeId id : index.recentlyMoved())
        note(id);
}

/// Removes the rows that @p delta added, and their contributions to the sums below them.
void GrowthIndex::removeRows(const Tree& tree, const TreeDelta& delta)
{
    const std::uint32_t end = tree.size();
    const auto known =
        static_cast<InternodeId>(m_place.size()); // rows since the last settle() are not in the index yet
    for (InternodeId id = end; id < known; ++id) {
        if (m_place[id] != kNowhere)
            m_space.remove(id, m_place[id]);
        const InternodeId parent = delta.rows->internodes.parent[id - end];
        if (parent < end && m_basipetal[id] != 0)
            m_sweep.add(parent, -m_basipetal[id]);
    }
    m_hasRemovedRows = true;
    m_sweep.truncate(end);
    if (known > end)
        resize(end);
}

void GrowthIndex::resize(std::uint32_t size)
{
    resizeColumn(m_place, size, kNowhere);
    resizeColumn(m_sensed, size, 0);
    resizeColumn(m_own, size, 0);
    resizeColumn(m_basipetal, size, 0);
}

void GrowthIndex::settle(const Tree& tree, const TreeIndex& index)
{
    settleSome(tree, index, std::numeric_limits<std::size_t>::max());
}

bool GrowthIndex::settleSome(const Tree& tree, const TreeIndex& index, std::size_t nodes)
{
    if (settingsOf(tree.parameters().growth) != m_settings) {
        rebuild(tree, index);
        return true;
    }
    if (m_noted.empty() && !std::exchange(m_hasRemovedRows, false))
        return true;
    resize(tree.size());
    const std::span<const InternodeId> noted = std::span(m_noted).last(std::min(nodes, m_noted.size()));
    for (const InternodeId id : noted) {
        // The row was removed since, or is noted twice.
        if (id >= tree.size() || !m_isNoted[id])
            continue;
        m_isNoted[id] = false;
        const Vec3& position = index.nodePosition(id);
        const bool isAlive = tree.isAlive(id);
        if (m_place[id] != kNowhere && !(isAlive && m_space.isAt(m_place[id], position))) {
            m_space.remove(id, m_place[id]);
            m_place[id] = kNowhere;
        }
        if (m_place[id] == kNowhere && isAlive)
            m_place[id] = m_space.insert(id, position);
    }
    // castAndSweep() updates nodes whose light changes. The sums of the noted nodes can also change without
    // the light: buds were added or removed, or the node was turned.
    for (const InternodeId id : noted) {
        if (id >= tree.size())
            continue;
        m_sensed[id] = sensedLight(m_space.shadow(m_space.cellAt(index.nodePosition(id))));
        refresh(tree, index, id);
    }
    m_noted.resize(m_noted.size() - noted.size());
    if (m_noted.empty())
        clearScratch(m_noted);
    castAndSweep(tree, index);
    if (m_space.isOverfull())
        rebuild(tree, index);
    return m_noted.empty();
}

void GrowthIndex::castAndSweep(const Tree& tree, const TreeIndex& index)
{
    m_space.castShadows([&](VoxelSpace::Residents residents, std::uint32_t shadow) {
        const std::int32_t sensed = sensedLight(shadow);
        for (const InternodeId id : residents) {
            m_sensed[id] = sensed;
            refresh(tree, index, id);
        }
    });
    m_sweep.run(tree.columns().parent,
                [&](InternodeId id, std::int64_t difference) { m_basipetal[id] += difference; });
}

std::int32_t GrowthIndex::sensedLight(std::uint32_t shadow) const
{
    const auto light = static_cast<double>(m_space.lightOfShadow(shadow));
    const double kappa = m_settings.lightSensitivity;
    return static_cast<std::int32_t>((kappa == 1.0 ? light : std::pow(light, kappa)) * kUnit + 0.5);
}

std::int32_t GrowthIndex::budQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const
{
    // Gravimorphism affects lateral buds only: a terminal bud points along its axis.
    if (slot == kTerminalSlot || m_settings.ellipse.isNeutral())
        return m_sensed[id];
    const Rotation& rotation = index.rotation(id);
    const Vec3 bud = budDirection(tree.key(id), slot, rotation, tree.parametersOf(id));
    const double bias = gravimorphicBias(m_settings.ellipse, rotation * Vec3(Vec3::UnitY()), bud);
    return static_cast<std::int32_t>(bias * m_sensed[id] + 0.5);
}

void GrowthIndex::refresh(const Tree& tree, const TreeIndex& index, InternodeId id)
{
    std::int32_t own = 0;
    if (tree.isAlive(id)) {
        for (unsigned rest = tree.buds(id); rest != 0; rest &= rest - 1)
            own += budQ(tree, index, id, std::countr_zero(rest));
    }
    const std::int32_t change = own - m_own[id];
    if (change == 0)
        return;
    m_own[id] = own;
    m_sweep.add(id, change);
}

std::int64_t GrowthIndex::lateralQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const
{
    return budQ(tree, index, id, slot);
}

std::size_t GrowthIndex::bytes() const
{
    return m_space.bytes() + m_place.capacity() * sizeof(VoxelSpace::Place) + m_isNoted.capacity() / 8 +
           m_noted.capacity() * sizeof(InternodeId) +
           (m_sensed.capacity() + m_own.capacity()) * sizeof(std::int32_t) +
           m_basipetal.capacity() * sizeof(std::int64_t) + m_sweep.bytes();
}

} // namespace espalier
