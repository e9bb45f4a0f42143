// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/recipe/BudReference.h"

#include "commands/recipe/RecipeText.h"

namespace espalier {

namespace {

constexpr QLatin1StringView kOnlyKey("only");
constexpr QLatin1StringView kBudInternodeKey("internode");
constexpr QLatin1StringView kBudKey("bud");

/// Whether the bud exists, or has grown into a branch that lives. @p node is alive.
bool hasBud(const TreeDocument& document, InternodeId node, int slot)
{
    const Tree& tree = document.tree();
    if ((tree.buds(node) & budBit(slot)) != 0)
        return true;
    const TreeIndex& index = document.index();
    for (InternodeId child = index.firstChild(node); child != kNoInternode;
         child = index.nextSibling(child)) {
        if (tree.columns().slot[child] == slot)
            return true;
    }
    return false;
}

} // namespace

BudReference BudReference::to(const TreeDocument& document, const Competitors& competitors)
{
    if (competitors.areAll())
        return {};
    const Tree& tree = document.tree();
    const bool isThere = competitors.node < tree.size() && tree.isAlive(competitors.node);
    return {isThere ? InternodeReference::to(document, competitors.node)
                    : InternodeReference(competitors.node),
            competitors.slot};
}

BudReference::Found BudReference::resolve(const TreeDocument& document) const
{
    if (!internode)
        return {};
    // If the internode is missing, the number is one that no tree has, so no bud may grow.
    Found found{{internode->number(), slot}, {}};
    const Result<InternodeId> node = internode->resolve(document);
    if (!node) {
        found.warning = node.error().message;
    } else if (found.competitors.node = *node; !hasBud(document, *node, slot)) {
        found.warning = RecipeText::tr("internode %1 has no bud %2").arg(*node).arg(slot);
    }
    return found;
}

BudReference BudReference::read(JsonReader& parent)
{
    if (!parent.has(kOnlyKey))
        return {};
    JsonReader reader(parent.object(kOnlyKey), parent.placeOf(kOnlyKey));
    BudReference bud;
    bud.internode = InternodeReference::read(reader, kBudInternodeKey);
    bud.slot = static_cast<int>(reader.integer(kBudKey, 0, kTerminalSlot, kTerminalSlot));
    if (bud.slot >= kMaxLaterals && bud.slot != kTerminalSlot)
        reader.fail(kBudKey, RecipeText::tr("there is no such bud"));
    if (const Result<void> end = reader.finish(); !end)
        parent.fail(end.error());
    return bud;
}

void BudReference::write(QJsonObject& json) const
{
    if (internode)
        json[kOnlyKey] = QJsonObject{{kBudInternodeKey, internode->toJson()}, {kBudKey, slot}};
}

} // namespace espalier
