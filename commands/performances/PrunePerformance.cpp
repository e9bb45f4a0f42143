// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/Prune.h"
#include "commands/recipe/PruneOperation.h"
#include "commands/recipe/RecipeText.h"

namespace espalier {

QString PruneOperation::perform(TreeDocument& document) const
{
    std::vector<InternodeId> cuts;
    QStringList faults;
    for (const InternodeReference& internode : internodes) {
        const Result<InternodeId> id = internode.resolve(document);
        if (!id)
            faults.append(id.error().message);
        else if (document.tree().isRoot(*id))
            faults.append(RecipeText::tr("internode %1 is a root, which cannot be pruned").arg(*id));
        else
            cuts.push_back(*id);
    }
    pruneBranches(document, cuts);
    return joinedFaults(faults);
}

} // namespace espalier
