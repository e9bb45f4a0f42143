// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ProfileEdits.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/RecipeJson.h"
#include "commands/recipe/SetProfileOperation.h"
#include "model/shape/BranchBend.h"
#include "model/strands/ProfileMorph.h"

#include <QCoreApplication>

#include <algorithm>

namespace espalier {

namespace {

/// Recipes do not keep the sign of zeros.
StrandProfile forRecipes(StrandProfile profile)
{
    for (StrandProfile::Loop& loop : profile.boundaries) {
        for (Vec2& point : loop)
            point = withoutNegativeZeros<2>(point);
    }
    for (auto& [from, to] : profile.attractors) {
        from = withoutNegativeZeros<2>(from);
        to = withoutNegativeZeros<2>(to);
    }
    return profile;
}

/// Adds the change of a node's profile, if it is one; null takes it away.
void changeProfile(const Tree& tree, TreeDelta& delta, InternodeId id, const StrandProfile* profile)
{
    const std::optional<std::uint32_t> before = tree.content().sparse.profile.at(id);
    std::optional<std::uint32_t> after;
    if (profile != nullptr)
        after = keepProfile(delta, tree, *profile);
    if (before != after)
        delta.sparse.profile.push_back({id, before, after});
}

/// The living ones, each once.
std::vector<InternodeId> living(const Tree& tree, std::span<const InternodeId> internodes)
{
    std::vector<InternodeId> ids(internodes.begin(), internodes.end());
    std::erase_if(ids, [&](InternodeId id) { return !tree.isAlive(id); });
    std::ranges::sort(ids);
    ids.erase(std::ranges::unique(ids).begin(), ids.end());
    return ids;
}

SetProfileOperation operationOn(const TreeDocument& document, std::span<const InternodeId> ids)
{
    SetProfileOperation operation;
    for (const InternodeId id : ids)
        operation.internodes.push_back(InternodeReference::to(document, id));
    return operation;
}

} // namespace

std::vector<InternodeId> branchBetween(const Tree& tree, InternodeId first, InternodeId last)
{
    if (!tree.isAlive(first) || !tree.isAlive(last))
        return {};
    // A parent's id is smaller than its children's.
    std::vector<InternodeId> path = pathBetween(tree, std::min(first, last), std::max(first, last));
    if (first > last)
        std::ranges::reverse(path);
    return path;
}

bool setProfile(TreeDocument& document, std::span<const InternodeId> internodes, const StrandProfile& profile)
{
    Q_ASSERT(profileFault(profile).isEmpty());
    Edit edit(document);
    const StrandProfile kept = forRecipes(profile);
    const std::vector<InternodeId> ids = living(document.tree(), internodes);
    SetProfileOperation operation = operationOn(document, ids);
    operation.profile = kept;
    TreeDelta delta = deltaStartingAt(document.tree());
    for (const InternodeId id : ids)
        changeProfile(document.tree(), delta, id, &kept);
    if (!document.tree().hasRoomForProfiles(delta))
        return false;
    if (!delta.sparse.profile.empty())
        edit.apply(std::move(delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Draw Profile"), [&] { return operation; });
    return true;
}

bool blendProfiles(TreeDocument& document, InternodeId first, InternodeId last, const StrandProfile& profile,
                   const StrandProfile& lastProfile)
{
    Q_ASSERT(profileFault(profile).isEmpty() && profileFault(lastProfile).isEmpty());
    Edit edit(document);
    const Tree& tree = document.tree();
    const std::vector<InternodeId> path = branchBetween(tree, first, last);
    if (path.empty() || path.size() > static_cast<std::size_t>(SetProfileOperation::kMostNodes))
        return true;
    const StrandProfile from = forRecipes(profile);
    const StrandProfile to = forRecipes(lastProfile);
    SetProfileOperation operation = operationOn(document, std::span(&first, 1));
    operation.to = InternodeReference::to(document, last);
    operation.profile = from;
    operation.toProfile = to;
    // Nodes are at the upper ends of their internodes.
    const bool isUpward = path.front() < path.back();
    std::vector<float> along{0.0F};
    for (std::size_t i = 1; i < path.size(); ++i)
        along.push_back(along.back() + tree.length(isUpward ? path[i] : path[i - 1]));
    std::vector<std::pair<InternodeId, StrandProfile>> profiles;
    const ProfileBlend blend(from, to);
    for (std::size_t i = 0; i < path.size(); ++i)
        profiles.emplace_back(path[i],
                              forRecipes(blend.at(path.size() == 1 ? 0.0F : along[i] / along.back())));
    std::ranges::sort(profiles, {}, &std::pair<InternodeId, StrandProfile>::first);
    TreeDelta delta = deltaStartingAt(tree);
    for (const auto& [id, blended] : profiles)
        changeProfile(tree, delta, id, &blended);
    if (!tree.hasRoomForProfiles(delta))
        return false;
    if (!delta.sparse.profile.empty())
        edit.apply(std::move(delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Blend Profiles"),
                   [&] { return operation; });
    return true;
}

void clearProfiles(TreeDocument& document, std::span<const InternodeId> internodes)
{
    Edit edit(document);
    std::vector<InternodeId> ids = living(document.tree(), internodes);
    std::erase_if(ids, [&](InternodeId id) { return document.tree().profileOf(id) == nullptr; });
    const SetProfileOperation operation = operationOn(document, ids);
    TreeDelta delta = deltaStartingAt(document.tree());
    for (const InternodeId id : ids)
        changeProfile(document.tree(), delta, id, nullptr);
    if (!delta.sparse.profile.empty())
        edit.apply(std::move(delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Remove Profile"),
                   [&] { return operation; });
}

} // namespace espalier
