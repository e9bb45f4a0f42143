// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/EnvelopeGrowth.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace espalier {

namespace {

/// More markers only cost time; with fewer, it depends on chance whether thin parts are filled.
constexpr double kMostMarkers = 120'000;
constexpr double kFewestMarkers = 400;
/// In units of the density of a brush's living markers: a brush adds markers all the time, here all are there
/// from the start.
constexpr double kDensity = 10.0;
/// Nodes keep this far from the surface, in leaf lengths, so that leaves end about there.
constexpr double kMargin = 0.8;
/// Number of leaders of one growth; the pockets that are left after these are not worth the time.
constexpr int kMostLeaders = 200;
/// Number of remaining markers that are checked for a bud nearby; markers are in random order.
constexpr std::size_t kAsked = 300;

/// Parts that rise less than this above the drawing plane, in occupancy radii, are filled a second time, with
/// the occupancy radius multiplied by kThinOccupancy.
constexpr double kThin = 1.5;
constexpr float kThinOccupancy = 0.5F;

double marginOf(const TreeParameters& p)
{
    const double leaf = p.leaves.visible && p.leaves.perNode > 0 ? p.leaves.length : 0.0;
    return kMargin * leaf;
}

/// The living bud of a node whose direction is nearest to that of @p target.
BudRef bestBud(const Tree& tree, const TreeIndex& index, InternodeId id, const Vec3& target,
               GrowthWorkspace& workspace)
{
    const GrowingTree growing(tree, index, workspace);
    const Vec3 toTarget = target - index.nodePosition(id);
    BudRef best{id, kTerminalSlot};
    float greatest = -std::numeric_limits<float>::infinity();
    for (unsigned rest = tree.buds(id); rest != 0; rest &= rest - 1) {
        const int slot = std::countr_zero(rest);
        const float along = growing.budDirection(id, slot).dot(toTarget);
        if (along > greatest) {
            greatest = along;
            best.slot = slot;
        }
    }
    return best;
}

} // namespace

EnvelopeGrowth::EnvelopeGrowth(EnvelopeSet envelopes, const Tree& tree, Competitors competitors)
    : m_envelopes(std::move(envelopes)), m_competitors(competitors)
{
    layMarkers(tree);
}

void EnvelopeGrowth::layMarkers(const Tree& tree)
{
    const GrowthParameters& p = tree.parameters().growth;
    const double volume = m_envelopes.volume() / std::pow(p.internodeLength, 3);
    const double count = std::clamp(kDensity * p.markerDensity * volume, kFewestMarkers, kMostMarkers);
    m_markers.positions =
        m_envelopes.sampleUniform(static_cast<std::size_t>(count), tree.seed(), tree.step());
    // There is no free space below the ground.
    const double thin = kThin * p.occupancyRadius * p.internodeLength;
    std::erase_if(m_markers.positions, [&](const Vec3& marker) {
        return marker.y() < 0.0F || (m_isInThinParts && m_envelopes.riseAt(marker) > thin);
    });
    m_markers.born.assign(m_markers.positions.size(), 0);
}

TreeDelta EnvelopeGrowth::step(const Tree& tree, const TreeIndex& index, const GrowthModel& model)
{
    GrowthStepOptions options = GrowthStepOptions::of(tree.parameters().growth);
    // The envelope sets the form of the crown; shed branches would leave holes in it.
    options.sheds = false;
    // Branches that straighten could leave it.
    options.straightens = false;
    options.competitors = m_competitors;
    const double margin = marginOf(tree.parameters());
    // Shoots may grow into the envelope from outside until a bud is inside. After that, shoots outside stop,
    // so that the stem remains bare.
    m_hasEntered = m_hasEntered || isInside(tree, index);
    options.admits = [&](const Vec3& from, const Vec3& to) {
        return m_envelopes.containsWithin(to, margin) || (!m_hasEntered && !m_envelopes.contains(from));
    };
    const float occupancy = options.perception.occupancy;
    while (m_steps < kMostSteps) {
        options.perception.occupancy = (m_isInThinParts ? kThinOccupancy : 1.0F) * occupancy;
        ++m_steps;
        if (!m_leader) {
            const std::size_t before = m_markers.size();
            TreeDelta delta = model.growToward(tree, index, m_markers, options, m_workspace);
            if (!delta.isEmpty())
                return delta;
            if (m_markers.size() < before) // markers were removed: other buds may grow now
                continue;
            m_leader = nextLeader(tree, index, options.perception);
            if (!m_leader && !std::exchange(m_isInThinParts, true)) {
                layMarkers(tree);
                continue;
            }
            if (!m_leader)
                break;
        }
        TreeDelta delta = lead(tree, index, options.perception);
        if (!delta.isEmpty())
            return delta;
    }
    m_markers.clear();
    return deltaStartingAt(tree);
}

bool EnvelopeGrowth::isInside(const Tree& tree, const TreeIndex& index) const
{
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id) && tree.buds(id) != 0 && m_envelopes.contains(index.nodePosition(id)))
            return true;
    }
    return false;
}

std::optional<EnvelopeGrowth::Leader> EnvelopeGrowth::nextLeader(const Tree& tree, const TreeIndex& index,
                                                                 const Perception& perception)
{
    if (m_competitors.node != kNoInternode || m_leaders >= kMostLeaders)
        return {};
    std::vector<InternodeId> nodes;
    for (InternodeId id = 0; id < tree.size(); ++id) {
        if (tree.isAlive(id) && tree.buds(id) != 0)
            nodes.push_back(id);
    }
    // The nearest marker that no bud perceives.
    float least = std::numeric_limits<float>::infinity();
    InternodeId from = kNoInternode;
    Vec3 target = Vec3::Zero();
    for (std::size_t i = 0; i < std::min(kAsked, m_markers.size()); ++i) {
        const Vec3& marker = m_markers.positions[i];
        float nearest = std::numeric_limits<float>::infinity();
        InternodeId node = kNoInternode;
        for (const InternodeId id : nodes) {
            const float squared = (index.nodePosition(id) - marker).squaredNorm();
            if (squared < nearest) {
                nearest = squared;
                node = id;
            }
        }
        if (node != kNoInternode && nearest > perception.reach * perception.reach && nearest < least) {
            least = nearest;
            from = node;
            target = marker;
        }
    }
    if (from == kNoInternode)
        return {};
    ++m_leaders;
    const double length = tree.parameters().growth.internodeLength;
    const InternodeId root = index.rootOf(tree, from);
    const bool isSeedling = index.tipCount(root) == 1;
    const InternodeId tip = trunkTip(index, root);
    const BudRef bud = isSeedling && (tree.buds(tip) & kTerminalBud) != 0
                           ? BudRef{tip, kTerminalSlot}
                           : bestBud(tree, index, from, target, m_workspace);
    return Leader{bud, target, 10 + static_cast<int>(std::min(2.0 * std::sqrt(least) / length, 1e5))};
}

TreeDelta EnvelopeGrowth::lead(const Tree& tree, const TreeIndex& index, const Perception& perception)
{
    Leader& leader = *m_leader;
    const int count = std::min(tree.parameters().growth.maxShootLength, leader.remaining);
    // The first leader goes deep into the envelope, so that its branches begin there.
    const float sight = 0.5F * (perception.occupancy + (m_hasEntered ? perception.reach : 0.0F));
    TreeDelta delta = growLeader(tree, index, leader.tip, leader.target, sight, count, m_workspace);
    leader.remaining -= count;
    if (delta.born.count > 0)
        leader.tip = {delta.born.end() - 1, kTerminalSlot};
    if (delta.born.count < static_cast<std::uint32_t>(count) || leader.remaining == 0) {
        // The leader has arrived or cannot arrive; either way, no other leader grows to this marker.
        std::erase(m_markers.positions, leader.target);
        m_markers.born.resize(m_markers.positions.size());
        m_leader.reset();
    }
    return delta;
}

} // namespace espalier
