// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/ShownStrands.h"

namespace espalier {

namespace {

/// The share of the time that the layouts take, and the fibres with them.
constexpr float kLayoutsShare = 0.3F;
constexpr float kFibresShare = 0.4F;

} // namespace

std::shared_ptr<const StrandLines> linesOf(const std::shared_ptr<const ShownStrands>& strands)
{
    if (!strands || strands->lines.empty())
        return nullptr;
    return {strands, &strands->lines};
}

std::shared_ptr<const ShownStrands> makeShownStrands(const Tree& tree, bool withFibres,
                                                     const StrandWood* last, WorkProgress& progress)
{
    const bool withWood = tree.parameters().wood.mesher == WoodMesherKind::Strands;
    const TreeIndex index(tree);
    std::shared_ptr<const StrandLayouts> layouts;
    {
        const WorkProgress::Part part(progress, withWood ? kLayoutsShare : 1.0F - kFibresShare);
        layouts = std::make_shared<const StrandLayouts>(
            tree, index, Widths(tree, index), last != nullptr ? last->layouts.get() : nullptr, &progress);
    }
    if (progress.isCancelled())
        return nullptr;
    auto shown = std::make_shared<ShownStrands>();
    shown->hasFibres = withFibres;
    if (withFibres) {
        const WorkProgress::Part part(progress, withWood ? kFibresShare : 1.0F);
        shown->fibres = strandFibres(*layouts, tree, index);
    }
    if (withWood) {
        const WorkProgress::Part part(progress, 1.0F);
        shown->lines = strandLines(*layouts, tree.size());
        shown->wood = meshStrands(std::move(layouts), tree.parameters(), {}, last, progress);
        if (!shown->wood)
            return nullptr;
    }
    return shown;
}

} // namespace espalier
