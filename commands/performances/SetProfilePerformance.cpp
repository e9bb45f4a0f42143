// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/ProfileEdits.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/SetProfileOperation.h"

namespace espalier {

namespace {

QString noRoomForProfiles()
{
    return RecipeText::tr("there is no room for more profiles");
}

} // namespace

QString SetProfileOperation::perform(TreeDocument& document) const
{
    std::vector<InternodeId> ids;
    QStringList faults;
    for (const InternodeReference& internode : internodes) {
        const Result<InternodeId> id = internode.resolve(document);
        if (!id)
            faults.append(id.error().message);
        else
            ids.push_back(*id);
    }
    if (to && !ids.empty()) {
        const Result<InternodeId> end = to->resolve(document);
        if (!end)
            return end.error().message;
        const std::vector<InternodeId> path = branchBetween(document.tree(), ids.front(), *end);
        if (path.empty() || path.size() > static_cast<std::size_t>(SetProfileOperation::kMostNodes))
            return RecipeText::tr("there is no branch from internode %1 to internode %2")
                .arg(ids.front())
                .arg(*end);
        if (profile && toProfile) {
            return blendProfiles(document, ids.front(), *end, *profile, *toProfile) ? QString()
                                                                                    : noRoomForProfiles();
        }
        ids = path;
    }
    if (ids.empty())
        return joinedFaults(faults);
    if (profile) {
        if (!setProfile(document, ids, *profile))
            faults.append(noRoomForProfiles());
    } else {
        const bool hasSome = std::ranges::any_of(
            ids, [&](InternodeId id) { return document.tree().profileOf(id) != nullptr; });
        if (!hasSome)
            faults.append(RecipeText::tr("internode %1 has no profile to take away").arg(ids.front()));
        clearProfiles(document, ids);
    }
    return joinedFaults(faults);
}

} // namespace espalier
