// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/base/Random.h"
#include "model/tree/TreeIndex.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace espalier::test {

/// Local rotation of an internode that continues its axis: rolled by the phyllotactic angle, then bent by @p
/// bend (rad) toward the parent's azimuth @p azimuth (rad, from +X toward +Z).
inline Rotation continuing(double bend = 0.0, double azimuth = 0.0, double roll = radians(137.5))
{
    const auto about = [](double angle, const Vec3& axis) {
        return Rotation(Eigen::AngleAxisf(static_cast<float>(angle), axis));
    };
    return about(-azimuth, Vec3::UnitY()) * about(-bend, Vec3::UnitZ()) *
           about(roll + azimuth, Vec3::UnitY());
}

/// Local rotation of a lateral from bud @p slot of @p laterals around the node, @p angle (rad) away from the
/// axis.
inline Rotation branching(double angle, int slot = 0, int laterals = 1, double roll = 0.0)
{
    return continuing(angle, 2.0 * std::numbers::pi * slot / laterals, roll);
}

/// Data of a new internode.
struct NewInternode {
    InternodeId parent = 0;
    int slot = kTerminalSlot;
    Rotation rotation = Rotation::Identity();
    float length = 0.1F;
    float vigour = 1.0F;
};

/// A step in which @p internodes are born (ids from tree.size() on, so that one can be the parent of
/// another), and the buds that they grew from disappear. Each gets a terminal bud and the laterals of the
/// parameters in force.
inline TreeDelta births(const Tree& tree, std::span<const NewInternode> internodes)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    if (internodes.empty())
        return delta;
    delta.born = {tree.size(), static_cast<std::uint32_t>(internodes.size())};
    delta.rows = std::make_shared<TreeRows>();
    InternodeColumns& rows = delta.rows->internodes;
    const auto newBuds = BudStates::active(
        static_cast<BudMask>(kTerminalBud | ((1U << tree.parameters().growth.lateralsPerNode) - 1U)));
    for (const NewInternode& internode : internodes) {
        const bool isOnNew = delta.born.contains(internode.parent);
        const InternodeKey parentKey =
            isOnNew ? rows.key[internode.parent - delta.born.first] : tree.key(internode.parent);
        rows.append({.parent = internode.parent,
                     .rotation = internode.rotation,
                     .length = internode.length,
                     .vigour = internode.vigour,
                     .slot = static_cast<std::uint8_t>(internode.slot),
                     .buds = newBuds,
                     .birth = delta.stepAfter,
                     .parameterSet = static_cast<std::uint16_t>(tree.currentParameterSet()),
                     .key = childKey(parentKey, internode.slot, delta.stepAfter)});

        if (isOnNew) {
            rows.buds[internode.parent - delta.born.first].set(internode.slot, BudState::None);
            continue;
        }
        const auto known =
            std::ranges::find(delta.internodes.buds, internode.parent, &CellChange<BudStates>::row);
        const BudStates before = tree.budStates(internode.parent);
        if (known != delta.internodes.buds.end()) {
            known->after.set(internode.slot, BudState::None);
        } else if (before.state(internode.slot) != BudState::None) {
            BudStates after = before;
            after.set(internode.slot, BudState::None);
            delta.internodes.buds.push_back({internode.parent, before, after});
        }
    }
    return delta;
}

/// A step in which another root is born, a seedling with its lower end at @p position, m.
inline TreeDelta rootBirth(const Tree& tree, const TreeIndex& index, const Vec3& position)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    delta.born = {tree.size(), 1};
    delta.rows = std::make_shared<TreeRows>();
    delta.rows->internodes.append(
        {.parent = kNoInternode,
         .length = static_cast<float>(tree.parameters().growth.internodeLength),
         .vigour = 1.0F,
         .slot = kTerminalSlot,
         .buds = BudStates::active(kTerminalBud),
         .birth = delta.stepAfter,
         .parameterSet = static_cast<std::uint16_t>(tree.currentParameterSet()),
         .key = rootKey(tree.seed(), static_cast<std::uint32_t>(index.roots().size()))});
    delta.sparse.rootPosition.push_back({tree.size(), std::nullopt, position});
    return delta;
}

/// A step in which the branch that begins with @p root dies. Precondition: it is alive and not the seedling.
inline TreeDelta death(const Tree& tree, const TreeIndex& index, InternodeId root)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    std::vector<InternodeId> open{root};
    while (!open.empty()) {
        const InternodeId id = open.back();
        open.pop_back();
        delta.died.push_back(id);
        for (InternodeId child = index.firstChild(id); child != kNoInternode;
             child = index.nextSibling(child))
            open.push_back(child);
    }
    return delta;
}

/// One step that puts @p parameters in force.
inline TreeDelta parameterChange(const Tree& tree, const TreeParameters& parameters)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.stepAfter = delta.stepBefore + 1;
    delta.parametersAfter = keepParameters(delta, tree, parameters);
    return delta;
}

/// An edit that turns an internode in its parent's frame and stretches it.
inline TreeDelta bend(const Tree& tree, InternodeId id, const Rotation& turn, float stretch)
{
    const Rotation before = tree.columns().rotation[id];
    TreeDelta delta = deltaStartingAt(tree);
    delta.addFrame(id, before, (turn * before).normalized(), tree.length(id), stretch * tree.length(id));
    return delta;
}

/// An edit that sets a width, m, or takes it away (0).
inline TreeDelta widthChange(const Tree& tree, InternodeId id, float diameter)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.sparse.width.push_back({id, tree.content().sparse.width.at(id),
                                  diameter > 0.0F ? std::optional<float>(diameter) : std::nullopt});
    return delta;
}

/// An edit that brings a stroke into force.
inline TreeDelta newLasso(const Tree& tree, const LassoStroke& stroke)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.lassos.push_back({keepLasso(delta, tree, stroke), true});
    return delta;
}

inline TreeDelta lassoChange(const Tree& tree, std::uint32_t index, bool inForce)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.lassos.push_back({index, inForce});
    return delta;
}

/// An edit that places leaves, one on each of @p internodes.
inline TreeDelta leafPlacement(const Tree& tree, std::span<const InternodeId> internodes)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.bornLeaves.count = static_cast<std::uint32_t>(internodes.size());
    delta.rows = std::make_shared<TreeRows>();
    for (const InternodeId id : internodes) {
        delta.rows->leaves.append({.internode = id,
                                   .along = 0.25F,
                                   .length = 0.08F,
                                   .kind = LeafKind::Flower,
                                   .birth = tree.step()});
    }
    return delta;
}

/// An edit that removes a placed leaf.
inline TreeDelta leafRemoval(const Tree& tree, LeafId id)
{
    TreeDelta delta = deltaStartingAt(tree);
    delta.leaves.death.push_back({id, tree.placedLeaves().death[id], tree.step()});
    return delta;
}

/// An edit that moves a placed leaf to another internode and makes it another kind.
inline TreeDelta leafChange(const Tree& tree, LeafId id, InternodeId internode, LeafKind kind)
{
    TreeDelta delta = deltaStartingAt(tree);
    const LeafColumns& leaves = tree.placedLeaves();
    delta.leaves.internode.push_back({id, leaves.internode[id], internode});
    delta.leaves.kind.push_back({id, leaves.kind[id], kind});
    return delta;
}

/// One step of about @p count internodes on shoots of one to five, from random living buds; young internodes
/// and terminal buds are preferred, so that axes become long. A pure function of the tree and @p seed.
inline TreeDelta randomGrowth(const Tree& tree, std::uint32_t count, std::uint64_t seed = 1)
{
    Random random(seed, tree.step(), tree.size(), Purpose::ShootLength);
    const GrowthParameters& growth = tree.parameters().growth;
    std::vector<NewInternode> internodes;
    std::vector<std::pair<InternodeId, int>> used;
    for (std::uint32_t attempts = 0; internodes.size() < count && attempts < 50 * count; ++attempts) {
        const double age = std::pow(random.uniform(), 3.0);
        const auto id = static_cast<InternodeId>((1.0 - age) * (tree.size() - 1) + 0.5);
        const int slot =
            random.uniform() < 0.65 ? kTerminalSlot : static_cast<int>(random.bits() % kMaxLaterals);
        if (!tree.isAlive(id) || (tree.buds(id) & budBit(slot)) == 0 ||
            std::ranges::count(used, std::pair{id, slot}) != 0)
            continue;
        used.emplace_back(id, slot);
        const auto shoot = 1 + static_cast<std::uint32_t>(random.bits() % 5);
        const auto vigour = static_cast<float>(random.uniform());
        InternodeId parent = id;
        for (std::uint32_t i = 0; i < shoot && internodes.size() < count; ++i) {
            const bool lateral = i == 0 && slot != kTerminalSlot;
            const double bend = lateral ? random.uniform(0.4, 1.4) : random.uniform(0.0, 0.35);
            internodes.push_back({
                .parent = parent,
                .slot = lateral ? slot : kTerminalSlot,
                .rotation = lateral ? branching(bend, slot, growth.lateralsPerNode)
                                    : continuing(bend, random.uniform(0.0, 2.0 * std::numbers::pi)),
                .length = static_cast<float>(growth.internodeLength * random.uniform(0.6, 1.4)),
                .vigour = vigour,
            });
            parent = tree.size() + static_cast<InternodeId>(internodes.size()) - 1;
        }
    }
    return births(tree, internodes);
}

/// A tree with its index and the deltas that made it.
struct TreeBuilder {
    Tree tree;
    TreeIndex index;
    std::vector<TreeDelta> journal;

    explicit TreeBuilder(std::uint64_t seed = 1, const TreeParameters& parameters = {})
        : tree(seed, parameters), index(tree)
    {
    }

    const TreeDelta& apply(TreeDelta delta)
    {
        journal.push_back(std::move(delta));
        tree.apply(journal.back());
        index.update(tree, journal.back());
        return journal.back();
    }

    /// Reverts the last step and returns it.
    TreeDelta revert()
    {
        TreeDelta delta = std::move(journal.back());
        journal.pop_back();
        tree.revert(delta);
        index.update(tree, delta);
        return delta;
    }

    /// Adds one internode in a separate step.
    InternodeId grow(const NewInternode& internode)
    {
        apply(births(tree, std::span(&internode, 1)));
        return tree.size() - 1;
    }

    /// Adds an axis of @p count internodes to @p parent, the first from @p slot with the rotation @p first;
    /// returns the last.
    InternodeId growAxis(InternodeId parent, int slot, const Rotation& first, std::uint32_t count,
                         const Rotation& next = continuing(), float length = 0.1F)
    {
        std::vector<NewInternode> internodes;
        for (std::uint32_t i = 0; i < count; ++i) {
            internodes.push_back({.parent = i == 0 ? parent : tree.size() + i - 1,
                                  .slot = i == 0 ? slot : kTerminalSlot,
                                  .rotation = i == 0 ? first : next,
                                  .length = length});
        }
        apply(births(tree, internodes));
        return tree.size() - 1;
    }

    /// Random growth until there are @p count internodes, about a fortieth of them a step.
    void growTo(std::uint32_t count, std::uint64_t seed = 1)
    {
        while (tree.size() < count)
            apply(randomGrowth(tree, std::min(count - tree.size(), 4 + tree.size() / 40), seed));
    }
};

/// A tree of @p count internodes, the same for the same arguments.
inline TreeBuilder randomTree(std::uint32_t count, std::uint64_t seed = 1,
                              const TreeParameters& parameters = {})
{
    TreeBuilder builder(seed, parameters);
    builder.growTo(count, seed);
    return builder;
}

/// The same tree at such a height that no part comes near the ground, which limits bark and leaves.
inline TreeBuilder raisedTree(std::uint32_t count, std::uint64_t seed = 1,
                              const TreeParameters& parameters = {})
{
    TreeBuilder builder = randomTree(count, seed, parameters);
    TreeDelta delta = deltaStartingAt(builder.tree);
    delta.sparse.rootPosition.push_back({0, std::nullopt, Vec3(0.0F, 8.0F, 0.0F)});
    builder.apply(std::move(delta));
    return builder;
}

} // namespace espalier::test
