// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/sketch/BranchCopy.h"

#include "model/base/Random.h"
#include "model/sketch/SketchText.h"

#include <algorithm>

namespace espalier {

namespace {

/// Scaled lengths and diameters are at least this, m.
constexpr double kLeastScaled = 1e-6;
constexpr int kCrowdedSlot = kBudSlots - 1;

float scaledLength(float length, double scale, float greatest)
{
    return static_cast<float>(std::clamp(scale * double{length}, kLeastScaled, double{greatest}));
}

/// The key of an internode that shares parent, slot and step of birth with others. Never a childKey().
InternodeKey crowdedKey(InternodeKey parent, int slot, Step step, std::uint32_t number)
{
    return mixedBits(childKey(parent, slot, step) ^ mixedBits(0x6a09e667f3bcc909U + number));
}

BudMask slotsWithBud(const BudStates& buds)
{
    return static_cast<BudMask>(buds.living | buds.other);
}

} // namespace

BranchCopies::BranchCopies(const Tree& tree, const TreeIndex& index)
    : m_tree(tree), m_index(index), m_delta(deltaStartingAt(tree))
{
    m_delta.stepAfter = m_delta.stepBefore + 1;
    const LeafColumns& leaves = tree.placedLeaves();
    for (LeafId leaf = 0; leaf < leaves.size(); ++leaf) {
        if (leaves.death[leaf] == kNever)
            m_leaves.emplace_back(leaves.internode[leaf], leaf);
    }
    std::ranges::sort(m_leaves);
}

TreeRows& BranchCopies::rows()
{
    if (!m_delta.rows)
        m_delta.rows = std::make_shared<TreeRows>();
    return *m_delta.rows;
}

std::span<const std::pair<InternodeId, LeafId>> BranchCopies::leavesOf(InternodeId id) const
{
    const auto internodeOf = [](const std::pair<InternodeId, LeafId>& leaf) { return leaf.first; };
    const auto found = std::ranges::equal_range(m_leaves, id, {}, internodeOf);
    return {found.begin(), found.end()};
}

const std::vector<BranchCopies::Part>& BranchCopies::partsOf(InternodeId branch)
{
    std::vector<Part>& parts = m_parts[branch];
    if (!parts.empty())
        return parts;
    parts.push_back({.source = branch, .parent = 0, .repeats = 0});
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
        std::uint32_t inSlot[kBudSlots] = {};
        for (InternodeId child = m_index.firstChild(parts[i].source); child != kNoInternode;
             child = m_index.nextSibling(child)) {
            std::uint32_t& repeats = inSlot[m_tree.columns().slot[child]];
            parts.push_back({.source = child, .parent = i, .repeats = repeats++});
        }
    }
    return parts;
}

BranchCopies::Siblings& BranchCopies::siblingsAt(InternodeId parent)
{
    const auto [entry, isFirst] = m_siblings.try_emplace(parent);
    Siblings& siblings = entry->second;
    if (!isFirst)
        return siblings;
    if (isNew(parent)) {
        const std::uint32_t row = parent - m_tree.size();
        siblings.taken =
            static_cast<BudMask>(slotsWithBud(m_delta.rows->internodes.buds[row]) | m_slots[row]);
    } else {
        siblings.taken = slotsWithBud(m_tree.budStates(parent));
        for (InternodeId child = m_index.firstChild(parent); child != kNoInternode;
             child = m_index.nextSibling(child))
            siblings.taken = static_cast<BudMask>(siblings.taken | budBit(m_tree.columns().slot[child]));
    }
    return siblings;
}

std::uint8_t BranchCopies::takeSlot(Siblings& siblings, InternodeId branch) const
{
    const auto isFree = [&](int slot) {
        return isBudSlot(slot) && slot != kTerminalSlot && (siblings.taken & budBit(slot)) == 0;
    };
    int slot = m_tree.columns().slot[branch];
    if (!isFree(slot)) {
        slot = budKind(slot) == BudKind::Adventitious ? kFirstAdventitiousSlot : 0;
        while (slot < kCrowdedSlot && !isFree(slot))
            ++slot;
    }
    siblings.taken = static_cast<BudMask>(siblings.taken | budBit(slot));
    return static_cast<std::uint8_t>(slot);
}

InternodeId BranchCopies::add(InternodeId branch, const CopyPlace& place)
{
    const std::vector<Part>& parts = partsOf(branch);
    const InternodeId first = m_tree.size() + m_delta.born.count;
    if (parts.size() > kMost - m_delta.born.count) {
        m_isFull = true;
        return place.parent;
    }
    const InternodeColumns& born = rows().internodes;
    Siblings& siblings = siblingsAt(place.parent);
    const std::uint8_t slot = takeSlot(siblings, branch);
    const InternodeKey parentKey =
        isNew(place.parent) ? born.key[place.parent - m_tree.size()] : m_tree.key(place.parent);
    addRow(parts.front(), place, slot, crowdedKey(parentKey, slot, m_delta.stepAfter, ++siblings.copies));
    const InternodeColumns& c = m_tree.columns();
    for (std::size_t i = 1; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const InternodeId source = part.source;
        const InternodeKey below = born.key[first + part.parent - m_tree.size()];
        const std::uint8_t itsSlot = c.slot[source];
        addRow(part,
               {.parent = first + part.parent,
                .along = c.along[source],
                .rotation = c.rotation[source],
                .scale = place.scale},
               itsSlot,
               part.repeats == 0 ? childKey(below, itsSlot, m_delta.stepAfter)
                                 : crowdedKey(below, itsSlot, m_delta.stepAfter, part.repeats));
    }
    return first;
}

void BranchCopies::addRow(const Part& part, const CopyPlace& place, std::uint8_t slot, InternodeKey key)
{
    const InternodeColumns& c = m_tree.columns();
    const InternodeId source = part.source;
    const InternodeId id = m_tree.size() + m_delta.born.count++;
    const float length = scaledLength(c.length[source], place.scale, kGreatestLength);
    Placement below{};
    float lengthBelow = 0.0F;
    if (isNew(place.parent)) {
        const std::uint32_t row = place.parent - m_tree.size();
        below = m_places[row];
        lengthBelow = rows().internodes.length[row];
        m_slots[row] = static_cast<BudMask>(m_slots[row] | budBit(slot));
    } else {
        below = {m_index.nodePosition(place.parent), m_index.rotation(place.parent)};
        lengthBelow = m_tree.length(place.parent);
    }
    below.node -= (1.0F - place.along) * lengthBelow * (below.rotation * Vec3(Vec3::UnitY()));
    m_places.push_back(placeOn(below.node, below.rotation, place.rotation, length));
    m_isFar = m_isFar || !(m_places.back().node.cwiseAbs().maxCoeff() <= kFarthestNode);
    m_slots.push_back(0);
    rows().internodes.append({.parent = place.parent,
                              .along = place.along,
                              .rotation = place.rotation,
                              .length = length,
                              .vigour = c.vigour[source],
                              .slot = slot,
                              .buds = c.buds[source],
                              .birth = m_delta.stepAfter,
                              .death = kNever,
                              .parameterSet = c.parameterSet[source],
                              .key = key});
    copySparse(source, id, place.scale);
    const LeafColumns& leaves = m_tree.placedLeaves();
    for (const auto& [internode, leaf] : leavesOf(source))
        addLeaf(leaf, id, leaves.along[leaf], leaves.rotation[leaf], place.scale);
}

void BranchCopies::copySparse(InternodeId source, InternodeId id, double scale)
{
    const SparseColumns& sparse = m_tree.content().sparse;
    if (const float* const width = sparse.width.find(source))
        m_delta.sparse.width.push_back({id, std::nullopt, scaledLength(*width, scale, kGreatestDiameter)});
    if (const std::optional<std::uint32_t> profile = sparse.profile.at(source))
        m_delta.sparse.profile.push_back({id, std::nullopt, profile});
    if (const std::optional<float> twist = sparse.twist.at(source))
        m_delta.sparse.twist.push_back({id, std::nullopt, twist});
    if (const float* const clear = sparse.clearLength.find(source))
        m_delta.sparse.clearLength.push_back(
            {id, std::nullopt, scaledLength(*clear, scale, kGreatestClearLength)});
    if (const float* const drawn = sparse.drawnLength.find(source))
        m_delta.sparse.drawnLength.push_back(
            {id, std::nullopt, scaledLength(*drawn, scale, kGreatestClearLength)});
}

void BranchCopies::addLeaf(LeafId leaf, InternodeId internode, float along, const Rotation& rotation,
                           double scale)
{
    const LeafColumns& leaves = m_tree.placedLeaves();
    rows().leaves.append({.internode = internode,
                          .along = along,
                          .rotation = rotation,
                          .length = scaledLength(leaves.length[leaf], scale, kGreatestLeaf),
                          .kind = leaves.kind[leaf],
                          .birth = m_delta.stepAfter,
                          .death = kNever});
    ++m_delta.bornLeaves.count;
}

void BranchCopies::remove(InternodeId branch)
{
    if (m_removed.empty())
        m_removed.resize(m_tree.size(), false);
    std::vector<InternodeId> open{branch};
    while (!open.empty()) {
        const InternodeId id = open.back();
        open.pop_back();
        if (m_removed[id])
            continue;
        m_removed[id] = true;
        m_delta.died.push_back(id);
        for (InternodeId child = m_index.firstChild(id); child != kNoInternode;
             child = m_index.nextSibling(child))
            open.push_back(child);
    }
}

void BranchCopies::removeLeaf(LeafId leaf)
{
    m_delta.leaves.death.push_back({leaf, kNever, m_delta.stepAfter});
}

Result<TreeDelta> BranchCopies::finish()
{
    if (m_isFull)
        return tooManyCopies();
    if (m_isFar)
        return Error{
            Error::Kind::Input,
            SketchText::tr("a copy would reach more than %1 m away").arg(static_cast<double>(kFarthestNode))};
    std::ranges::sort(m_delta.died);
    if (!m_delta.bringsRows() && m_delta.died.empty() && m_delta.leaves.death.empty())
        m_delta.stepAfter = m_delta.stepBefore;
    return std::move(m_delta);
}

Error tooManyCopies()
{
    return {Error::Kind::Input,
            SketchText::tr("the copies would have more than %1 internodes").arg(BranchCopies::kMost)};
}

} // namespace espalier
