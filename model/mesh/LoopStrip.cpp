// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/mesh/LoopStrip.h"

#include <algorithm>

namespace espalier {

namespace {
constexpr std::uint32_t kNowhere = std::numeric_limits<std::uint32_t>::max();
}

void LoopStrip::findAnchors(const VertexLoop& lower, const VertexLoop& upper)
{
    m_anchors.clear();
    if (lower.strands.empty() || upper.strands.empty())
        return;
    if (std::ranges::equal(lower.strands, upper.strands)) {
        for (std::uint32_t i = 0; i < lower.count; ++i)
            m_anchors.push_back({i, i});
        return;
    }
    const auto [least, most] = std::ranges::minmax(upper.strands);
    m_placeOf.assign(most - least + 1, kNowhere);
    for (std::uint32_t i = 0; i < upper.count; ++i) {
        std::uint32_t& place = m_placeOf[upper.strands[i] - least];
        // A strand that the line visits twice is no anchor.
        place = place == kNowhere ? i : kNowhere - 1;
    }
    m_common.clear();
    std::uint32_t origin = kNowhere;
    for (std::uint32_t i = 0; i < lower.count; ++i) {
        const std::uint32_t strand = lower.strands[i];
        if (strand < least || strand > most || m_placeOf[strand - least] >= kNowhere - 1)
            continue;
        const std::uint32_t place = m_placeOf[strand - least];
        if (origin == kNowhere)
            origin = place;
        m_common.push_back({i, (place + upper.count - origin) % upper.count});
    }
    // The longest part of them that ascends on the upper line too, from the first one on.
    m_tails.clear();
    m_links.assign(m_common.size(), kNowhere);
    for (std::uint32_t i = 0; i < m_common.size(); ++i) {
        const auto place = std::ranges::lower_bound(m_tails, m_common[i].up, {},
                                                    [&](std::uint32_t tail) { return m_common[tail].up; });
        if (place != m_tails.begin())
            m_links[i] = *(place - 1);
        if (place == m_tails.end())
            m_tails.push_back(i);
        else
            *place = i;
    }
    for (std::uint32_t i = m_tails.empty() ? kNowhere : m_tails.back(); i != kNowhere; i = m_links[i])
        m_anchors.push_back({m_common[i].low, (m_common[i].up + origin) % upper.count});
    std::ranges::reverse(m_anchors);
}

} // namespace espalier
