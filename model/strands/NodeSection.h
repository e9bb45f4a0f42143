// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/strands/StrandLayouts.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace espalier {

/// A closed line of strands around others: counter-clockwise in the coordinates of the section around wood,
/// clockwise around a cavity.
struct SectionLoop {
    std::vector<std::uint32_t> strands; ///< By their numbers at the node
    float area = 0.0F;                  ///< Signed, in squared strand radii: negative for a cavity
    std::uint32_t part = 0;             ///< Number of the connected part of the section that it bounds

    bool isCavity() const { return area < 0.0F; }
};

inline constexpr std::size_t kNoCavity = std::numeric_limits<std::size_t>::max();
/// For each cavity of a section, given by its strands, the number of the one that goes on from it in the next
/// section: the first that shares a strand with it and with none before it; kNoCavity if it ends.
std::vector<std::size_t> matchCavities(std::span<const std::span<const std::uint32_t>> lower,
                                       std::span<const std::span<const std::uint32_t>> upper);

/// The cross-section of one node as an α-shape of its strands: triangles of neighbours, of which those with
/// an edge longer than α are left out (Strands 2024 §5.5). Where the strands have the slots of a lattice, the
/// triangles are those of the lattice, and none is stored.
class NodeSection {
public:
    /// @p alpha: in strand radii.
    void set(const StrandLayouts& layouts, std::uint32_t node, float alpha);

    /// Number of connected parts; strands that are part of no triangle belong to none.
    std::uint32_t partCount() const { return m_partCount; }
    /// Number of the part that each strand belongs to; kNoPart for none. Empty if all belong to part 0.
    std::span<const std::uint32_t> parts() const { return m_parts; }
    static constexpr std::uint32_t kNoPart = std::numeric_limits<std::uint32_t>::max();

    /// The boundaries of all parts.
    std::vector<SectionLoop> outline() const;
    /// The boundary of the triangles between strands with the label @p wanted; of all, if @p labels is empty.
    /// Loops that touch themselves in a strand visit it more than once.
    std::vector<SectionLoop> boundary(std::span<const std::uint32_t> labels, std::uint32_t wanted) const;
    /// Calls @p visit(a, b) for neighbours of different labels; each pair at least once.
    template <class Visit>
    void forEachSeam(std::span<const std::uint32_t> labels, Visit&& visit) const
    {
        if (m_isLattice) {
            for (std::uint32_t slot = 0; slot < m_strandAt.size(); ++slot) {
                for (int k = 0; k < 3; ++k) {
                    const std::uint32_t other =
                        m_layouts->lattice().neighbours(slot)[static_cast<std::size_t>(k)];
                    if (other < m_strandAt.size() && labels[m_strandAt[slot]] != labels[m_strandAt[other]])
                        visit(m_strandAt[slot], m_strandAt[other]);
                }
            }
            return;
        }
        for (const auto& corners : m_triangles) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (labels[corners[k]] != labels[corners[(k + 1) % 3]])
                    visit(corners[k], corners[(k + 1) % 3]);
            }
        }
    }

private:
    void findParts();
    std::vector<SectionLoop> latticeBoundary(std::span<const std::uint32_t> labels,
                                             std::uint32_t wanted) const;
    std::vector<SectionLoop> triangleBoundary(std::span<const std::uint32_t> labels,
                                              std::uint32_t wanted) const;
    void measure(SectionLoop& loop) const;

    const StrandLayouts* m_layouts = nullptr;
    std::uint32_t m_node = 0;
    bool m_isLattice = false;
    std::vector<std::uint32_t> m_strandAt; ///< By slot
    std::vector<std::array<std::uint32_t, 3>> m_triangles;
    std::vector<std::uint32_t> m_parts;
    std::uint32_t m_partCount = 1;
};

} // namespace espalier
