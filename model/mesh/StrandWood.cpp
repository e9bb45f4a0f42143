// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/StrandWood.h"

#include "model/mesh/WoodMesh.h"

namespace espalier {

StrandWood strandWood(const Tree& tree, const TreeIndex& index, bool withFibres)
{
    StrandWood wood;
    wood.hasFibres = withFibres;
    const Widths widths(tree, index);
    const ShownWood shown(tree, index, widths);
    if (const StrandLayouts* layouts = shown.layouts()) {
        wood.mesh = shown.mesh();
        wood.lines = shown.lines();
        if (withFibres)
            wood.fibres = strandFibres(*layouts);
    } else if (withFibres) {
        wood.fibres = strandFibres(StrandLayouts(tree, index, widths));
    }
    return wood;
}

} // namespace espalier
