// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/PlaceLeaves.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/ArrangeOperation.h"
#include "commands/recipe/PlaceLeafOperation.h"
#include "commands/recipe/RecipeJson.h"
#include "model/sketch/LeafPlacement.h"

#include <QCoreApplication>

namespace espalier {

bool placeLeaf(TreeDocument& document, LeafRow leaf)
{
    // A recipe does not keep the sign of zeros, so the tree must not depend on it.
    leaf.rotation.coeffs() = withoutNegativeZeros<4>(leaf.rotation.coeffs());
    leaf.along = leaf.along == 0.0F ? 0.0F : leaf.along;
    Edit edit(document);
    if (!isLeafPlace(document.tree(), leaf))
        return false;
    const PlaceLeafOperation operation = PlaceLeafOperation::of(document, leaf);
    TreeDelta delta = deltaStartingAt(document.tree());
    addLeaf(delta, leaf);
    edit.apply(std::move(delta));
    commitRecorded(edit, QCoreApplication::translate("Commands", "Place Leaf"), [&] { return operation; });
    return true;
}

bool arrangeLeaves(TreeDocument& document, LeafEngine engine, const BranchPlace& place)
{
    Edit edit(document);
    for (LeafSuggestion& suggestion : suggestLeaves(document.tree(), document.index(), place)) {
        if (suggestion.engine != engine)
            continue;
        const ArrangeOperation operation{.engine = engine,
                                         .internode = InternodeReference::to(document, place.internode),
                                         .along = place.along};
        edit.apply(std::move(suggestion.delta));
        commitRecorded(edit, QCoreApplication::translate("Commands", "Arrange Leaves"),
                       [&] { return operation; });
        return true;
    }
    return false;
}

} // namespace espalier
