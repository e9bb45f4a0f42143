// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/EraseTwigs.h"

#include "commands/RecordedEdit.h"
#include "model/shape/Pruning.h"

#include <QCoreApplication>

namespace espalier {

namespace {

/// Makes what @p deltaOf(swept, rule) returns one undo step named @p text. Returns whether it is anything.
template <class Operation, class DeltaOf>
bool takeTwigs(TreeDocument& document, const Operation& operation, const QString& text,
               const DeltaOf& deltaOf)
{
    Edit edit(document);
    const Tree& tree = document.tree();
    const TreeIndex& index = document.index();
    const SweptTwigs& twigs = operation.twigs;
    edit.apply(
        deltaOf(sweptBy(tree, index, twigs.sweeps, twigs.depth), TwigRule(tree, index, twigs.thickest)));
    const bool isAny = edit.deltaCount() > 0;
    commitRecorded(edit, text, [&] { return operation; });
    return isAny;
}

} // namespace

bool eraseTwigs(TreeDocument& document, const EraseOperation& operation)
{
    return takeTwigs(document, operation, QCoreApplication::translate("Commands", "Erase"),
                     [&](const Swept& swept, const TwigRule& rule) {
                         return eraseTwigs(document.tree(), document.index(), swept, rule);
                     });
}

bool thinTwigs(TreeDocument& document, const ThinOperation& operation)
{
    return takeTwigs(document, operation, QCoreApplication::translate("Commands", "Thin Out"),
                     [&](const Swept& swept, const TwigRule& rule) {
                         const Tree& tree = document.tree();
                         const TreeIndex& index = document.index();
                         return prune(tree, index, Thinning(tree, index, rule, operation.share).cuts(swept));
                     });
}

} // namespace espalier
