// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/TwistGesture.h"
#include "commands/recipe/RecipeText.h"
#include "commands/recipe/TwistOperation.h"

#include <algorithm>

namespace espalier {

QString TwistOperation::perform(TreeDocument& document) const
{
    const Result<InternodeId> id = internode.resolve(document);
    if (!id)
        return id.error().message;
    const Tree& tree = document.tree();
    const auto isTwisted = [&](InternodeId reached) {
        return tree.content().sparse.twist.find(reached) != nullptr;
    };
    if (angle == 0.0 &&
        std::ranges::none_of(twistedInternodes(tree, document.index(), *id, scope), isTwisted))
        return RecipeText::tr("internode %1 has no twist to take away").arg(*id);
    twistBranch(document, *id, scope, angle);
    return {};
}

} // namespace espalier
