// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands/RepeatedGrowth.h"

#include <utility>

namespace espalier {

RepeatedGrowth::RepeatedGrowth(const TreeDocument& document, const Competitors& competitors, StrokeEnd end,
                               const StrokePlacement& placement)
    : m_placement(placement),
      m_turns(document.tree(), document.index(), placement,
              static_cast<float>(document.parameters().growth.internodeLength)),
      m_growths(static_cast<std::size_t>(placement.copies), BrushGrowth(competitors, end))
{
    // Otherwise a copy would begin at a bud of the copy before it.
    for (BrushGrowth& growth : m_growths) {
        if (placement.copies > 1)
            growth.beginAtFirst(document.tree().size());
    }
}

void RepeatedGrowth::step(Edit& edit, std::span<const BrushSample> way)
{
    for (const BrushSample& sample : way)
        m_turns.meet(sample.position);
    const TreeDocument& document = edit.document();
    std::vector<BrushSample> turned(way.size());
    for (std::size_t copy = 0; copy < m_growths.size(); ++copy) {
        for (std::size_t i = 0; i < way.size(); ++i)
            turned[i] = placed(way[i], copy);
        edit.apply(m_growths[copy].step(document.tree(), document.index(), document.growthModel(), turned));
    }
    gatherMarkers();
}

bool RepeatedGrowth::settle(Edit& edit, const BrushSample& brush)
{
    const TreeDocument& document = edit.document();
    bool hasGrown = false;
    for (std::size_t copy = 0; copy < m_growths.size(); ++copy) {
        std::optional<TreeDelta> delta = m_growths[copy].settle(document.tree(), document.index(),
                                                                document.growthModel(), placed(brush, copy));
        if (!delta)
            continue;
        edit.apply(std::move(*delta));
        hasGrown = true;
    }
    gatherMarkers();
    return hasGrown;
}

std::span<const Vec3> RepeatedGrowth::markers() const
{
    return m_growths.size() == 1 ? m_growths.front().markers() : std::span<const Vec3>(m_markers);
}

std::vector<Vec3> RepeatedGrowth::placed(const Vec3& point) const
{
    std::vector<Vec3> places;
    for (int copy = 0; copy < m_placement.copies; ++copy)
        places.push_back(m_turns.placed(point, copy));
    return places;
}

BrushSample RepeatedGrowth::placed(BrushSample sample, std::size_t copy) const
{
    sample.position = m_turns.placed(sample.position, static_cast<int>(copy));
    return sample;
}

void RepeatedGrowth::gatherMarkers()
{
    if (m_growths.size() == 1)
        return;
    m_markers.clear();
    for (const BrushGrowth& growth : m_growths)
        m_markers.insert(m_markers.end(), growth.markers().begin(), growth.markers().end());
}

} // namespace espalier
