// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/AddBuds.h"

#include "commands/RecordedEdit.h"
#include "commands/recipe/AddBudsOperation.h"
#include "model/shape/Widths.h"

#include <QCoreApplication>

namespace espalier {

std::vector<BarkBud> budsOf(const TreeDocument& document, const BudSpiral& spiral,
                            const std::function<float(InternodeId)>& radius)
{
    const VoxelSpace& space = document.growthModel().space();
    const GrowthParameters& growth = document.parameters().growth;
    return placeBuds(document.tree(), document.index(), spiral,
                     {.radius = radius,
                      .lightAt = [&](const Vec3& place) { return space.lightAt(place); },
                      .reach = static_cast<float>((growth.occupancyRadius + growth.perceptionDepth) *
                                                  growth.internodeLength)});
}

int addBuds(TreeDocument& document, const BudSpiral& spiral)
{
    Edit edit(document);
    const TreeIndex& index = document.index();
    const Widths widths(document.tree(), index);
    const std::vector<BarkBud> buds =
        budsOf(document, spiral, [&](InternodeId id) { return widths.radius(index, id); });
    if (buds.empty())
        return 0;
    const AddBudsOperation operation = AddBudsOperation::of(document, spiral);
    edit.apply(addBuds(document.tree(), document.index(), buds));
    commitRecorded(edit, QCoreApplication::translate("Commands", "New Buds"), [&] { return operation; });
    return static_cast<int>(buds.size());
}

} // namespace espalier
