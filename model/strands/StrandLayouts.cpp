// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/StrandLayouts.h"

#include "model/base/ContentHash.h"
#include "model/base/Parallel.h"
#include "model/strands/BundleMerge.h"
#include "model/strands/DiscGrid.h"
#include "model/strands/NodeProfiles.h"
#include "model/strands/ProfileSlots.h"
#include "model/strands/SlotAssignment.h"
#include "model/strands/StrandDynamics.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace espalier {

namespace {

constexpr std::size_t kNodesPerTask = 32;
/// Steps of packing after which 1/e of the way to the packed arrangement is left.
constexpr double kStepsToRest = 60.0;
/// Of the way to the packed arrangement: what is nearer than this counts as there.
constexpr double kAtRest = 0.999;
/// The direction of a branch is measured over this many radii of the branch below it, and at most so many
/// nodes.
constexpr float kDirectionRadii = 1.5F;
constexpr int kDirectionNodes = 16;

} // namespace

/// Makes the layouts, tips first.
class StrandLayouts::Builder {
public:
    Builder(const Tree& tree, const StrandLayouts* last, WorkProgress* progress, StrandLayouts& layouts)
        : m_wood(tree.parameters().wood),
          m_last(last),
          m_progress(progress),
          m_layouts(layouts),
          m_skeleton(layouts.m_skeleton),
          m_profiles(tree, m_skeleton, m_wood.packing == StrandPacking::Rest)
    {
        const double share = 1.0 - std::exp(-m_wood.steps / kStepsToRest);
        m_share = share > kAtRest ? 1.0F : static_cast<float>(share);
    }

    void build()
    {
        chooseOwners();
        reserve();
        if (m_last != nullptr)
            m_before = matchingNodes(m_skeleton, m_last->m_skeleton);
        WorkProgress untold;
        WorkProgress& progress = m_progress != nullptr ? *m_progress : untold;
        WorkCount strands(progress, m_layouts.m_places.size());
        for (const std::vector<std::uint32_t>& round : rounds()) {
            parallelFor(round.size(), kNodesPerTask, [&](std::size_t begin, std::size_t end) {
                Scratch& scratch = m_scratch.local();
                for (std::size_t i = begin; i < end; ++i) {
                    if (progress.isCancelled())
                        return;
                    arrange(round[i], scratch);
                    strands.add(m_skeleton.nodes[round[i]].strands);
                }
            });
        }
        // The others, bases last to first, after the nodes that they share with.
        for (std::size_t i = m_skeleton.nodes.size(); i-- > 0;) {
            if (m_owner[i] != i)
                share(static_cast<std::uint32_t>(i));
        }
    }

private:
    struct Scratch {
        std::optional<BundleMerge> merge;
        std::vector<Vec2> places;
        std::vector<Vec2> target;
        std::vector<std::uint32_t> chosen;
        std::vector<std::uint32_t> order;
    };

    bool isDynamic() const { return m_wood.packing == StrandPacking::Pbd; }
    /// Whether nodes with one child have layouts of their own, since packing goes on there.
    bool goesOn() const { return isDynamic() || m_share < 1.0F; }

    void chooseOwners()
    {
        const std::size_t count = m_skeleton.nodes.size();
        m_owner.resize(count);
        m_round.assign(count, 0);
        std::vector<bool> isSingle(count, false); // One strand above: nothing to pack
        for (std::size_t i = count; i-- > 0;) {
            const auto node = static_cast<std::uint32_t>(i);
            m_owner[i] = node;
            for (const std::uint32_t child : m_skeleton.childrenOf(node))
                m_round[i] = std::max(m_round[i], m_round[m_owner[child]] + 1);
            const StrandNode& n = m_skeleton.nodes[i];
            if (n.childCount == 1 && !m_profiles.has(node) && (!goesOn() || n.strands == 1)) {
                const std::uint32_t child = m_skeleton.children[n.firstChild];
                // A profile draws the nodes that have it.
                if (!m_profiles.has(child) && m_layouts.m_sections[m_owner[child]].profileScale == 0.0F)
                    m_owner[i] = m_owner[child];
            }
            if (m_profiles.has(node))
                m_layouts.m_sections[i].profileScale = 1.0F; // The scale itself comes with the layout
            m_layouts.m_sections[i].roundness = m_profiles.roundness(node);
        }
    }

    void reserve()
    {
        std::size_t places = 0;
        std::size_t slots = 0;
        std::uint32_t most = 1;
        for (std::uint32_t i = 0; i < m_skeleton.nodes.size(); ++i) {
            Section& section = m_layouts.m_sections[i];
            section.owner = m_owner[i];
            if (m_owner[i] != i)
                continue;
            const StrandNode& node = m_skeleton.nodes[i];
            section.first = places;
            places += node.strands;
            // Slots belong to forks and tips; nodes with one child use the child's.
            section.ownsSlots = node.childCount != 1;
            if (section.ownsSlots) {
                section.firstSlot = slots;
                slots += node.strands;
            }
            most = std::max(most, node.strands);
        }
        m_layouts.m_places.resize(places);
        m_layouts.m_slots.resize(slots);
        // A larger lattice begins with the slots of a smaller one.
        if (m_last != nullptr && m_last->lattice().size() >= most && m_last->lattice().size() < 4 * most)
            m_layouts.m_lattice = m_last->m_lattice;
        else
            m_layouts.m_lattice = std::make_shared<const HexLattice>(most);
    }

    /// Nodes that can be arranged at the same time, in the order of the rounds.
    std::vector<std::vector<std::uint32_t>> rounds() const
    {
        std::vector<std::vector<std::uint32_t>> result;
        for (std::uint32_t i = 0; i < m_owner.size(); ++i) {
            if (m_owner[i] != i)
                continue;
            if (m_round[i] >= result.size())
                result.resize(m_round[i] + 1);
            result[m_round[i]].push_back(i);
        }
        return result;
    }

    std::span<Vec2> placesOf(std::uint32_t node)
    {
        return std::span(m_layouts.m_places)
            .subspan(m_layouts.m_sections[node].first, m_skeleton.nodes[node].strands);
    }

    /// Completes the section of a node that shares the layout of its child.
    void share(std::uint32_t node)
    {
        const std::uint32_t child = m_skeleton.children[m_skeleton.nodes[node].firstChild];
        Section& section = m_layouts.m_sections[node];
        const Section& above = m_layouts.m_sections[child];
        section.first = above.first;
        section.firstSlot = above.firstSlot;
        section.isDisc = above.isDisc;
    }

    /// The section of the owner: those of nodes between owners are completed late.
    const Section& sectionOf(std::uint32_t node) const { return m_layouts.m_sections[m_owner[node]]; }
    std::span<const Vec2> ownedPlaces(std::uint32_t node) const
    {
        return std::span<const Vec2>(m_layouts.m_places)
            .subspan(sectionOf(node).first, m_skeleton.nodes[node].strands);
    }

    /// The unit vector in the section of @p node from which the branch of @p child comes.
    Vec2 sideOf(std::uint32_t node, std::uint32_t child) const
    {
        const StrandNode& n = m_skeleton.nodes[node];
        std::uint32_t end = child;
        for (int i = 0; i < kDirectionNodes; ++i) {
            const StrandNode& e = m_skeleton.nodes[end];
            if (e.childCount == 0 || (e.position - n.position).norm() > kDirectionRadii * n.radius)
                break;
            const auto above = m_skeleton.childrenOf(end);
            end = *std::ranges::max_element(above, {},
                                            [&](std::uint32_t c) { return m_skeleton.nodes[c].strands; });
        }
        const Vec3 local = n.frame.conjugate() * (m_skeleton.nodes[end].position - n.position);
        const Vec2 side(local.x(), local.z());
        const float length = side.norm();
        return length > 1e-3F * local.norm() && length > 0.0F ? Vec2(side / length) : Vec2(1.0F, 0.0F);
    }

    void arrange(std::uint32_t node, Scratch& scratch)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        Section& section = m_layouts.m_sections[node];
        Keys& keys = m_layouts.m_keys[node];
        ContentHash above = keyAbove(node, scratch);
        if (n.childCount == 1) {
            const std::uint32_t child = m_skeleton.children[n.firstChild];
            keys.slots = m_layouts.m_keys[m_owner[child]].slots;
            continueBundle(node);
        } else {
            keys.slots = above.value();
            if (const StrandLayouts* last = lastWith(node, &Keys::slots))
                std::ranges::copy(last->slots(m_before[node]),
                                  m_layouts.m_slots.begin() + static_cast<std::ptrdiff_t>(section.firstSlot));
            else if (n.childCount == 0)
                beginTip(node);
            else
                mergeBundles(node, scratch);
        }
        section.isDisc = !m_profiles.has(node) && !goesOn();
        keys.places = placesKey(above, node);
        if (const StrandLayouts* last = lastWith(node, &Keys::places)) {
            std::ranges::copy(last->places(m_before[node]), placesOf(node).begin());
            section.profileScale = last->m_sections[m_before[node]].profileScale;
        } else {
            place(node, scratch);
        }
    }

    /// The last layouts, if they had the same key at the node.
    const StrandLayouts* lastWith(std::uint32_t node, std::uint64_t Keys::*key) const
    {
        if (m_last == nullptr || m_before[node] == kNoNode)
            return nullptr;
        return m_last->m_keys[m_before[node]].*key == m_layouts.m_keys[node].*key ? m_last : nullptr;
    }

    /// All that a node gets from those above it. Sorts the children: scratch.order.
    ContentHash keyAbove(std::uint32_t node, Scratch& scratch) const
    {
        sortChildren(node, scratch);
        ContentHash hash;
        hash.add(m_skeleton.nodes[node].strands);
        for (const std::uint32_t child : scratch.order) {
            const Keys& keys = m_layouts.m_keys[m_owner[child]];
            hash.add(m_skeleton.nodes[child].strands);
            hash.add(m_skeleton.nodes[child].offset);
            // The thickest branch hands down its slots; the places of the others count.
            const bool isMain = child == scratch.order.front();
            hash.add(keys.slots);
            if (!isMain || goesOn())
                hash.add(keys.places);
            if (!isMain) {
                const Vec2 side = sideOf(node, child);
                hash.add(side.x());
                hash.add(side.y());
            }
        }
        return hash;
    }

    std::uint64_t placesKey(ContentHash hash, std::uint32_t node) const
    {
        hash.add(m_wood.packing);
        hash.add(m_wood.steps);
        m_profiles.addTo(hash, node);
        return hash.value();
    }

    void place(std::uint32_t node, Scratch& scratch)
    {
        const StrandNode& n = m_skeleton.nodes[node];
        Section& section = m_layouts.m_sections[node];
        const std::span<Vec2> places = placesOf(node);
        if (n.childCount == 0)
            placeTip(places);
        else if (goesOn())
            carry(node, places, scratch);
        if (isDynamic() && n.childCount > 0)
            packDynamically(node, places);
        else if (m_profiles.has(node))
            fillProfile(section, m_profiles.at(node), places, scratch);
        else
            approachSlots(section, places);
    }

    void beginTip(std::uint32_t node)
    {
        const std::uint32_t count = m_skeleton.nodes[node].strands;
        Section& section = m_layouts.m_sections[node];
        std::iota(m_layouts.m_slots.begin() + static_cast<std::ptrdiff_t>(section.firstSlot),
                  m_layouts.m_slots.begin() + static_cast<std::ptrdiff_t>(section.firstSlot + count), 0U);
    }

    void placeTip(std::span<Vec2> places) const
    {
        const auto count = static_cast<std::uint32_t>(places.size());
        for (std::uint32_t i = 0; i < count; ++i)
            places[i] = m_layouts.m_lattice->position(i) - m_layouts.m_lattice->centroid(count);
    }

    void continueBundle(std::uint32_t node)
    {
        const std::uint32_t child = m_skeleton.children[m_skeleton.nodes[node].firstChild];
        m_layouts.m_sections[node].firstSlot = sectionOf(child).firstSlot;
    }

    /// Sorts the children of a node: those with the most strands first.
    void sortChildren(std::uint32_t node, Scratch& scratch) const
    {
        const auto children = m_skeleton.childrenOf(node);
        scratch.order.assign(children.begin(), children.end());
        std::ranges::stable_sort(scratch.order, std::greater(),
                                 [&](std::uint32_t child) { return m_skeleton.nodes[child].strands; });
    }

    /// Precondition: scratch.order has the children.
    void mergeBundles(std::uint32_t node, Scratch& scratch)
    {
        if (!scratch.merge)
            scratch.merge.emplace(*m_layouts.m_lattice);
        const std::uint32_t main = scratch.order.front();
        scratch.merge->begin(
            std::span(m_layouts.m_slots).subspan(sectionOf(main).firstSlot, m_skeleton.nodes[main].strands),
            m_skeleton.nodes[main].offset);
        for (const std::uint32_t child : std::span(scratch.order).subspan(1))
            scratch.merge->add(ownedPlaces(child), m_skeleton.nodes[child].offset, sideOf(node, child));
        scratch.merge->finish(
            std::span(m_layouts.m_slots).subspan(sectionOf(node).firstSlot, m_skeleton.nodes[node].strands));
    }

    /// Projects the strands of the children into the section: the thickest stays, the others are displaced
    /// until none overlap (Strands 2024, equations 1 and 2). Precondition: scratch.order has the children.
    void carry(std::uint32_t node, std::span<Vec2> places, Scratch& scratch)
    {
        scratch.target.clear(); // What is placed already
        for (const std::uint32_t child : scratch.order) {
            const std::span<Vec2> own =
                places.subspan(m_skeleton.nodes[child].offset, m_skeleton.nodes[child].strands);
            std::ranges::copy(ownedPlaces(child), own.begin());
            if (!scratch.target.empty()) {
                const Vec2 side = sideOf(node, child);
                const float distance = mergeDistance(scratch.target, own, side);
                for (Vec2& place : own)
                    place += distance * side;
            }
            scratch.target.insert(scratch.target.end(), own.begin(), own.end());
        }
    }

    Vec2 slotPlace(const Section& section, std::uint32_t strand, std::uint32_t count) const
    {
        const HexLattice& lattice = *m_layouts.m_lattice;
        return lattice.position(m_layouts.m_slots[section.firstSlot + strand]) - lattice.centroid(count);
    }

    void approachSlots(const Section& section, std::span<Vec2> places) const
    {
        const auto count = static_cast<std::uint32_t>(places.size());
        for (std::uint32_t i = 0; i < count; ++i) {
            const Vec2 slot = slotPlace(section, i, count);
            places[i] = m_share < 1.0F ? Vec2(places[i] + m_share * (slot - places[i])) : slot;
        }
    }

    void fillProfile(Section& section, const StrandProfile& profile, std::span<Vec2> places,
                     Scratch& scratch) const
    {
        const auto count = static_cast<std::uint32_t>(places.size());
        const ProfileSlots slots = profileSlots(profile, count);
        section.profileScale = slots.scale;
        scratch.places.clear();
        for (std::uint32_t i = 0; i < count; ++i)
            scratch.places.push_back(slotPlace(section, i, count));
        scratch.chosen.resize(count);
        assignSlots(scratch.places, slots.places, scratch.chosen);
        for (std::uint32_t i = 0; i < count; ++i)
            places[i] = slots.places[scratch.chosen[i]];
    }

    void packDynamically(std::uint32_t node, std::span<Vec2> places)
    {
        Section& section = m_layouts.m_sections[node];
        std::optional<StrandProfile> profile;
        if (m_profiles.has(node)) {
            profile = m_profiles.at(node);
            section.profileScale = profileSlots(*profile, m_skeleton.nodes[node].strands).scale;
        }
        packByDynamics(places, m_wood.steps, profile ? &*profile : nullptr, section.profileScale);
    }

    const WoodParameters& m_wood;
    const StrandLayouts* m_last;
    WorkProgress* m_progress;
    std::vector<std::uint32_t> m_before; ///< By node: its number in the last layouts
    StrandLayouts& m_layouts;
    StrandSkeleton& m_skeleton;
    NodeProfiles m_profiles;
    std::vector<std::uint32_t> m_owner;
    std::vector<std::uint32_t> m_round;
    float m_share; ///< Of the way to the packed arrangement that a node goes
    tbb::enumerable_thread_specific<Scratch> m_scratch;
};

StrandLayouts::StrandLayouts(const Tree& tree, const TreeIndex& index, const Widths& widths,
                             const StrandLayouts* last, WorkProgress* progress)
    : m_skeleton(strandSkeleton(tree, index, widths))
{
    const std::size_t count = m_skeleton.nodes.size();
    m_sections.resize(count);
    m_keys.resize(count);
    Builder(tree, last, progress, *this).build();

    m_bundles = placeBundles(m_skeleton, tree.parameters(), [this](std::uint32_t child) {
        const StrandNode& node = m_skeleton.nodes[child];
        const Section& below = m_sections[node.parent];
        Vec2 sum = Vec2::Zero();
        for (std::uint32_t strand = 0; strand < node.strands; ++strand)
            sum += m_places[below.first + node.offset + strand];
        return Vec2(sum / static_cast<float>(node.strands));
    });
    m_reliefs = StrandReliefs(ReliefSources{
        .tree = tree,
        .index = index,
        .skeleton = m_skeleton,
        .scales = m_bundles.scales,
        .place = [this](std::uint32_t node, std::uint32_t strand) { return place(node, strand); },
        .roundness = [this](std::uint32_t node) { return m_sections[node].roundness; }});
}

StrandLayouts::Counts StrandLayouts::count() const
{
    Counts counts;
    DiscGrid grid;
    for (std::uint32_t i = 0; i < m_skeleton.nodes.size(); ++i) {
        const StrandNode& node = m_skeleton.nodes[i];
        if (m_skeleton.isBase(i)) {
            counts.strands += node.strands;
            continue;
        }
        counts.particles += node.strands;
        if (owner(i) != i)
            continue;
        const std::span<const Vec2> places = this->places(i);
        grid.sort(places);
        // Rounding leaves neighbours of a lattice a little nearer than 2.
        grid.forEachPair(places, 2.0F - 1e-4F, [&](std::uint32_t a, std::uint32_t b) {
            ++counts.contacts;
            counts.deepest = std::max(counts.deepest, 1.0 - double{(places[a] - places[b]).norm()} / 2.0);
        });
    }
    return counts;
}

std::size_t StrandLayouts::bytes() const
{
    return m_skeleton.nodes.capacity() * sizeof(StrandNode) +
           m_skeleton.children.capacity() * sizeof(std::uint32_t) + m_sections.capacity() * sizeof(Section) +
           m_places.capacity() * sizeof(Vec2) + m_keys.capacity() * sizeof(Keys) +
           m_slots.capacity() * sizeof(std::uint32_t) + m_bundles.bytes() + m_reliefs.bytes();
}

} // namespace espalier
