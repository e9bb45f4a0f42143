// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/growth/GrowthIndex.h"

#include "model/growth/Buds.h"

#include <cmath>

namespace espalier {

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
    // A tree that was grown in other proportions than those in force now may be too sparse for voxels of the
    // size that they ask for.
    float edge = m_settings.edge;
    while (!fill(tree, index, edge))
        edge *= 2.0F;
}

bool GrowthIndex::fill(const Tree& tree, const TreeIndex& index, float edge)
{
    m_space = VoxelSpace(edge, m_settings.pyramid);
    m_inSpace.assign(tree.size(), 0);
    m_sensed.assign(tree.size(), 0);
    m_own.assign(tree.size(), 0);
    m_basipetal.assign(tree.size(), 0);
    m_pending.assign(tree.size(), 0);
    m_sweep = {};
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (!tree.isAlive(id))
            continue;
        if (m_space.isOverfull())
            return false;
        m_space.insert(id, index.nodePosition(id));
        m_inSpace[id] = 1;
    }
    castAndSweep(tree, index);
    return !m_space.isOverfull();
}

void GrowthIndex::update(const Tree& tree, const TreeIndex& index, const TreeDelta& delta)
{
    if (delta.parametersBefore != delta.parametersAfter &&
        settingsOf(tree.parameters().growth) != m_settings) {
        rebuild(tree, index);
        return;
    }
    m_inSpace.resize(tree.size(), 0);
    m_sensed.resize(tree.size(), 0);
    m_own.resize(tree.size(), 0);
    m_basipetal.resize(tree.size(), 0);
    m_pending.resize(tree.size(), 0);
    delta.forEachTouched([&](InternodeId id) {
        const bool alive = tree.isAlive(id);
        if (alive == (m_inSpace[id] != 0))
            return;
        m_inSpace[id] = alive ? 1 : 0;
        if (alive)
            m_space.insert(id, index.nodePosition(id));
        else
            m_space.remove(id, index.nodePosition(id));
    });
    // Light follows with the shadows cast below; buds that came or went change their node's sum where the
    // light does not.
    delta.forEachTouched([&](InternodeId id) {
        m_sensed[id] = sensedLight(m_space.shadow(m_space.cellAt(index.nodePosition(id))));
        refresh(tree, index, id);
    });
    castAndSweep(tree, index);
    if (m_space.isOverfull())
        rebuild(tree, index);
}

void GrowthIndex::castAndSweep(const Tree& tree, const TreeIndex& index)
{
    m_space.castShadows([&](VoxelSpace::Residents residents, std::uint32_t shadow) {
        const std::int32_t sensed = sensedLight(shadow);
        for (const Resident& resident : residents) {
            m_sensed[resident.id] = sensed;
            refresh(tree, index, resident.id);
        }
    });
    m_sweep.run(tree.columns().parent, [&](InternodeId id, InternodeId parent) {
        const std::int64_t pending = std::exchange(m_pending[id], 0);
        m_basipetal[id] += pending;
        if (parent != kNoInternode)
            m_pending[parent] += pending;
    });
}

std::int32_t GrowthIndex::sensedLight(std::uint32_t shadow) const
{
    const auto light = static_cast<double>(m_space.lightOfShadow(shadow));
    const double kappa = m_settings.lightSensitivity;
    return static_cast<std::int32_t>((kappa == 1.0 ? light : std::pow(light, kappa)) * kUnit + 0.5);
}

std::int32_t GrowthIndex::budQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const
{
    // Gravimorphism is a matter of lateral buds; a terminal one lies along its axis.
    if (slot == kTerminalSlot || m_settings.ellipse.isNeutral())
        return m_sensed[id];
    const Rotation& rotation = index.rotation(id);
    const Vec3 bud = budDirection(tree.seed(), id, slot, rotation, tree.parametersOf(id).growth);
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
    m_pending[id] += change;
    m_sweep.mark(id);
}

std::int64_t GrowthIndex::lateralQ(const Tree& tree, const TreeIndex& index, InternodeId id, int slot) const
{
    return budQ(tree, index, id, slot);
}

std::size_t GrowthIndex::bytes() const
{
    return m_space.bytes() + m_inSpace.capacity() + 2 * m_own.capacity() * sizeof(std::int32_t) +
           (m_basipetal.capacity() + m_pending.capacity()) * sizeof(std::int64_t);
}

} // namespace espalier
