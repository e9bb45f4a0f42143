// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/ShownStrands.h"

namespace espalier {

std::shared_ptr<const ShownStrands> makeShownStrands(const Tree& tree, bool withFibres,
                                                     const StrandWood* last, WorkProgress& progress)
{
    const TreeIndex index(tree);
    auto layouts = std::make_shared<const StrandLayouts>(
        tree, index, Widths(tree, index), last != nullptr ? last->layouts.get() : nullptr, &progress);
    if (progress.isCancelled())
        return nullptr;
    auto shown = std::make_shared<ShownStrands>();
    shown->hasFibres = withFibres;
    if (withFibres)
        shown->fibres = strandFibres(*layouts, tree, index);
    if (tree.parameters().wood.mesher == WoodMesherKind::Strands) {
        shown->lines = strandLines(*layouts, tree.size());
        shown->wood = meshStrands(std::move(layouts), tree.parameters(), {}, last, progress);
        if (!shown->wood)
            return nullptr;
    }
    return shown;
}

} // namespace espalier
