// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/strands/NodeSection.h"

#include "model/strands/Delaunay.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace espalier {

namespace {

/// An edge of a triangle, from one strand to another, with its place in the list of triangles.
struct DirectedEdge {
    std::uint64_t key;
    std::uint32_t triangle;
    std::uint32_t corner;
};

std::uint64_t keyOf(std::uint32_t from, std::uint32_t to)
{
    return (std::uint64_t{from} << 32U) | to;
}

} // namespace

std::vector<std::size_t> matchCavities(std::span<const std::span<const std::uint32_t>> lower,
                                       std::span<const std::span<const std::uint32_t>> upper)
{
    std::vector<std::size_t> matches(lower.size(), kNoCavity);
    std::vector<bool> isMatched(upper.size(), false);
    for (std::size_t i = 0; i < lower.size(); ++i) {
        for (std::size_t j = 0; j < upper.size() && matches[i] == kNoCavity; ++j) {
            if (!isMatched[j] && std::ranges::find_first_of(lower[i], upper[j]) != lower[i].end())
                matches[i] = j;
        }
        if (matches[i] != kNoCavity)
            isMatched[matches[i]] = true;
    }
    return matches;
}

void NodeSection::set(const StrandLayouts& layouts, std::uint32_t node, float alpha)
{
    m_layouts = &layouts;
    m_node = node;
    m_isLattice = layouts.isDisc(node);
    m_parts.clear();
    m_partCount = 1;
    m_triangles.clear();
    const std::uint32_t count = layouts.strandCount(node);
    if (m_isLattice) {
        m_strandAt.resize(count);
        const std::span<const std::uint32_t> slots = layouts.slots(node);
        for (std::uint32_t strand = 0; strand < count; ++strand)
            m_strandAt[slots[strand]] = strand;
        return;
    }
    const std::span<const Vec2> places = layouts.places(node);
    m_triangles = delaunay(places);
    std::erase_if(m_triangles, [&](const std::array<std::uint32_t, 3>& corners) {
        for (std::size_t k = 0; k < 3; ++k) {
            if ((places[corners[k]] - places[corners[(k + 1) % 3]]).squaredNorm() > alpha * alpha)
                return true;
        }
        return false;
    });
    findParts();
}

void NodeSection::findParts()
{
    // Triangles that share an edge are connected; those that touch in one strand are not.
    std::vector<DirectedEdge> edges;
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        const auto& corners = m_triangles[t];
        for (std::uint32_t k = 0; k < 3; ++k) {
            const std::uint32_t from = corners[k];
            const std::uint32_t to = corners[(k + 1) % 3];
            edges.push_back({keyOf(std::min(from, to), std::max(from, to)), t, k});
        }
    }
    std::ranges::sort(edges, [](const DirectedEdge& a, const DirectedEdge& b) {
        return a.key != b.key ? a.key < b.key : a.triangle < b.triangle;
    });
    std::vector<std::uint32_t> root(m_triangles.size());
    std::iota(root.begin(), root.end(), 0U);
    const auto find = [&](std::uint32_t i) {
        while (root[i] != i)
            i = root[i] = root[root[i]];
        return i;
    };
    for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
        if (edges[i].key != edges[i + 1].key)
            continue;
        const std::uint32_t a = find(edges[i].triangle);
        const std::uint32_t b = find(edges[i + 1].triangle);
        root[std::max(a, b)] = std::min(a, b);
    }
    // A strand in which parts touch belongs to the first of them.
    m_parts.assign(m_layouts->strandCount(m_node), kNoPart);
    m_partCount = 0;
    std::vector<std::uint32_t> partOf(m_triangles.size(), kNoPart);
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        std::uint32_t& part = partOf[find(t)];
        if (part == kNoPart)
            part = m_partCount++;
        for (const std::uint32_t corner : m_triangles[t])
            m_parts[corner] = std::min(m_parts[corner], part);
    }
}

std::vector<SectionLoop> NodeSection::outline() const
{
    if (m_isLattice || m_partCount < 2)
        return boundary({}, 0);
    std::vector<SectionLoop> loops;
    for (std::uint32_t part = 0; part < m_partCount; ++part)
        std::ranges::move(boundary(m_parts, part), std::back_inserter(loops));
    return loops;
}

std::vector<SectionLoop> NodeSection::boundary(std::span<const std::uint32_t> labels,
                                               std::uint32_t wanted) const
{
    std::vector<SectionLoop> loops =
        m_isLattice ? latticeBoundary(labels, wanted) : triangleBoundary(labels, wanted);
    for (SectionLoop& loop : loops)
        measure(loop);
    return loops;
}

void NodeSection::measure(SectionLoop& loop) const
{
    const std::span<const Vec2> places = m_layouts->places(m_node);
    float twice = 0.0F;
    for (std::size_t i = 0; i < loop.strands.size(); ++i) {
        const Vec2& a = places[loop.strands[i]];
        const Vec2& b = places[loop.strands[(i + 1) % loop.strands.size()]];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    loop.area = twice / 2.0F;
    loop.part = m_parts.empty() ? 0 : m_parts[loop.strands.front()];
}

std::vector<SectionLoop> NodeSection::latticeBoundary(std::span<const std::uint32_t> labels,
                                                      std::uint32_t wanted) const
{
    const HexLattice& lattice = m_layouts->lattice();
    const auto count = static_cast<std::uint32_t>(m_strandAt.size());
    const auto contains = [&](std::uint32_t slot) {
        return slot < count && (labels.empty() || labels[m_strandAt[slot]] == wanted);
    };
    /// Bit k: the edge to neighbour k has the wanted triangle on its left and none on its right.
    const auto edgesOf = [&](std::uint32_t slot) {
        const auto& around = lattice.neighbours(slot);
        unsigned inside = 0;
        for (unsigned k = 0; k < 6; ++k)
            inside |= contains(around[k]) ? 1U << k : 0U;
        const unsigned ahead = (inside >> 1U) | (inside << 5U);  // The next neighbour
        const unsigned behind = (inside << 1U) | (inside >> 5U); // The one before
        return inside & ahead & ~behind & 0x3fU;
    };
    std::vector<SectionLoop> loops;
    std::vector<std::uint8_t> done(count, 0); // By slot: a bit for each edge
    for (std::uint32_t first = count; first-- > 0;) {
        if (!contains(first))
            continue;
        for (unsigned open = edgesOf(first) & ~unsigned{done[first]}; open != 0; open &= open - 1) {
            const auto firstDirection = static_cast<unsigned>(std::countr_zero(open));
            if ((done[first] >> firstDirection & 1U) != 0)
                continue;
            SectionLoop& loop = loops.emplace_back();
            std::uint32_t slot = first;
            unsigned direction = firstDirection;
            do {
                done[slot] = static_cast<std::uint8_t>(done[slot] | 1U << direction);
                loop.strands.push_back(m_strandAt[slot]);
                slot = lattice.neighbours(slot)[direction];
                // Turn around the triangles at this slot until one is missing.
                const auto& around = lattice.neighbours(slot);
                unsigned next = (direction + 2) % 6;
                while (contains(around[(next + 5) % 6]))
                    next = (next + 5) % 6;
                direction = next;
            } while (slot != first || direction != firstDirection);
        }
    }
    return loops;
}

std::vector<SectionLoop> NodeSection::triangleBoundary(std::span<const std::uint32_t> labels,
                                                       std::uint32_t wanted) const
{
    std::vector<DirectedEdge> edges;
    for (std::uint32_t t = 0; t < m_triangles.size(); ++t) {
        const auto& corners = m_triangles[t];
        if (!labels.empty() &&
            (labels[corners[0]] != wanted || labels[corners[1]] != wanted || labels[corners[2]] != wanted))
            continue;
        for (std::uint32_t k = 0; k < 3; ++k)
            edges.push_back({keyOf(corners[k], corners[(k + 1) % 3]), t, k});
    }
    std::ranges::sort(edges, {}, &DirectedEdge::key);
    const auto find = [&](std::uint32_t from, std::uint32_t to) -> const DirectedEdge* {
        const auto place = std::ranges::lower_bound(edges, keyOf(from, to), {}, &DirectedEdge::key);
        return place != edges.end() && place->key == keyOf(from, to) ? &*place : nullptr;
    };
    std::vector<bool> isDone(edges.size(), false);
    std::vector<SectionLoop> loops;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto from = static_cast<std::uint32_t>(edges[i].key >> 32U);
        const auto to = static_cast<std::uint32_t>(edges[i].key);
        if (isDone[i] || find(to, from) != nullptr)
            continue;
        SectionLoop& loop = loops.emplace_back();
        const DirectedEdge* edge = &edges[i];
        do {
            isDone[static_cast<std::size_t>(edge - edges.data())] = true;
            loop.strands.push_back(static_cast<std::uint32_t>(edge->key >> 32U));
            // Turn around the triangles at the end of the edge until one is missing.
            for (;;) {
                const auto& corners = m_triangles[edge->triangle];
                const std::uint32_t end = corners[(edge->corner + 1) % 3];
                const std::uint32_t apex = corners[(edge->corner + 2) % 3];
                edge = find(end, apex);
                const DirectedEdge* const beyond = find(apex, end);
                if (beyond == nullptr)
                    break;
                edge = beyond;
            }
        } while (edge != &edges[i] && loop.strands.size() <= edges.size());
    }
    return loops;
}

} // namespace espalier
