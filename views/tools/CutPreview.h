// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "views/render/Overlay.h"
#include "views/tools/ToolContext.h"

#include <vector>

namespace espalier {

/// What a cut would take away, shown before it is made.
class CutPreview {
public:
    /// Shows what falls if @p cuts, internodes, are removed with all that they carry.
    void show(ToolContext& context, std::vector<InternodeId> cuts);
    const std::vector<InternodeId>& cuts() const { return m_cuts; }
    /// Takes the cuts, and shows none.
    std::vector<InternodeId> take(ToolContext& context);

    /// @p withRings: around the places of the cuts.
    void paint(ToolContext& context, Overlay& overlay, bool withRings) const;
    /// The line on the screen that cuts.
    static void paintBlade(const Camera& camera, std::span<const QPointF> path, Overlay& overlay);

private:
    std::vector<InternodeId> m_cuts;
    std::vector<InternodeId> m_falling; ///< All internodes that would fall
};

} // namespace espalier
